#include "analysis/foresight/predict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "analysis/detection/detection_comparison.h"
#include "analysis/foresight/assumed_people.h"
#include "analysis/thresholds/paper_values.h"
#include "stimuli/set/manifest_pictures.h"
#include "study/observers/observer.h"
#include "study/trials/rendered_set.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::analysis {
namespace {

struct CellSums {
  double difference = 0, noticeability = 0;
  int count = 0;
};

/// What people are expected to answer on average to a visible difference: noticeability, or the share who
/// see it.
double expected_mean(const ObserverDefinition& observer, double difference, const PlannedTask& task) {
  if (task.asks_as_paper()) return study::expected_noticeability_of_difference(observer, difference);
  const PlannedPopulation population{.observer = observer, .assumed = {}, .axis = {}, .task = task};
  const PlannedCurve half_at_1{.artifact = {}, .condition = {}, .midpoint = 1};
  return mean_noticeability(population, half_at_1, -std::log2(observer.image_gain.value() * difference),
                            task.facts.rates ? JointMean::as_counted : JointMean::detected);
}

/// The floors that a set of `none` stimuli tells.
DifferenceFloors floors_of(const std::filesystem::path& none_set, double ppd, int threads) {
  if (none_set.empty()) return {};
  const Manifest manifest = read_manifest(none_set);
  check_manifest_pictures(none_set, manifest);
  const DifferenceFloors floors =
      difference_floors(manifest, visible_differences(none_set, manifest, ppd, {}, threads));
  if (floors.empty())
    throw input_error({.file = (none_set / "manifest.json").string(),
                       .field = "stimuli",
                       .wanted = "stimuli of the artifact none",
                       .found = "none of them"});
  return floors;
}

/// log2 of the receiver artifact's PT; infinite when its curve is above or below the level everywhere.
double receiver_threshold(const Manifest& manifest, const VisibleDifferences& differences,
                          const ObserverDefinition& observer) {
  for (const PredictedArtifact& artifact : predict_artifacts(manifest, differences, observer)) {
    if (artifact.artifact != Artifact::receiver) continue;
    std::vector<double> widths;
    for (const PredictedCell& cell : artifact.cells) widths.push_back(std::log2(cell.level));
    return largest_x_at(perceptual_level, widths, artifact.thresholds.isotonic.value);
  }
  throw input_error({.field = "the gain",
                     .wanted = request_name("gain") +
                               ", observer.image_gain, or a set with the artifact receiver to fix it on",
                     .found = "none of them"});
}

SceneSpread spread_of(Artifact artifact, const char* quantity, const std::vector<CurveThresholds>& curves,
                      ThresholdEstimate CurveThresholds::*threshold) {
  SceneSpread spread{.artifact = artifact, .quantity = quantity, .scenes = static_cast<int>(curves.size())};
  double squares = 0;
  for (const CurveThresholds& curve : curves) {
    const std::optional<double>& level_x = (curve.*threshold).level_x;
    if (!level_x) continue;
    ++spread.with_value;  // Welford's update
    const double from_mean = *level_x - spread.mean_x;
    spread.mean_x += from_mean / spread.with_value;
    squares += from_mean * (*level_x - spread.mean_x);
  }
  if (spread.with_value > 1) spread.sd_x = std::sqrt(squares / (spread.with_value - 1));
  return spread;
}

GainSource gain_source_of(const PredictionRequest& request, const ObserverDefinition& observer) {
  if (request.calibrate) return GainSource::paper;
  if (request.gain) return GainSource::given;
  return observer.image_gain ? GainSource::study : GainSource::detection;
}

double mean_difference(const PredictedArtifact& artifact) {
  double sum = 0;
  for (const PredictedCell& cell : artifact.cells) sum += cell.visible_difference;
  return sum / artifact.cells.size();
}

/// Of a study's levels.
LevelAxis prediction_axis(const LevelDefinition& level) {
  LevelAxis axis{.quantity = level.quantity, .noticeability = level.noticeability, .unit = 1};
  const double range = level.values.back() - level.values.front();
  if (is_linear(axis) && range > 0) axis.unit = range / 6;
  return axis;
}

/// For sorting: a missing threshold is beyond the widths on the side that its reason says.
double log2_or_beyond(const ThresholdEstimate& estimate) {
  if (estimate.level_x) return *estimate.level_x;
  return estimate.reason == NoThreshold::curve_above ? above_every_level : below_every_level;
}

double level_of_record(const ManifestStimulus& record, const LevelAxis& axis) {
  return of_depth_widths(axis) ? record.stimulus.depth.width_px : record.stimulus.level;
}

}  // namespace

double take_finest_for_floor(const Manifest& manifest, VisibleDifferences& differences,
                             const LevelAxis& axis) {
  std::map<std::pair<std::string, Artifact>, const ManifestStimulus*> finest;
  for (const ManifestStimulus& record : manifest.stimuli) {
    if (record.stimulus.artifact == Artifact::none || stands_apart(axis, level_of_record(record, axis)))
      continue;
    const ManifestStimulus*& last = finest[{floor_key(record.stimulus), record.stimulus.artifact}];
    if (last == nullptr || comes_before(axis, level_of_record(*last, axis), level_of_record(record, axis)))
      last = &record;
  }
  double highest = 0;
  for (const ManifestStimulus& record : manifest.stimuli) {
    const auto last = finest.find({floor_key(record.stimulus), record.stimulus.artifact});
    if (last == finest.end()) continue;
    const double floor = differences.at(last->second->id).pooled;
    VisibleDifference& difference = differences.at(record.id);
    difference.above_floor = above_floor(difference.pooled, floor);
    highest = std::max(highest, floor);
  }
  return highest;
}

std::vector<PredictedArtifact> predict_artifacts(const Manifest& manifest,
                                                 const VisibleDifferences& differences,
                                                 const ObserverDefinition& observer, const LevelAxis& axis,
                                                 const PlannedTask& task) {
  const auto before = [&axis](double a, double b) { return comes_before(axis, a, b); };
  using Cells = std::map<double, CellSums, decltype(before)>;
  std::map<Artifact, Cells> sums;
  for (const ManifestStimulus& record : manifest.stimuli) {
    if (record.stimulus.artifact == Artifact::none) continue;
    Cells& cells = sums.try_emplace(record.stimulus.artifact, before).first->second;
    CellSums& cell = cells[level_of_record(record, axis)];
    const double difference = differences.at(record.id).above_floor;
    cell.difference += difference;
    cell.noticeability += expected_mean(observer, difference, task);
    ++cell.count;
  }
  std::vector<PredictedArtifact> artifacts;
  for (const auto& [artifact, cells] : sums) {
    PredictedArtifact predicted{.artifact = artifact, .cells = {}, .thresholds = {}};
    std::vector<double> level_x, means;
    for (const auto& [level, cell] : cells) {
      predicted.cells.push_back({.level = level,
                                 .visible_difference = cell.difference / cell.count,
                                 .expected_noticeability = cell.noticeability / cell.count});
      if (stands_apart(axis, level)) continue;
      level_x.push_back(x_of(axis, level));
      means.push_back(predicted.cells.back().expected_noticeability);
    }
    predicted.thresholds = thresholds_of_means(level_x, means, axis);
    artifacts.push_back(std::move(predicted));
  }
  return artifacts;
}

std::vector<SceneSpread> scene_spreads(const Manifest& manifest, const VisibleDifferences& differences,
                                       const ObserverDefinition& observer, const LevelAxis& axis,
                                       const PlannedTask& task) {
  std::map<std::string, Manifest> by_scene;
  for (const ManifestStimulus& record : manifest.stimuli)
    by_scene[record.stimulus.scene].stimuli.push_back(record);
  std::map<Artifact, std::vector<CurveThresholds>> thresholds;
  for (const auto& [scene, part] : by_scene)
    for (const PredictedArtifact& artifact : predict_artifacts(part, differences, observer, axis, task))
      thresholds[artifact.artifact].push_back(artifact.thresholds);
  std::vector<SceneSpread> spreads;
  for (const auto& [artifact, curves] : thresholds) {
    if (curves.size() < 2) continue;
    spreads.push_back(
        spread_of(artifact, task.facts.rates ? "PT" : "detection", curves, &CurveThresholds::perceptual));
    if (!task.facts.rates) continue;
    spreads.push_back(spread_of(artifact, "SN", curves, &CurveThresholds::slightly_noticeable));
  }
  return spreads;
}

double calibrated_gain(const Manifest& manifest, const VisibleDifferences& differences,
                       ObserverDefinition observer, double receiver_px) {
  const double wanted = std::log2(receiver_px);
  double low = -60, high = 60;  // log2 of the gain
  while (high - low > 1e-9) {
    const double middle = (low + high) / 2;
    observer.image_gain = std::exp2(middle);
    (receiver_threshold(manifest, differences, observer) < wanted ? low : high) = middle;
  }
  observer.image_gain = std::exp2((low + high) / 2);
  const double found = receiver_threshold(manifest, differences, observer);
  if (!(std::abs(found - wanted) < 1e-3))
    throw input_error(
        {.field = request_name("calibrate"),
         .wanted = fmt::format("a gain that puts the receiver's threshold at {:.0f} px", receiver_px),
         .found = "none: the threshold jumps over that width"});
  return *observer.image_gain;
}

Prediction predict_thresholds(const PredictionRequest& request) {
  const study::RenderedSet set = study::load_rendered_set(request.set_folder);
  const PlannedTask task = planned_task(set.study, std::nullopt);
  check_manifest_pictures(set.folder, set.manifest);
  const std::string manifest_file = (request.set_folder / "manifest.json").string();
  if (request.calibrate && set.study.level.quantity != Quantity::depth_width_px)
    throw input_error({.file = manifest_file,
                       .field = "level.quantity",
                       .wanted = "\"depth_width_px\", on which the paper's threshold is, or no " +
                                 request_name("calibrate"),
                       .found = "\"" + std::string(facts(set.study.level.quantity).key) + "\""});
  if (request.calibrate && !task.asks_as_paper())
    throw input_error(
        {.file = manifest_file,
         .field = request_name("calibrate"),
         .wanted = "the paper's task, of which its threshold is, or no " + request_name("calibrate"),
         .found = "kind = \"" + std::string(word(task.facts.kind)) + "\"" +
                  (task.facts.kind == TaskKind::object && task.facts.rates
                       ? fmt::format(" of {} objects", task.facts.objects)
                       : "")});
  if (set.study.conditions.size() > 1)
    throw input_error({.file = manifest_file,
                       .field = "condition",
                       .wanted = "one condition (predict each condition as a set of its own)",
                       .found = std::to_string(set.study.conditions.size())});
  Prediction prediction{.observer = set.study.observer,
                        .axis = prediction_axis(set.study.level),
                        .task = task,
                        .artifacts = {},
                        .depth_errors = depth_errors_of_set(set.manifest)};
  if (request.pixels_per_degree) prediction.observer.pixels_per_degree = *request.pixels_per_degree;
  const double ppd = prediction.observer.pixels_per_degree;
  const DifferenceFloors floors = floors_of(request.none_set_folder, ppd, request.threads);
  VisibleDifferences differences =
      visible_differences(set.folder, set.manifest, ppd, floors, request.threads);
  DifferenceFloors known = difference_floors(set.manifest, differences);
  known.insert(floors.begin(), floors.end());
  prediction.floor_known = !known.empty();
  for (const auto& [key, floor] : known) prediction.highest_floor = std::max(prediction.highest_floor, floor);
  prediction.finest_is_floor = request.finest_is_floor;
  if (request.finest_is_floor)
    prediction.highest_floor = take_finest_for_floor(set.manifest, differences, prediction.axis);
  prediction.gain_source = gain_source_of(request, prediction.observer);
  if (request.gain) prediction.observer.image_gain = *request.gain;
  if (prediction.gain_source == GainSource::detection)
    prediction.observer.image_gain = detection_gain(prediction.observer);
  if (prediction.gain_source == GainSource::paper)
    prediction.observer.image_gain =
        calibrated_gain(set.manifest, differences, prediction.observer,
                        paper_thresholds(Artifact::receiver).value().perceptual_px.value());
  prediction.artifacts =
      predict_artifacts(set.manifest, differences, prediction.observer, prediction.axis, task);
  prediction.spreads = scene_spreads(set.manifest, differences, prediction.observer, prediction.axis, task);
  if (prediction.artifacts.empty())
    throw input_error({.file = (request.set_folder / "manifest.json").string(),
                       .field = "stimuli",
                       .wanted = "stimuli with a seam",
                       .found = "only the artifact none"});
  return prediction;
}

std::vector<Artifact> demanding_order(const std::vector<PredictedArtifact>& artifacts) {
  std::vector<PredictedArtifact> sorted = artifacts;
  std::stable_sort(sorted.begin(), sorted.end(), [](const PredictedArtifact& a, const PredictedArtifact& b) {
    const auto key = [](const PredictedArtifact& artifact) {
      return std::tuple(log2_or_beyond(artifact.thresholds.perceptual),
                        log2_or_beyond(artifact.thresholds.slightly_noticeable), mean_difference(artifact));
    };
    return key(a) > key(b);
  });
  std::vector<Artifact> order;
  for (const PredictedArtifact& artifact : sorted) order.push_back(artifact.artifact);
  return order;
}

}  // namespace seamline::analysis
