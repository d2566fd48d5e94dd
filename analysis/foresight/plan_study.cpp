#include "analysis/foresight/plan_study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/foresight/plan_scenes.h"
#include "analysis/foresight/plan_summary.h"
#include "analysis/thresholds/planted_noticeability.h"
#include "stimuli/definition/looks/condition_tasks.h"
#include "stimuli/study_file/parts/study_file_task.h"
#include "stimuli/study_file/study_file.h"
#include "study/observers/observer.h"
#include "support/running/parallel.h"
#include "support/running/progress.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::analysis {
namespace {

constexpr std::uint64_t plan_salt = 0x706c616e;  // "plan"

void check_study(const PlanRequest& request, const StudyDefinition& study) {
  const std::string file = request.study_file.string();
  if (is_placed_by_answers(study))
    throw input_error({.file = file,
                       .field = "procedure",
                       .wanted = "\"constant\" (an adaptive session chooses its levels itself)",
                       .found = study.task && study.task->staircase ? "\"staircase\"" : "\"quest_plus\""});
  if (study.observer.direction != study.level.noticeability)
    throw input_error(
        {.file = file,
         .field = "observer.noticeability",
         .wanted = study.level.noticeability == Direction::decreasing
                       ? "\"falls\" (PT and SN are of noticeability that falls with the level)"
                       : "\"rises\" (the study says that noticeability rises with the level)",
         .found = study.observer.direction == Direction::decreasing ? "\"falls\"" : "\"rises\""});
}

/// What is assumed of ratings has no meaning where nobody is asked for one.
void check_ratings(const PlanRequest& request, const PlannedTask& task) {
  if (task.facts.rates) return;
  const std::string wanted = "a study that asks for ratings",
                    found = "kind = \"" + std::string(word(task.facts.kind)) + "\", which asks for none";
  if (request.assumed.criteria_sd > 0)
    throw input_error({.field = request_name("criteria_sd"), .wanted = wanted, .found = found});
  if (request.assumed.high_guesses > 0)
    throw input_error({.field = request_name("high_guesses"), .wanted = wanted, .found = found});
  if (request.estimator == PlanEstimator::straight_lines)
    throw input_error({.field = request_name("estimator"), .wanted = "joint, or " + wanted, .found = found});
}

/// Straight lines join means of ratings, which say nothing of detection.
void check_detection(const PlanRequest& request) {
  const std::vector<std::string>& asked = request.wanted.quantities;
  if (request.estimator == PlanEstimator::straight_lines &&
      std::find(asked.begin(), asked.end(), "detection") != asked.end())
    throw input_error({.field = request_name("quantities"),
                       .wanted = "detection beside " + request_name("estimator") + " joint",
                       .found = "straight-lines"});
}

/// The study of the conditions that are asked for, where conditions have tasks of their own.
StudyDefinition of_one_task(const PlanRequest& request, StudyDefinition study) {
  if (!has_own_tasks(study)) return study;
  std::string known;
  for (const TaskGroup& group : task_groups(study)) {
    const auto asks = [&](const std::string& condition) {
      return std::find(group.conditions.begin(), group.conditions.end(), condition) != group.conditions.end();
    };
    const std::vector<std::string>& asked = request.wanted.conditions;
    if (!asked.empty() && std::all_of(asked.begin(), asked.end(), asks)) return study_of_group(study, group);
    known += fmt::format("{}{} ({})", known.empty() ? "" : ", or ", fmt::join(group.conditions, ","),
                         word(facts_of(group.task.get()).kind));
  }
  throw input_error({.field = request_name("conditions"),
                     .wanted = "conditions that ask the same: " + known,
                     .found = fmt::format("\"{}\"", fmt::join(request.wanted.conditions, ","))});
}

/// Artifacts of all scenes, and of each its conditions. An artifact without a midpoint is wrong input.
std::vector<PlannedCurve> curves_of(const PlanRequest& request, const StudyDefinition& study) {
  std::vector<PlannedCurve> curves;
  const std::vector<ConditionDefinition> conditions = list_conditions(study);
  for (const Artifact artifact : every_artifact)
    for (const ConditionDefinition& condition : conditions) {
      int objects = 0;
      for (const SceneDefinition& scene : study.scenes)
        if (artifact != Artifact::none &&
            std::find(scene.artifacts.begin(), scene.artifacts.end(), artifact) != scene.artifacts.end())
          objects += static_cast<int>(scene.objects.size());
      if (objects == 0) continue;
      static_cast<void>(study::expected_noticeability(study.observer, {.artifact = artifact,
                                                                       .condition = condition.name,
                                                                       .quantity = study.level.quantity,
                                                                       .level = study.level.values.back()}));
      curves.push_back(
          {.artifact = artifact,
           .condition = conditions.size() > 1 || request.wanted.conditions.size() == 1 ? condition.name : "",
           .objects = objects,
           .midpoint = *planted_midpoint(study.observer, artifact, condition.name)});
    }
  if (curves.empty())
    throw input_error({.file = request.study_file.string(),
                       .field = "scene",
                       .wanted = "an artifact with a seam",
                       .found = "only none"});
  return curves;
}

/// Levels that have a place on the axis, in the order of `comes_before`.
std::vector<double> levels_of(const PlanRequest& request, const StudyDefinition& study, LevelAxis& axis) {
  axis = {.quantity = study.level.quantity, .noticeability = study.level.noticeability, .unit = 1};
  std::vector<double> levels;
  for (const double level : study.level.values)
    if (!stands_apart(axis, level)) levels.push_back(level);
  if (levels.size() < 2)
    throw input_error(
        {.file = request.study_file.string(),
         .field = of_depth_widths(axis) ? "depth_width_px" : "level.values",
         .wanted = of_depth_widths(axis) ? "at least two widths" : "at least two levels on the axis",
         .found = "one"});
  constexpr double units_in_range = 6;  // as `level_axis` has it of a log
  if (is_linear(axis)) axis.unit = (levels.back() - levels.front()) / units_in_range;
  if (axis.noticeability == Direction::increasing) std::reverse(levels.begin(), levels.end());
  return levels;
}

void check_claims(const PlanRequest& request, const std::vector<double>& levels, const LevelAxis& axis) {
  if (request.no_seam && std::find(levels.begin(), levels.end(), request.no_seam->level) == levels.end())
    throw input_error({.file = request.study_file.string(),
                       .field = request_name("no_seam_at"),
                       .wanted = "one of the study's levels on the axis",
                       .found = tested_text(axis, request.no_seam->level)});
  const bool compares = !request.wanted.differences.empty();
  if (request.equal_within && !compares)
    throw input_error({.field = request_name("equal_within"),
                       .wanted = request_name("difference") + " A:B beside it",
                       .found = "no comparison"});
  if (request.wanted.stated_difference && !compares)
    throw input_error({.field = request_name("stated_difference"),
                       .wanted = request_name("difference") + " A:B beside it",
                       .found = "no comparison"});
}

SimulatedStudy simulate_study(const PlanRequest& request, const PlannedPopulation& population,
                              const StudyPlan& plan, int study) {
  SimulatedStudy simulated;
  const int people = request.participants.back();
  const std::uint64_t seed = mix_bits(mix_bits(request.seed ^ plan_salt) + study);
  for (std::size_t set = 0; set < plan.level_sets.size(); ++set) {
    const std::vector<double>& levels = plan.level_sets[set].levels;
    const SimulatedAnswers answers = simulate_answers(population, plan.curves, levels, people, seed,
                                                      set * static_cast<std::uint64_t>(people));
    for (const int participants : request.participants) {
      simulated.intervals.push_back(
          planned_intervals(request.estimator, plan.curves, answers, participants, plan.targets, seed));
      simulated.no_seam.push_back(claims_shown(request, plan, answers, participants));
    }
  }
  return simulated;
}

std::vector<SimulatedStudy> simulate_studies(const PlanRequest& request, const PlannedPopulation& population,
                                             const StudyPlan& plan) {
  std::vector<SimulatedStudy> studies(request.studies);
  Progress progress("simulated studies", request.studies);
  int shown = 0;
  run_parallel(request.studies, request.threads,
               [&](int study) { studies[study] = simulate_study(request, population, plan, study); },
               {.tick = [&](int finished) {
                 if (finished > shown) progress.advance(finished - shown, "");
                 shown = finished;
               }});
  return studies;
}

}  // namespace

std::vector<LevelSet> level_sets_to_try(const std::vector<double>& levels, const LevelAxis& axis,
                                        const std::vector<PlanTarget>& targets) {
  LevelSet second{.name = "every second", .levels = {}};
  for (std::size_t i = (levels.size() + 1) % 2; i < levels.size(); i += 2) second.levels.push_back(levels[i]);
  std::vector<LevelSet> sets = {{.name = "all", .levels = levels}};
  if (second.levels.size() >= 2) sets.push_back(second);
  if (!of_depth_widths(axis) || axis.noticeability == Direction::increasing) return sets;

  const double least_x = x_of(axis, levels.front()), most_x = x_of(axis, levels.back());
  double low_x = most_x, high_x = least_x;
  for (const PlanTarget& target : targets)
    if (!target.against && target.truth_x > least_x && target.truth_x < most_x) {
      low_x = std::min(low_x, target.truth_x);
      high_x = std::max(high_x, target.truth_x);
    }
  std::set<double> dense = {levels.front(), levels.back()};
  const int steps = high_x < low_x ? 0 : static_cast<int>(std::floor(2 * (high_x - low_x) + 2.5)) + 1;
  for (int step = 0; step < steps; ++step) {
    const double width_px = 2 * std::round(std::exp2(low_x - 0.5 + 0.5 * step) / 2);
    if (width_px > levels.front() && width_px < levels.back()) dense.insert(width_px);
  }
  sets.push_back({.name = "denser near threshold", .levels = {dense.begin(), dense.end()}});
  return sets;
}

StudyPlan plan_study(const PlanRequest& request) {
  const StudyDefinition study =
      of_one_task(request, read_study(request.study_file, AssetCheck::not_needed, {}, request.idle));
  const PlannedTask task = planned_task(study, request.assumed.false_alarms);
  check_study(request, study);
  check_ratings(request, task);
  check_detection(request);
  StudyPlan plan;
  plan.request = request;
  plan.references = task.references;
  plan.curves = curves_of(request, study);
  const std::vector<double> levels = levels_of(request, study, plan.axis);
  check_claims(request, levels, plan.axis);
  const PlannedPopulation population{
      .observer = study.observer, .assumed = request.assumed, .axis = plan.axis, .task = task};
  plan.targets = plan_targets(request.wanted, population, plan.curves);
  plan.level_sets = level_sets_to_try(levels, plan.axis, plan.targets);
  plan.assumptions = assumptions_text(population, plan.curves);
  if (const std::string scenes = scenes_assumed_text(request, plan.axis); !scenes.empty())
    plan.assumptions += " " + scenes;
  for (const PlannedCurve& curve : plan.curves) {
    plan.trials_a_level += curve.objects * task.repetitions;
    if (request.no_seam)
      plan.seam_truth.push_back(
          mean_noticeability(population, curve, x_of(plan.axis, request.no_seam->level), JointMean::seen));
  }
  plan.bias_x.resize(plan.targets.size());
  for (const LevelSet& set : plan.level_sets) {
    const std::vector<std::optional<double>> limits = limits_of(
        request.estimator, population, plan.curves, plan.targets, x_of_levels(plan.axis, set.levels));
    for (std::size_t target = 0; target < limits.size(); ++target)
      plan.bias_x[target].push_back(
          limits[target] ? std::optional(*limits[target] - plan.targets[target].truth_x) : std::nullopt);
  }
  summarise(simulate_studies(request, population, plan), population, plan);
  return plan;
}

}  // namespace seamline::analysis
