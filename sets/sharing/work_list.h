#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace seamline::renderer {

/// What a job is going to make of a set: names, each with the hash of what it is made from.
/// `SET/records/work.json`, for `seamline job status`; no render reads it.
struct WorkList {
  struct Stimulus {
    std::string id, inputs, truth;
  };
  struct Reference {
    std::string truth, inputs;
  };
  std::string study;
  std::string job;  ///< the job's folder; empty in lists of older versions
  std::vector<Stimulus> stimuli;
  std::vector<Reference> references;
};

/// Left alone where it says the same already.
void write_work_list(const std::filesystem::path& set_folder, const WorkList& list);

/// None where there is no such file. Throws InputError naming it when it is damaged.
[[nodiscard]] std::optional<WorkList> read_work_list(const std::filesystem::path& set_folder);

}  // namespace seamline::renderer
