#include "sets/cluster/render_job.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "raytracer/tracing/ray_device.h"
#include "sets/sharing/set_running.h"
#include "sets/sharing/work_list.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/text/error.h"
#include "support/text/request_name.h"
#include "support/text/text_bounds.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

/// What an element takes when nobody says how many there are.
constexpr double usual_element_s = 600;

/// Stimuli that share a depth mesh: never cut apart.
struct MeshGroup {
  std::vector<std::string> ids;
  double seconds = 0;
};

/// The groups of a truth, in the order they are rendered in.
std::vector<MeshGroup> mesh_groups(const std::vector<Stimulus>& stimuli, const std::string& truth,
                                   const JobCosts& costs) {
  std::map<std::pair<int, DepthSettings>, MeshGroup> groups;
  for (const Stimulus& stimulus : stimuli) {
    if (truth_of(stimulus) != truth) continue;
    const std::string id = stimulus_id(stimulus);
    MeshGroup& group = groups[{stimulus.object_index, stimulus.depth}];
    if (group.ids.empty()) group.seconds += costs.meshes.at(id);
    group.ids.push_back(id);
    group.seconds += costs.stimuli.at(id);
  }
  std::vector<MeshGroup> out;
  for (auto& [key, group] : groups) out.push_back(std::move(group));
  return out;
}

/// Neighbouring groups together, none longer than `most_s` unless one group is.
std::vector<JobElement> cut(const std::vector<std::pair<std::string, std::vector<MeshGroup>>>& truths,
                            double start_s, double most_s) {
  std::vector<JobElement> out;
  for (const auto& [truth, groups] : truths) {
    bool first = true;
    for (const MeshGroup& group : groups) {
      if (first || out.back().seconds + group.seconds > most_s)
        out.push_back({.truth = truth, .ids = {}, .seconds = start_s});
      first = false;
      out.back().ids.insert(out.back().ids.end(), group.ids.begin(), group.ids.end());
      out.back().seconds += group.seconds;
    }
  }
  return out;
}

double longest(const std::vector<double>& seconds) {
  return seconds.empty() ? 0 : *std::max_element(seconds.begin(), seconds.end());
}

std::vector<Stimulus> asked_stimuli(const StudyDefinition& study, const RenderRequest& request) {
  std::vector<Stimulus> stimuli;
  for (const Stimulus& stimulus : list_stimuli(study))
    if (matches_pattern(stimulus_id(stimulus), request.only)) stimuli.push_back(stimulus);
  return stimuli;
}

/// A study that lost or got a level, an artifact or a condition: `join` would wait for what no piece renders,
/// or leave out what they did.
void require_same_stimuli(const RenderJob& job, const fs::path& folder, const StudyDefinition& study,
                          const RenderRequest& request) {
  std::set<std::string> of_job, of_study, others;
  for (const JobElement& element : job.elements) of_job.insert(element.ids.begin(), element.ids.end());
  for (const Stimulus& stimulus : asked_stimuli(study, request)) of_study.insert(stimulus_id(stimulus));
  std::set_symmetric_difference(of_job.begin(), of_job.end(), of_study.begin(), of_study.end(),
                                std::inserter(others, others.end()));
  if (others.empty()) return;
  throw input_error(
      {.file = (folder / "job.json").string(),
       .wanted = fmt::format("the {} stimuli that the job was made with", of_job.size()),
       .found = fmt::format("{} in {}, where {} {}: make the job again", of_study.size(), study.file.string(),
                            *others.begin(), of_job.contains(*others.begin()) ? "is missing" : "is new")});
}

/// The number from 1 to `count` that follows the word in a piece's name; 0: none.
std::size_t number_after(const std::string& word, const std::string& element, std::size_t count) {
  if (!element.starts_with(word)) return 0;
  for (std::size_t i = 1; i <= count; ++i)
    if (element == word + std::to_string(i)) return i;
  return 0;
}

bool has_piece(const RenderJob& job, const std::string& element) {
  return element == "join" || number_after("truth-", element, job.truths.size()) > 0 ||
         number_after("stimuli-", element, job.elements.size()) > 0;
}

InputError wrong_machine(const fs::path& folder, const std::string& what, const std::string& wanted,
                         const std::string& found) {
  return input_error({.file = (folder / "job.json").string(),
                      .wanted = what + " that the job was made with (" + wanted + ")",
                      .found = found});
}

}  // namespace

double RenderJob::longest_truth_s() const {
  std::vector<double> seconds;
  for (const JobTruth& truth : truths) seconds.push_back(truth.seconds);
  return longest(seconds);
}

double RenderJob::longest_element_s() const {
  std::vector<double> seconds;
  for (const JobElement& element : elements) seconds.push_back(element.seconds);
  return longest(seconds);
}

RenderJob plan_job(const StudyDefinition& study, const RenderRequest& request, const JobCosts& costs,
                   int elements) {
  const std::vector<Stimulus> stimuli = asked_stimuli(study, request);
  RenderJob job{.study_name = study.name,
                .program_version = program_version(),
                .instruction_set = RayDevice::instruction_set(),
                .inputs = InputHashes(study, render_settings(study, request)).of_set(),
                .threads = request.threads,
                .memory_bytes = costs.memory_bytes,
                .truths = {},
                .elements = {}};
  std::vector<std::pair<std::string, std::vector<MeshGroup>>> truths;
  double all_s = 0, longest_group_s = 0;
  int groups = 0;
  for (const SceneDefinition& scene : list_truths(study)) {
    std::vector<MeshGroup> of_truth = mesh_groups(stimuli, scene.truth, costs);
    if (of_truth.empty()) continue;
    for (const MeshGroup& group : of_truth) {
      all_s += group.seconds;
      longest_group_s = std::max(longest_group_s, group.seconds);
      ++groups;
    }
    job.truths.push_back({.name = scene.truth, .seconds = costs.start + costs.truths.at(scene.truth)});
    truths.emplace_back(scene.truth, std::move(of_truth));
  }
  const int least = static_cast<int>(truths.size());
  if (elements == 0)
    elements = std::clamp(static_cast<int>(std::ceil(all_s / usual_element_s)), least, most_elements);
  elements = std::min(elements, groups);
  if (elements < least)
    throw input_error({.field = request_name("elements"),
                       .wanted = fmt::format("at least {}, one for each truth of the study", least),
                       .found = fmt::format("{}", elements)});
  // The shortest longest element: between the longest group alone and everything.
  double low = longest_group_s, high = all_s;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (static_cast<int>(cut(truths, 0, middle).size()) <= elements ? high : low) = middle;
  }
  job.elements = cut(truths, 0, high);
  for (JobElement& element : job.elements) element.seconds += costs.start;
  return job;
}

void write_job(const fs::path& folder, const RenderJob& job) {
  Json json = {{"study", job.study_name},
               {"program", {{"version", job.program_version}, {"instruction_set", job.instruction_set}}},
               {"inputs", job.inputs},
               {"threads", job.threads},
               {"memory_bytes", job.memory_bytes},
               {"truths", Json::array()},
               {"elements", Json::array()}};
  for (const JobTruth& truth : job.truths)
    json["truths"].push_back({{"name", truth.name}, {"seconds", truth.seconds}});
  for (const JobElement& element : job.elements)
    json["elements"].push_back(
        {{"truth", element.truth}, {"seconds", element.seconds}, {"stimuli", element.ids}});
  write_file_atomically(folder / "job.json", json.dump(1) + "\n");
}

RenderJob read_job(const fs::path& folder) {
  const fs::path path = folder / "job.json";
  const std::string text = read_file(path);
  require_bounded_json(text, path.string());
  RenderJob job;
  try {
    const Json json = Json::parse(text);
    job.study_name = json.at("study").get<std::string>();
    job.program_version = json.at("program").at("version").get<std::string>();
    job.instruction_set = json.at("program").at("instruction_set").get<std::string>();
    job.inputs = json.at("inputs").get<std::string>();
    job.threads = json.at("threads").get<int>();
    job.memory_bytes = json.at("memory_bytes").get<std::int64_t>();
    for (const Json& truth : json.at("truths"))
      job.truths.push_back({truth.at("name").get<std::string>(), truth.at("seconds").get<double>()});
    for (const Json& element : json.at("elements"))
      job.elements.push_back({element.at("truth").get<std::string>(),
                              element.at("stimuli").get<std::vector<std::string>>(),
                              element.at("seconds").get<double>()});
  } catch (const Json::exception&) {
    throw input_error({.file = path.string(),
                       .wanted = "a job that `seamline job write` wrote",
                       .found = "something else"});
  }
  return job;
}

void take_element(const RenderJob& job, const fs::path& folder, const std::string& element,
                  const StudyDefinition& study, RenderRequest& request) {
  if (job.program_version != program_version())
    throw wrong_machine(folder, "the version of Seamline", job.program_version, program_version());
  if (job.instruction_set != RayDevice::instruction_set())
    throw wrong_machine(folder, "a machine with the instruction set", job.instruction_set,
                        RayDevice::instruction_set() + ": its pictures would differ in their last bits");
  if (job.study_name != study.name)
    throw wrong_machine(folder, "the study", job.study_name, study.name + ": make the job again");
  if (job.inputs != InputHashes(study, render_settings(study, request)).of_set())
    throw wrong_machine(folder, "the study, scene files and program", job.study_name,
                        "others: make the job again");
  require_same_stimuli(job, folder, study, request);
  request.element = element;
  request.job = fs::absolute(folder).string();
  if (element == "join") {
    request.part = JobPart::join;
    return;
  }
  if (const std::size_t i = number_after("truth-", element, job.truths.size()); i > 0) {
    request.part = JobPart::truth;
    request.truth = job.truths[i - 1].name;
    return;
  }
  if (const std::size_t i = number_after("stimuli-", element, job.elements.size()); i > 0) {
    request.part = JobPart::stimuli;
    request.ids = {job.elements[i - 1].ids.begin(), job.elements[i - 1].ids.end()};
    return;
  }
  throw input_error({.field = request_name("element"),
                     .wanted = fmt::format("truth-1 to truth-{}, stimuli-1 to stimuli-{}, or join",
                                           job.truths.size(), job.elements.size()),
                     .found = "\"" + element + "\""});
}

void leave_refusal(const fs::path& set_folder, const fs::path& job_folder, const std::string& element,
                   const std::string& complaint) {
  try {
    const RenderJob job = read_job(job_folder);
    const std::optional<WorkList> list = read_work_list(set_folder);
    if (has_piece(job, element) && list && list->job == fs::absolute(job_folder).string())
      leave_complaint(set_folder, element, complaint);
  } catch (const InputError&) {
    // The complaint itself goes to standard error, and thus into the piece's log.
  }
}

}  // namespace seamline::renderer
