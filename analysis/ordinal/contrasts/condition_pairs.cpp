#include "analysis/ordinal/contrasts/condition_pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "analysis/ordinal/contrasts/contrasts_apart.h"
#include "analysis/ordinal/contrasts/study_contrasts.h"
#include "analysis/ordinal/likelihood/mixed_fit.h"
#include "support/running/parallel.h"

namespace seamline::analysis {
namespace {

using Cell = std::pair<Artifact, std::string>;  ///< artifact, condition

/// Answers of each artifact in each condition, by index, rising; without those that no model holds.
std::map<Cell, std::vector<std::size_t>> answers_of_cells(std::span<const study::Answer> answers,
                                                          const LevelAxis& axis) {
  std::map<Cell, std::vector<std::size_t>> cells;
  for (std::size_t i = 0; i < answers.size(); ++i)
    if (of_depth_widths(axis) || !stands_apart(axis, answers[i].level))
      cells[{answers[i].artifact, answers[i].condition}].push_back(i);
  return cells;
}

/// A condition, the one that it is compared with, and the artifacts that are shown in both.
struct Pair {
  std::string first, condition;
  std::vector<Artifact> artifacts;
};

/// As the study's own model compares them: with the first condition in which the artifact was shown.
std::vector<Pair> pairs_of(const std::map<Cell, std::vector<std::size_t>>& cells,
                           const std::vector<std::string>& conditions) {
  std::vector<Pair> pairs;
  std::map<Artifact, std::string> first;
  for (const std::string& condition : conditions) {
    std::map<std::string, std::vector<Artifact>> by_first;
    for (const Artifact artifact : every_artifact) {
      if (!cells.contains({artifact, condition})) continue;
      const auto [found, is_first] = first.emplace(artifact, condition);
      if (!is_first) by_first[found->second].push_back(artifact);
    }
    for (auto& [other, artifacts] : by_first)
      pairs.push_back({.first = other, .condition = condition, .artifacts = std::move(artifacts)});
  }
  return pairs;
}

std::vector<std::string> every_condition(std::span<const study::Answer> answers,
                                         const std::vector<std::string>& order) {
  std::vector<std::string> conditions = order;
  std::set<std::string> known(order.begin(), order.end());
  for (const study::Answer& answer : answers)
    if (known.insert(answer.condition).second) conditions.push_back(answer.condition);
  return conditions;
}

struct FittedPair {
  EstimatedContrasts levels, slopes;
  std::string missing;  ///< why there is no estimate; empty: there is
  bool own_errors = false;
};

FittedPair fit_pair(const Pair& pair, std::vector<study::Answer> answers, const ParticipantGroups& groups,
                    const OrdinalStudyRequest& request, double reference_level) {
  const StudyDesign design =
      study_design(answers, groups, reference_level, request.axis, {pair.first, pair.condition});
  OrdinalRequest alone = request.fit;
  alone.threads = 1;
  const OrdinalFit fit = fit_cumulative_link_mixed(design.data, alone);
  FittedPair fitted;
  Eigen::MatrixXd covariance;
  if (has_estimates(fit.verdict)) {
    fitted.own_errors = fit.robust_covariance.size() == 0;
    const Eigen::Index effects = fit.coefficients.size(), fixed = fit.cuts.size() + effects;
    covariance = fitted.own_errors
                     ? fit.covariance.topLeftCorner(fixed, fixed).bottomRightCorner(effects, effects).eval()
                     : fit.robust_covariance.bottomRightCorner(effects, effects).eval();
  } else {
    fitted.missing = fmt::format("{} and {}: {}", pair.condition, pair.first, fit.explanation);
  }
  auto [levels, slopes] = condition_contrasts(design, !fitted.own_errors);
  levels.odds_ratio = request.fit.link == Link::logit && levels.differences;
  fitted.levels = {.family = std::move(levels), .coefficients = fit.coefficients, .covariance = covariance};
  fitted.slopes = {.family = std::move(slopes), .coefficients = fit.coefficients, .covariance = covariance};
  return fitted;
}

}  // namespace

std::size_t count_cells(std::span<const study::Answer> answers) {
  std::set<Cell> cells;
  for (const study::Answer& answer : answers) cells.emplace(answer.artifact, answer.condition);
  return cells.size();
}

ConditionPairs compare_condition_pairs(std::span<const study::Answer> answers,
                                       const ParticipantGroups& groups, const OrdinalStudyRequest& request,
                                       double reference_level) {
  const std::map<Cell, std::vector<std::size_t>> cells = answers_of_cells(answers, request.axis);
  const std::vector<Pair> pairs = pairs_of(cells, every_condition(answers, request.conditions));
  std::vector<FittedPair> fitted(pairs.size());
  run_parallel(static_cast<int>(pairs.size()), request.fit.threads, [&](int index) {
    const Pair& pair = pairs[index];
    std::vector<std::size_t> rows;
    for (const Artifact artifact : pair.artifacts)
      for (const std::string& condition : {pair.first, pair.condition}) {
        const std::vector<std::size_t>& own = cells.at({artifact, condition});
        rows.insert(rows.end(), own.begin(), own.end());
      }
    std::sort(rows.begin(), rows.end());
    std::vector<study::Answer> of_pair;
    for (const std::size_t row : rows) of_pair.push_back(answers[row]);
    fitted[index] = fit_pair(pair, std::move(of_pair), groups, request, reference_level);
  });

  ConditionPairs result;
  std::size_t missing = 0, own_errors = 0;
  std::string why;
  std::vector<EstimatedContrasts> levels, slopes;
  for (FittedPair& one : fitted) {
    if (!one.missing.empty() && missing++ == 0) why = one.missing;
    own_errors += one.own_errors ? 1 : 0;
    if (!one.levels.family.contrasts.empty()) levels.push_back(std::move(one.levels));
    if (!one.slopes.family.contrasts.empty()) slopes.push_back(std::move(one.slopes));
  }
  for (const std::vector<EstimatedContrasts>& parts : {levels, slopes})
    if (!parts.empty()) result.tables.push_back(test_contrasts_apart(parts));
  if (missing > 0)
    result.notes.push_back(fmt::format("{} of {} pairs of conditions have no estimate; the first, {}",
                                       missing, pairs.size(), why));
  if (own_errors > 0)
    result.notes.push_back(fmt::format(
        "Standard errors of {} of {} pairs of conditions are the model's own: without one of the "
        "participants some effect cannot be estimated. They are too small when participants differ in more "
        "than their level.",
        own_errors, pairs.size()));
  return result;
}

}  // namespace seamline::analysis
