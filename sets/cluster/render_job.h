#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sets/cluster/job_costs.h"
#include "sets/render_set.h"

namespace seamline::renderer {

/// A piece of a job that one process does: some stimuli of one truth.
struct JobElement {
  std::string truth;
  std::vector<std::string> ids;  ///< stimuli, in the order of the study
  double seconds = 0;            ///< estimated
};

/// A truth that one process makes for all elements.
struct JobTruth {
  std::string name;
  double seconds = 0;  ///< estimated
};

/// A study's render cut into pieces that run at once on many machines: first every truth, then the elements,
/// then `join`, which renders nothing and writes the manifest. The set is, byte for byte, that of one
/// process.
struct RenderJob {
  std::string study_name;
  std::string program_version, instruction_set;
  std::string inputs;  ///< hash of everything that the set's pictures depend on
  int threads = 1;     ///< of each process
  std::int64_t memory_bytes = 0;
  std::vector<JobTruth> truths;
  std::vector<JobElement> elements;

  /// Of the longest piece of a stage: what a cluster's time limit is made from.
  [[nodiscard]] double longest_truth_s() const;
  [[nodiscard]] double longest_element_s() const;
};

/// More are refused: Slurm's usual MaxArraySize is 1001.
inline constexpr int most_elements = 1000;

/// Cuts a render into `elements` pieces (0: of about ten minutes each) whose estimated times are as even as
/// stimuli that share a depth mesh allow: neighbours stay together, because they share truth, object and
/// mesh, and the longest piece is as short as it can be. Throws InputError when there is nothing to render.
[[nodiscard]] RenderJob plan_job(const StudyDefinition& study, const RenderRequest& request,
                                 const JobCosts& costs, int elements);

/// `FOLDER/job.json`.
void write_job(const std::filesystem::path& folder, const RenderJob& job);
[[nodiscard]] RenderJob read_job(const std::filesystem::path& folder);

/// What the process is to do that is called `truth-N`, `stimuli-N` or `join`, put into the request. Throws
/// InputError when the job has no such piece, or when this program, this machine's instruction set, the
/// study's files or its list of stimuli are not those that the job was made with.
void take_element(const RenderJob& job, const std::filesystem::path& folder, const std::string& element,
                  const StudyDefinition& study, RenderRequest& request);

/// Says in the set, where `job status` finds it, why a piece ended. Does nothing where the job has no such
/// piece, or where the set is another job's or cannot be written to.
void leave_refusal(const std::filesystem::path& set_folder, const std::filesystem::path& job_folder,
                   const std::string& element, const std::string& complaint);

}  // namespace seamline::renderer
