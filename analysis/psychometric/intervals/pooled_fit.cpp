#include "analysis/psychometric/intervals/pooled_fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "analysis/statistics/distributions.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"

namespace seamline::analysis {

namespace {

std::vector<LevelCounts> sums(const PooledChoices& choices) {
  std::vector<LevelCounts> counts;
  for (std::size_t i = 0; i < choices.level.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    counts.push_back({.level = choices.level[i],
                      .correct = std::llround(choices.correct.col(column).sum()),
                      .trials = std::llround(choices.trials.col(column).sum())});
  }
  return counts;
}

/// Variance of the threshold (unit axis) by leaving out one participant at a time. Each fit climbs from the
/// one of everybody: a step that is a little likelier once somebody is left out lies elsewhere, and one such
/// jump would be taken for a huge variance.
double jackknife_variance(const PooledChoices& choices, const PsychometricFit& fit) {
  const auto people = choices.correct.rows();
  Eigen::VectorXd thresholds(people);
  for (Eigen::Index person = 0; person < people; ++person) {
    FitProblem problem = fit.search.problem;
    for (std::size_t i = 0; i < choices.level.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const double t = problem.to_unit(axis_value(problem.axis, choices.level[i]));
      for (auto* list : {&problem.levels, &problem.rows})
        for (UnitCounts& level : *list)
          if (level.t == t) {
            level.k -= choices.correct(person, column);
            level.n -= choices.trials(person, column);
          }
    }
    for (auto* list : {&problem.levels, &problem.rows})
      std::erase_if(*list, [](const UnitCounts& level) { return level.n <= 0; });
    thresholds[person] =
        maximise(problem, {}, fit.search.best.theta, fit.search.best.eta).theta[parameter::threshold];
  }
  const double n = people;
  return (n - 1) / n * (thresholds.array() - thresholds.mean()).square().sum();
}

/// Where the likelihood has no curvature (a step): how much more people's sums of right answers vary than
/// binomial ones would.
double variance_ratio_of_sums(const PooledChoices& choices, const PsychometricFit& fit) {
  double squares = 0, binomial = 0;
  for (Eigen::Index person = 0; person < choices.correct.rows(); ++person) {
    double residual = 0;
    for (std::size_t i = 0; i < choices.level.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const double p = fitted_probability(fit, choices.level[i]), n = choices.trials(person, column);
      residual += choices.correct(person, column) - n * p;
      binomial += n * p * (1 - p);
    }
    squares += residual * residual;
  }
  const double n = choices.correct.rows();
  return binomial > 0 ? std::max(1.0, n / (n - 1) * squares / binomial) : 1;
}

double design_effect(const PooledChoices& choices, const PsychometricFit& fit) {
  if (fit.is_step) return variance_ratio_of_sums(choices, fit);
  const double information = coordinate_variance(fit.search.problem, fit.search.best, parameter::threshold);
  if (!std::isfinite(information)) return variance_ratio_of_sums(choices, fit);
  // People who answer exactly alike leave the jackknife nothing to measure, which is not the same as no
  // variance: their answers are then taken for independent.
  const double variance = jackknife_variance(choices, fit);
  return variance > 1e-6 * information ? variance / information : 1;
}

}  // namespace

PooledChoices pooled_choices(const study::LogContents& log, const std::vector<std::string>& codes,
                             Artifact artifact, const std::string& condition) {
  std::map<std::string, std::map<double, std::pair<int, int>>> tallies;  // code -> level -> (right, all)
  std::set<double> levels;
  const std::set<std::string> counted(codes.begin(), codes.end());
  for (const study::Answer& answer : log.answers) {
    stop_if_interrupted();
    if (answer.artifact != artifact || answer.condition != condition || !counted.contains(answer.participant))
      continue;
    auto& [right, all] = tallies[answer.participant][answer.level];
    right += answer.correct() ? 1 : 0;
    ++all;
    levels.insert(answer.level);
  }
  PooledChoices choices;
  choices.level.assign(levels.begin(), levels.end());
  for (const std::string& code : codes)
    if (tallies.contains(code)) choices.people.push_back(code);
  const auto rows = static_cast<Eigen::Index>(choices.people.size()),
             columns = static_cast<Eigen::Index>(levels.size());
  choices.correct = choices.trials = Eigen::MatrixXd::Zero(rows, columns);
  for (Eigen::Index row = 0; row < rows; ++row)
    for (const auto& [level, tally] : tallies[choices.people[row]]) {
      const auto column = static_cast<Eigen::Index>(std::distance(levels.begin(), levels.find(level)));
      choices.correct(row, column) = tally.first;
      choices.trials(row, column) = tally.second;
    }
  return choices;
}

PooledFit fit_pooled_choices(const PooledChoices& choices, const FitOptions& options,
                             const std::string& unit) {
  if (choices.correct.rows() < 2)
    throw input_error({.field = "participants",
                       .wanted = "at least two, for an interval over participants",
                       .found = std::to_string(choices.correct.rows())});
  PooledFit pooled;
  pooled.fit = fit_psychometric(sums(choices), options);
  if (pooled.fit.levels.size() >= 2) {
    pooled.design_effect = design_effect(choices, pooled.fit);
    const double t = student_quantile(choices.correct.rows() - 1, 0.975);
    pooled.threshold_ci95 = threshold_interval(pooled.fit, pooled.design_effect * t * t);
  }
  const ThresholdFinding finding = judge_threshold(pooled.fit, pooled.threshold_ci95, unit);
  pooled.verdict = finding.verdict;
  pooled.threshold = finding.estimate;
  pooled.threshold_ci95 = finding.ci95;
  return pooled;
}

}  // namespace seamline::analysis
