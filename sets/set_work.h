#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "renderer/transport/answers.h"
#include "sets/render_set.h"
#include "sets/sharing/work_list.h"
#include "support/text/error.h"

namespace seamline::renderer {

/// A stimulus to render, and the hash of what its picture depends on.
struct PendingStimulus {
  Stimulus stimulus;
  std::string inputs;
};

/// What a render job has to do.
struct SetWork {
  std::vector<PendingStimulus> pending;
  /// Places in `pending`, by truth and object's number from 1.
  std::map<std::pair<std::string, int>, std::vector<std::size_t>> of_object;
  std::set<std::string> selected_truths;  ///< that some stimulus asked for belongs to
  int already_finished = 0;

  [[nodiscard]] bool is_pending(const std::string& truth) const;
};

/// That no stimulus of the study matches `--only`.
[[nodiscard]] InputError no_such_stimulus(const StudyDefinition& study, const std::string& only);

/// Throws InputError naming the first stimulus that is left to render.
void require_nothing_pending(const SetWork& work, const std::filesystem::path& set_folder);

/// Stimuli that match `--only`, belong to this shard and are not finished. Shards share out the virtual
/// objects of all scenes, because stimuli of one object share its truth. Throws InputError when the pattern
/// matches none.
[[nodiscard]] SetWork find_work(const StudyDefinition& study, const RenderRequest& request,
                                const InputHashes& hashes, const SetRecords& records);

/// What a job makes that renders the stimuli that match `only`: these, and the references of their truths.
[[nodiscard]] WorkList list_work(const StudyDefinition& study, const std::string& only,
                                 const InputHashes& hashes, const std::string& job);

/// Stimuli by the name of their truth.
using StimuliOfTruths = std::map<std::string, std::vector<Stimulus>>;
/// All stimuli of a study. Listing them takes as long as there are scenes, so it is done once.
[[nodiscard]] StimuliOfTruths stimuli_of_truths(const StudyDefinition& study);

/// What any stimulus of a truth asks of the depth mesh. `of_truth` are all of the study's, not those left to
/// render: a set that was interrupted has the same bytes.
[[nodiscard]] Answers asked_of_depth(const std::vector<Stimulus>& of_truth);

/// What is to be rendered of one object of a truth, by the depth mesh that it is rendered with: of the same
/// settings, captured of the same scene.
[[nodiscard]] std::vector<std::vector<PendingStimulus>> by_mesh(const SetWork& work,
                                                                const StudyDefinition& study,
                                                                const std::string& truth, int object_index);

/// Stimuli of one truth, object and depth mesh by what is seen of them: conditions that differ only in what
/// people are asked, or told, show the same picture, which is rendered once.
[[nodiscard]] std::vector<std::vector<PendingStimulus>> by_picture(const std::vector<PendingStimulus>& works);

/// Weights of the progress bar, about seconds: the fast estimator does most of its work once a scene.
struct WorkWeights {
  double reference = 0, truth = 0, mesh = 0, stimulus = 0;
};
[[nodiscard]] WorkWeights work_weights(Estimator estimator);
[[nodiscard]] double total_weight(const SetWork& work, const WorkWeights& weights);

}  // namespace seamline::renderer
