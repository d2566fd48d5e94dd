#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "raytracer/scene/moving_scenes.h"
#include "renderer/depth/local_scene.h"
#include "renderer/estimators/estimator.h"
#include "stimuli/definition/stimulus.h"

namespace seamline::renderer {

/// What the frames of clips are decided for, and by what.
struct ClipDecisionSubject {
  const StudyDefinition& study;                                 ///< of frames (`still_study`)
  const std::map<std::string, std::vector<Stimulus>>& stimuli;  ///< all of the study's, by truth
  MovingScenes& moving;
  std::filesystem::path set_folder;
  /// Hashes over what the pictures of a truth and of a stimulus depend on.
  std::function<std::string(const std::string& truth)> inputs_of_truth = {};
  std::function<std::string(const Stimulus&)> inputs_of_stimulus = {};
  std::function<std::unique_ptr<SceneEstimator>(const TruthScene&)> estimator_of = {};
  std::function<LocalScene(const TruthScene&, const SceneEstimator&, const Stimulus&)> depth_of = {};
  std::vector<Stimulus> wanted = {};                       ///< the frames that are rendered
  std::function<void(const std::string& what)> tell = {};  ///< that something is at work
};

/// How clips are sampled where an error is asked for (`--error`): once for all frames, or noise that stands
/// still would flicker. Truths that are frames of one clip are a group, and so are stimuli. Four frames of a
/// group, evenly in its order, are sampled in rounds as stills are; of each block the most samples that one
/// of them came to are taken in every frame, and light is filtered as in the one that filters least. What was
/// decided lies in `SET/records/decision-NAME.json`, so that whoever goes on, and other pieces of the job,
/// need not decide again; the same is decided by all.
class ClipDecisions {
 public:
  ClipDecisions(const StudyDefinition& shown, ClipDecisionSubject subject);
  ~ClipDecisions();
  ClipDecisions(const ClipDecisions&) = delete;
  ClipDecisions& operator=(const ClipDecisions&) = delete;

  [[nodiscard]] const PhotographDecision& of_truth(const std::string& truth);
  /// Has the estimator of a frame sample as was decided, beside the base of its clip.
  void hold(SceneEstimator& estimator, const std::string& truth);
  [[nodiscard]] const StimulusDecision& of_stimulus(const std::string& id);

 private:
  /// The frame beside which the others of its clip are sampled (`SceneEstimator::frame_base`), of a clip
  /// with more frames than those that decide; null: none.
  [[nodiscard]] std::shared_ptr<const FrameBase> base_of(const std::string& truth);
  struct Group {
    std::string name;
    std::vector<std::string> members;
    std::string inputs = {};
  };
  struct Deciding;

  Deciding& open(const Group& truths);
  void decide_stimuli(const Group& truths);
  void decide_mesh(Deciding& deciding, std::size_t frame, const std::vector<Stimulus>& of_mesh);

  ClipDecisionSubject subject_;
  std::map<std::string, SceneDefinition> scenes_;  ///< by truth
  std::vector<Group> truth_groups_, stimulus_groups_;
  std::map<std::string, std::size_t> group_of_truth_, group_of_stimulus_;
  std::map<std::string, std::string> truth_of_stimulus_;
  std::vector<std::vector<std::string>> deciding_;       ///< truths, of each group of truths
  std::map<std::string, PhotographDecision> of_truths_;  ///< by the group's name
  std::map<std::string, StimulusDecision> of_stimuli_;
  std::size_t group_of_base_ = 0;
  std::shared_ptr<const FrameBase> base_;  ///< the last one
  std::unique_ptr<Deciding> open_;         ///< of the group that was decided last
};

/// Which members of a group decide: `most` of them at most, evenly, or all.
[[nodiscard]] std::vector<std::string> evenly(const std::vector<std::string>& members, std::size_t most);

}  // namespace seamline::renderer
