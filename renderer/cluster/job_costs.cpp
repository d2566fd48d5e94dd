#include "renderer/cluster/job_costs.h"

#include <sys/resource.h>

#include <fmt/core.h>
#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>
#include <vector>

#include "renderer/common/stopwatch.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"

namespace seamline::renderer {
namespace {

constexpr std::array<int, 2> probe_spp = {2, 8};
constexpr int most_planned_spp = 4096;
/// Where an error is asked for that the probe has no estimate of.
constexpr int usual_spp = 64;

std::string artifact_and_condition(const Stimulus& stimulus) {
  return truth_of(stimulus) + "/" + std::string(word(stimulus.artifact)) + "/" + stimulus.condition;
}

/// Pieces of a small render, by their names in `timings.json`.
struct ProbedPiece {
  double seconds = 0;
  std::optional<double> worst_tile = {};
};
using ProbedPieces = std::map<std::string, ProbedPiece>;

ProbedPieces read_pieces(const std::filesystem::path& set_folder) {
  ProbedPieces pieces;
  const auto json = nlohmann::json::parse(read_file(set_folder / "timings.json"));
  for (const auto& [name, line] : json.at("pieces").items()) {
    pieces[name].seconds = line.at("seconds").get<double>();
    if (line.contains("worst_tile")) pieces[name].worst_tile = line["worst_tile"].get<double>();
  }
  return pieces;
}

/// Of stimuli in study order: what the probe renders of one truth.
std::set<std::string> probed_ids(const std::vector<Stimulus>& stimuli, const std::string& truth) {
  std::map<std::string, std::vector<std::string>> groups;
  for (const Stimulus& stimulus : stimuli)
    if (truth_of(stimulus) == truth && stimulus.object_index == stimuli.front().object_index)
      groups[artifact_and_condition(stimulus)].push_back(stimulus_id(stimulus));
  std::set<std::string> ids;
  for (const auto& [name, of_group] : groups) ids.insert({of_group.front(), of_group.back()});
  return ids;
}

double peak_memory_bytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// The two probes of one truth.
struct ProbedTruth {
  std::array<ProbedPieces, 2> pieces;
  std::array<double, 2> seconds = {};
  double samples = 0;  ///< a pixel, that the real render is going to take

  /// A piece's seconds with that many samples.
  [[nodiscard]] std::optional<double> scaled(const std::string& name) const {
    const auto few = pieces[0].find(name), more = pieces[1].find(name);
    if (few == pieces[0].end() || more == pieces[1].end()) return std::nullopt;
    const double slope =
        std::max(0.0, (more->second.seconds - few->second.seconds) / (probe_spp[1] - probe_spp[0]));
    return std::max(0.0, more->second.seconds + slope * (samples - probe_spp[1]));
  }
};

/// Samples a pixel of the real render.
double samples_wanted(const StudyDefinition& study, const RenderRequest& request,
                      const ProbedPieces& pieces) {
  if (!request.error) return request.spp.value_or(study.samples_per_pixel);
  double most = 0;
  for (const auto& [name, piece] : pieces)
    if (piece.worst_tile) {
      // A worst tile may have three times the error that is asked for, and error falls with the root.
      const double factor = *piece.worst_tile / (3 * *request.error);
      most = std::max(most, probe_spp[1] * factor * factor);
    }
  return std::clamp(most > 0 ? most : usual_spp, 16.0, double{most_planned_spp});
}

ProbedTruth probe(const StudyDefinition& study, const RenderRequest& request,
                  const std::set<std::string>& ids) {
  ProbedTruth probed;
  for (std::size_t i = 0; i < probe_spp.size(); ++i) {
    const TemporaryFolder folder;
    RenderRequest small = request;
    small.set_folder = folder / "set";
    small.spp = probe_spp[i];
    small.error.reset();
    small.ids = ids;
    small.layers = small.contact_sheet = false;
    const Stopwatch watch;
    render_set(study, small);
    probed.seconds[i] = watch.seconds();
    probed.pieces[i] = read_pieces(small.set_folder);
  }
  probed.samples = samples_wanted(study, request, probed.pieces[1]);
  return probed;
}

/// Mean of what is known; 0 of nothing.
double mean_of(const std::map<std::string, double>& known) {
  double sum = 0;
  for (const auto& [name, seconds] : known) sum += seconds;
  return known.empty() ? 0 : sum / static_cast<double>(known.size());
}

/// From the first level to the last by their places.
double between(double first, double last, std::size_t place, std::size_t count) {
  if (count < 2) return first;
  const double share = static_cast<double>(place) / static_cast<double>(count - 1);
  return first + share * (last - first);
}

/// Ends known, those between interpolated; groups whose ends are not known take the mean.
void fill_in(const std::map<std::string, std::vector<std::string>>& groups,
             const std::map<std::string, double>& measured, std::map<std::string, double>& out) {
  const double usual = mean_of(measured);
  for (const auto& [name, ids] : groups) {
    const auto first = measured.find(ids.front()), last = measured.find(ids.back());
    for (std::size_t i = 0; i < ids.size(); ++i)
      out[ids[i]] = first == measured.end() || last == measured.end()
                        ? usual
                        : between(first->second, last->second, i, ids.size());
  }
}

}  // namespace

JobCosts measure_costs(const StudyDefinition& study, const RenderRequest& request, double budget_s) {
  const Stopwatch watch;
  std::vector<Stimulus> stimuli;
  for (const Stimulus& stimulus : list_stimuli(study))
    if (matches_pattern(stimulus_id(stimulus), request.only)) stimuli.push_back(stimulus);
  JobCosts costs;
  std::map<std::string, double> by_group_end, mesh_by_group_end;
  std::vector<double> starts;
  double most_samples = 0;
  for (const SceneDefinition& scene : list_truths(study)) {
    const std::string& truth = scene.truth;
    const std::set<std::string> ids = probed_ids(stimuli, truth);
    if (ids.empty() || (!costs.truths.empty() && watch.seconds() > budget_s)) continue;
    const ProbedTruth probed = probe(study, request, ids);
    most_samples = std::max(most_samples, probed.samples);
    double inside = 0;
    for (const auto& [name, piece] : probed.pieces[0]) inside += piece.seconds;
    starts.push_back(std::max(0.0, probed.seconds[0] - inside));
    costs.truths[truth] = probed.scaled("reference-" + truth).value_or(0);
    for (const Stimulus& stimulus : stimuli) {
      const std::string id = stimulus_id(stimulus);
      if (!ids.contains(id)) continue;
      by_group_end[id] = probed.scaled(id).value_or(0);
      const std::string mesh =
          fmt::format("mesh-{}-{}-{:04}", truth, stimulus.object, stimulus.depth.width_px);
      if (const auto found = probed.pieces[1].find(mesh); found != probed.pieces[1].end())
        mesh_by_group_end[id] = found->second.seconds;
    }
  }
  // What was not probed: other truths by the mean of all, other objects as the first.
  const double usual_truth = mean_of(costs.truths);
  for (const SceneDefinition& scene : list_truths(study)) costs.truths.emplace(scene.truth, usual_truth);
  std::map<std::string, std::vector<std::string>> first_objects;
  std::map<std::string, std::vector<std::string>> by_object;
  for (const Stimulus& stimulus : stimuli)
    by_object[artifact_and_condition(stimulus) + "/" + stimulus.object].push_back(stimulus_id(stimulus));
  std::map<std::string, std::string> first_object_of;
  for (const Stimulus& stimulus : stimuli)
    first_object_of.emplace(artifact_and_condition(stimulus), stimulus.object);
  for (const auto& [group, object] : first_object_of)
    first_objects[group] = by_object.at(group + "/" + object);
  fill_in(first_objects, by_group_end, costs.stimuli);
  fill_in(first_objects, mesh_by_group_end, costs.meshes);
  for (const Stimulus& stimulus : stimuli) {
    const std::string group = artifact_and_condition(stimulus), id = stimulus_id(stimulus);
    const std::vector<std::string>&own = by_object.at(group + "/" + stimulus.object),
          &first = first_objects.at(group);
    const auto place = static_cast<std::size_t>(std::find(own.begin(), own.end(), id) - own.begin());
    const std::string& same = first[std::min(place, first.size() - 1)];
    costs.stimuli.emplace(id, costs.stimuli.at(same));
    costs.meshes.emplace(id, costs.meshes.at(same));
  }
  for (const double start : starts) costs.start = std::max(costs.start, start);
  int widest_px = study.width_px;  // with all eyes side by side
  for (const SceneDefinition& truth : list_truths(study))
    widest_px = std::max(widest_px, truth.view.eyes() * study.width_px / truth.view.squeeze());
  // A byte a sample and pixel is the most that more samples take.
  costs.memory_bytes = static_cast<std::int64_t>(
      1.3 * (peak_memory_bytes() + most_samples * widest_px * static_cast<double>(study.height_px)));
  costs.measured_s = watch.seconds();
  return costs;
}

}  // namespace seamline::renderer
