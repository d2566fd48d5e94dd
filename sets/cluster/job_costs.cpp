#include "sets/cluster/job_costs.h"

#include <sys/resource.h>

#include <fmt/core.h>
#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>
#include <vector>

#include "raytracer/common/stopwatch.h"
#include "sets/set_work.h"
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
std::vector<Stimulus> probed_of(const std::vector<Stimulus>& stimuli, const std::string& truth) {
  std::map<std::string, std::vector<Stimulus>> groups;
  for (const Stimulus& stimulus : stimuli)
    if (truth_of(stimulus) == truth && stimulus.object_index == stimuli.front().object_index)
      groups[artifact_and_condition(stimulus)].push_back(stimulus);
  std::vector<Stimulus> ends;
  for (const auto& [name, of_group] : groups) {
    ends.push_back(of_group.front());
    if (of_group.size() > 1) ends.push_back(of_group.back());
  }
  return ends;
}

double peak_memory_bytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * usage.ru_maxrss;
}

/// Cost of so many samples a pixel, in the cost of one: what a picture takes besides is about that of eight.
double cost_of(double samples) {
  return 8 + samples;
}

/// The one or two probes of a truth.
struct ProbedTruth {
  std::vector<ProbedPieces> pieces;  ///< with `probe_spp` samples
  double start_s = 0;                ///< of a process, besides its pieces
  double samples = 0;                ///< a pixel, that the real render is going to take

  /// A piece's seconds with that many samples.
  [[nodiscard]] std::optional<double> scaled(const std::string& name) const {
    const auto few = pieces.front().find(name), more = pieces.back().find(name);
    if (few == pieces.front().end() || more == pieces.back().end()) return std::nullopt;
    if (pieces.size() == 1) return few->second.seconds * cost_of(samples) / cost_of(probe_spp[0]);
    const double slope =
        std::max(0.0, (more->second.seconds - few->second.seconds) / (probe_spp[1] - probe_spp[0]));
    return std::max(0.0, more->second.seconds + slope * (samples - probe_spp[1]));
  }
  /// Seconds of what takes no samples.
  [[nodiscard]] std::optional<double> unscaled(const std::string& name) const {
    const auto found = pieces.back().find(name);
    return found == pieces.back().end() ? std::nullopt : std::optional(found->second.seconds);
  }
};

/// Samples a pixel of the real render, from a probe with `spp` of them.
double samples_wanted(const StudyDefinition& study, const RenderRequest& request, const ProbedPieces& pieces,
                      int spp) {
  if (!request.error) return request.spp.value_or(study.samples_per_pixel);
  double most = 0;
  for (const auto& [name, piece] : pieces)
    if (piece.worst_tile) {
      // A worst tile may have three times the error that is asked for, and error falls with the root.
      const double factor = *piece.worst_tile / (3 * *request.error);
      most = std::max(most, spp * factor * factor);
    }
  return std::clamp(most > 0 ? most : usual_spp, 16.0, double{most_planned_spp});
}

/// What a render of these stimuli costs with so many samples, in units of its own.
double cost_of(const std::vector<Stimulus>& stimuli, const RenderRequest& request, double samples) {
  SetWork work;
  for (const Stimulus& stimulus : stimuli) work.pending.push_back({stimulus, {}});
  return total_weight(work, work_weights(request.estimator)) * cost_of(samples);
}

/// Decides what is probed: the first samples always, further ones while all together cost a small share of
/// the render. Costs are counted, not measured, so that the same job is written twice from the same probes.
class Probe {
 public:
  Probe(const StudyDefinition& study, const RenderRequest& request, const std::vector<Stimulus>& stimuli)
      : study_(study), request_(request), stimuli_(stimuli) {}

  /// Whether these stimuli may be rendered with so many samples.
  [[nodiscard]] bool may_take(const std::vector<Stimulus>& some, int spp) const {
    return spent_ == 0 ||
           spent_ + cost_of(some, request_, spp) <= most_share_probed * cost_of(stimuli_, request_, samples_);
  }

  ProbedTruth take(const std::vector<Stimulus>& some) {
    ProbedTruth probed;
    for (const int spp : probe_spp) {
      if (!probed.pieces.empty() && !may_take(some, spp)) break;
      const TemporaryFolder folder;
      RenderRequest small = request_;
      small.set_folder = folder / "set";
      small.spp = spp;
      small.error.reset();
      for (const Stimulus& stimulus : some) small.ids.insert(stimulus_id(stimulus));
      small.layers = small.contact_sheet = false;
      const Stopwatch watch;
      render_set(study_, small);
      const double seconds = watch.seconds();
      spent_ += cost_of(some, request_, spp);
      probed.pieces.push_back(read_pieces(small.set_folder));
      double inside = 0;
      for (const auto& [name, piece] : probed.pieces.back()) inside += piece.seconds;
      if (probed.pieces.size() == 1) probed.start_s = std::max(0.0, seconds - inside);
      samples_ = probed.samples = samples_wanted(study_, request_, probed.pieces.back(), spp);
    }
    return probed;
  }

  /// Of the render, rendered by the probe.
  [[nodiscard]] double share() const { return spent_ / cost_of(stimuli_, request_, samples_); }

 private:
  static constexpr double most_share_probed = 0.2;

  const StudyDefinition& study_;
  const RenderRequest& request_;
  const std::vector<Stimulus>& stimuli_;
  double spent_ = 0;
  double samples_ = usual_spp;  ///< of the render; known after the first probe
};

/// Mean of what is known; 0 of nothing.
double mean_of(const std::map<std::string, double>& known) {
  double sum = 0;
  for (const auto& [name, seconds] : known) sum += seconds;
  return known.empty() ? 0 : sum / known.size();
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
  double most_samples = 0;
  Probe probe(study, request, stimuli);
  for (const SceneDefinition& scene : list_truths(study)) {
    const std::string& truth = scene.truth;
    const std::vector<Stimulus> some = probed_of(stimuli, truth);
    if (some.empty() || !probe.may_take(some, probe_spp[0]) ||
        (!costs.truths.empty() && watch.seconds() > budget_s))
      continue;
    const ProbedTruth probed = probe.take(some);
    most_samples = std::max(most_samples, probed.samples);
    costs.start = std::max(costs.start, probed.start_s);
    costs.truths[truth] = probed.scaled("reference-" + truth).value_or(0);
    for (const Stimulus& stimulus : some) {
      const std::string id = stimulus_id(stimulus);
      by_group_end[id] = probed.scaled(id).value_or(0);
      const std::string mesh =
          fmt::format("mesh-{}-{}-{:04}", truth, stimulus.object, stimulus.depth.width_px);
      if (const auto seconds = probed.unscaled(mesh)) mesh_by_group_end[id] = *seconds;
    }
  }
  costs.share_probed = probe.share();
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
  int widest_px = study.width_px;  // with all eyes side by side
  for (const SceneDefinition& truth : list_truths(study))
    widest_px = std::max(widest_px, truth.view.eyes() * study.width_px / truth.view.squeeze());
  // A byte a sample and pixel is the most that more samples take.
  costs.memory_bytes =
      static_cast<std::int64_t>(1.3 * (peak_memory_bytes() + most_samples * widest_px * study.height_px));
  costs.measured_s = watch.seconds();
  return costs;
}

}  // namespace seamline::renderer
