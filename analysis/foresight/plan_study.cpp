#include "analysis/foresight/plan_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "analysis/statistics/interval.h"
#include "analysis/thresholds/thresholds.h"
#include "stimuli/study_file/study_file.h"
#include "study/observers/observer.h"
#include "study/placement/trial.h"
#include "support/running/interrupt.h"
#include "support/running/parallel.h"
#include "support/running/progress.h"
#include "support/text/error.h"

namespace seamline::analysis {
namespace {

constexpr std::uint64_t plan_salt = 0x706c616e;  // "plan"
constexpr int studies_a_step = 20;               // between two looks at progress and Ctrl-C

/// Objects shown of each artifact, over all scenes.
std::map<Artifact, int> objects_of_artifacts(const StudyDefinition& study) {
  std::map<Artifact, int> objects;
  for (const SceneDefinition& scene : study.scenes)
    for (const Artifact artifact : scene.artifacts)
      if (artifact != Artifact::none) objects[artifact] += static_cast<int>(scene.objects.size());
  return objects;
}

CurveThresholds planted_thresholds(const ObserverDefinition& observer, Artifact artifact,
                                   const std::vector<int>& width_px) {
  std::vector<double> means;
  for (const int width : width_px) means.push_back(study::expected_noticeability(observer, artifact, width));
  return thresholds_of_means(log2_widths(width_px), means);
}

/// One person's mean noticeability of an artifact's objects at each width.
Eigen::RowVectorXd answers_of(const study::Observer& person, Artifact artifact, int objects,
                              const std::vector<int>& width_px, Random& random) {
  Eigen::RowVectorXd means(static_cast<Eigen::Index>(width_px.size()));
  Stimulus stimulus;
  stimulus.artifact = artifact;
  for (std::size_t w = 0; w < width_px.size(); ++w) {
    stimulus.depth.width_px = width_px[w];
    stimulus.level = width_px[w];
    int sum = 0;
    for (int object = 0; object < objects; ++object) {
      stimulus.object_index = 1 + object % study::objects_per_stimulus;
      const study::Response response = study::respond(person, stimulus, random);
      if (response.chosen_index == stimulus.object_index) sum += response.rating;
    }
    means[static_cast<Eigen::Index>(w)] = static_cast<double>(sum) / objects;
  }
  return means;
}

/// Lengths of the intervals of PT and SN, octaves, one for each row of a plan, of one simulated study; none
/// where an interval is open.
struct IntervalLengths {
  std::vector<std::optional<double>> perceptual, slightly_noticeable;
};

struct Task {
  const PlanRequest& request;
  const ObserverDefinition observer;
  const std::map<Artifact, int> objects;
  const std::vector<WidthSet> width_sets;
};

/// Everybody of the largest study, people x widths for each artifact; a smaller study is its first people.
std::map<Artifact, Eigen::MatrixXd> simulate_people(const Task& task, int study, std::size_t set) {
  const int people = task.request.participants.back();
  const std::vector<int>& width_px = task.width_sets[set].width_px;
  std::map<Artifact, Eigen::MatrixXd> scores;
  for (const auto& [artifact, objects] : task.objects)
    scores[artifact].resize(people, static_cast<Eigen::Index>(width_px.size()));
  const std::uint64_t seed =
      mix_bits(mix_bits(task.request.seed ^ plan_salt) + static_cast<std::uint64_t>(study));
  for (int person = 0; person < people; ++person) {
    Random random(seed, set * static_cast<std::uint64_t>(people) + static_cast<std::uint64_t>(person));
    const study::Observer observer =
        study::make_observer(study::ObserverKind::threshold, task.observer, random);
    for (const auto& [artifact, objects] : task.objects)
      scores[artifact].row(person) = answers_of(observer, artifact, objects, width_px, random);
  }
  return scores;
}

IntervalLengths simulate_study(const Task& task, int study) {
  std::vector<std::map<Artifact, Eigen::MatrixXd>> scores;
  for (std::size_t set = 0; set < task.width_sets.size(); ++set)
    scores.push_back(simulate_people(task, study, set));
  IntervalLengths lengths;
  for (const auto& [artifact, objects] : task.objects)
    for (std::size_t set = 0; set < task.width_sets.size(); ++set) {
      const std::vector<double> level_x = log2_widths(task.width_sets[set].width_px);
      for (const int people : task.request.participants) {
        const MeanVector means = mean_and_covariance(scores[set].at(artifact).topRows(people));
        lengths.perceptual.push_back(length_x(level_interval(perceptual_level, level_x, means, people)));
        lengths.slightly_noticeable.push_back(length_x(level_interval(slight_level, level_x, means, people)));
      }
    }
  return lengths;
}

std::vector<IntervalLengths> simulate_studies(const Task& task) {
  std::vector<IntervalLengths> studies(static_cast<std::size_t>(task.request.studies));
  Progress progress("simulated studies", task.request.studies);
  for (int first = 0; first < task.request.studies; first += studies_a_step) {
    if (interrupted()) throw Interrupted{};
    const int count = std::min(studies_a_step, task.request.studies - first);
    run_parallel(count, task.request.threads, [&](int index) {
      studies[static_cast<std::size_t>(first + index)] = simulate_study(task, first + index);
    });
    progress.advance(count, "");
  }
  return studies;
}

PlannedInterval planned_interval(bool planted, const std::vector<std::optional<double>>& lengths) {
  std::vector<double> octaves;
  for (const std::optional<double>& length : lengths)
    if (length) octaves.push_back(*length);
  require_ordered(octaves);
  std::sort(octaves.begin(), octaves.end());
  const std::size_t all = lengths.size(), open = all - octaves.size();
  PlannedInterval planned{.planted = planted,
                          .open_share = static_cast<double>(open) / static_cast<double>(all)};
  if (all / 2 < octaves.size()) planned.median_octaves = octaves[all / 2];
  return planned;
}

std::vector<PlanRow> rows_of(const Task& task, const std::vector<IntervalLengths>& studies) {
  std::vector<PlanRow> rows;
  for (const auto& [artifact, objects] : task.objects)
    for (std::size_t set = 0; set < task.width_sets.size(); ++set) {
      const CurveThresholds planted =
          planted_thresholds(task.observer, artifact, task.width_sets[set].width_px);
      for (const int participants : task.request.participants) {
        std::vector<std::optional<double>> perceptual, slight;
        for (const IntervalLengths& study : studies) {
          perceptual.push_back(study.perceptual[rows.size()]);
          slight.push_back(study.slightly_noticeable[rows.size()]);
        }
        rows.push_back({.artifact = artifact,
                        .width_set = set,
                        .participants = participants,
                        .perceptual = planned_interval(planted.perceptual.level_x.has_value(), perceptual),
                        .slightly_noticeable =
                            planned_interval(planted.slightly_noticeable.level_x.has_value(), slight)});
      }
    }
  return rows;
}

void check_study(const PlanRequest& request, const StudyDefinition& study) {
  const std::string file = request.study_file.string();
  if (study.level.quantity != Quantity::depth_width_px)
    throw input_error({.file = file,
                       .field = "level.quantity",
                       .wanted = "\"depth_width_px\" (plan varies widths of depth maps only)",
                       .found = "\"" + std::string(facts(study.level.quantity).key) + "\""});
  if (study.conditions.size() > 1)
    throw input_error({.file = file,
                       .field = "condition",
                       .wanted = "one condition (plan each condition as a study of its own)",
                       .found = std::to_string(study.conditions.size())});
  if (!std::holds_alternative<ConstantDefinition>(study.procedure))
    throw input_error({.file = file,
                       .field = "procedure",
                       .wanted = "\"constant\" (an adaptive session chooses its widths itself)",
                       .found = "\"quest_plus\""});
  if (study.observer.direction == Direction::increasing)
    throw input_error({.file = file,
                       .field = "observer.noticeability",
                       .wanted = "\"falls\" (PT, SN and IP are of noticeability that falls with the width)",
                       .found = "\"rises\""});
  if (objects_of_artifacts(study).empty())
    throw input_error(
        {.file = file, .field = "scene", .wanted = "an artifact with a seam", .found = "only none"});
  if (depth_widths_px(study).size() < 2)
    throw input_error(
        {.file = file, .field = "depth_width_px", .wanted = "at least two widths", .found = "one"});
}

}  // namespace

std::vector<WidthSet> width_sets_to_try(const StudyDefinition& study) {
  const std::vector<int> all = depth_widths_px(study);
  WidthSet second{.name = "every second", .width_px = {}};
  for (std::size_t i = (all.size() + 1) % 2; i < all.size(); i += 2) second.width_px.push_back(all[i]);

  double low = std::log2(all.back()), high = std::log2(all.front());
  for (const auto& [artifact, objects] : objects_of_artifacts(study)) {
    const CurveThresholds planted = planted_thresholds(study.observer, artifact, all);
    for (const ThresholdEstimate* estimate : {&planted.perceptual, &planted.slightly_noticeable}) {
      if (!estimate->level_x) continue;
      low = std::min(low, *estimate->level_x);
      high = std::max(high, *estimate->level_x);
    }
  }
  std::set<int> dense = {all.front(), all.back()};
  for (double level_x = low - 0.5; level_x <= high + 0.75; level_x += 0.5) {
    const int width_px = 2 * static_cast<int>(std::lround(std::exp2(level_x) / 2));
    if (width_px > all.front() && width_px < all.back()) dense.insert(width_px);
  }
  std::vector<WidthSet> sets = {{.name = "all", .width_px = all}};
  if (second.width_px.size() >= 2) sets.push_back(second);
  sets.push_back({.name = "denser near threshold", .width_px = {dense.begin(), dense.end()}});
  return sets;
}

StudyPlan plan_study(const PlanRequest& request) {
  const StudyDefinition study = read_study(request.study_file, AssetCheck::not_needed);
  check_study(request, study);
  const Task task{.request = request,
                  .observer = study.observer,
                  .objects = objects_of_artifacts(study),
                  .width_sets = width_sets_to_try(study)};
  StudyPlan plan{.width_sets = task.width_sets,
                 .rows = rows_of(task, simulate_studies(task)),
                 .wanted_octaves = request.wanted_octaves,
                 .studies = request.studies};
  for (const auto& [artifact, objects] : task.objects) plan.stimuli_a_width += objects;
  return plan;
}

}  // namespace seamline::analysis
