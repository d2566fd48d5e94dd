#include "analysis/psychometric/intervals/fit_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "study/placement/sigmoid_shape.h"
#include "support/text/counted.h"

namespace seamline::analysis {

namespace {

constexpr std::int64_t few_trials = 40;
constexpr double misfit_p = 0.05;

using Warnings = std::vector<std::string>;

std::string share_text(const LevelCounts& level) {
  return fmt::format("{} of {} right at {:.4g}", level.correct, level.trials, level.level);
}

void warn_of_separation(const PsychometricFit& fit, Warnings& warnings) {
  if (!fit.is_step || fit.levels.size() < 2) return;
  const StepFit& step = *fit.search.step;
  if (!std::isfinite(step.low_t) || !std::isfinite(step.high_t)) return;
  const FitProblem& problem = fit.search.problem;
  const auto level = [&](double t) { return level_of(fit.options.axis, problem.to_axis(t)); };
  std::string text =
      step.through_level
          ? fmt::format(
                "separation: no sigmoid is likelier than a step through {:.4g}, and all up to a width of "
                "{:.3g}, with thresholds from {:.4g} to {:.4g}, are as likely",
                level(std::abs(step.low_t - step.maximum.theta[0]) <
                              std::abs(step.high_t - step.maximum.theta[0])
                          ? step.low_t
                          : step.high_t),
                std::exp(step.largest_log_scale) * problem.range *
                    study::scales_in_width(fit.options.sigmoid),
                level(step.low_t), level(step.high_t))
          : fmt::format(
                "separation: no sigmoid is likelier than a step between {:.4g} and {:.4g}, so that threshold "
                "and width have no single value",
                level(step.low_t), level(step.high_t));
  if (const auto& smooth = fit.search.smooth;
      smooth && smooth->value < step.maximum.value - 1e-4 && smooth->theta[1] > problem.lower[1] + 1e-3)
    text +=
        fmt::format(" (best smooth function: threshold {:.4g}, width {:.3g}, {:.3g} log units less likely)",
                    level(smooth->theta[0]),
                    std::exp(smooth->theta[1]) * problem.range * study::scales_in_width(fit.options.sigmoid),
                    step.maximum.value - smooth->value);
  warnings.push_back(text);
}

void warn_of_caps(const PsychometricFit& fit, Warnings& warnings) {
  const bool falling = fit.direction == study::Direction::decreasing;
  const auto at_cap = [](const Rate& rate, double value) {
    return rate.is_free() && value >= rate.high * (1 - 1e-9);
  };
  if (at_cap(fit.options.lapse, fit.function.lapse))
    warnings.push_back(fmt::format("the lapse rate is at its bound of {:.3g} ({} where the task is easiest)",
                                   fit.options.lapse.high,
                                   share_text(falling ? fit.levels.front() : fit.levels.back())));
  if (at_cap(fit.options.guess, fit.function.guess))
    warnings.push_back(fmt::format("the guess rate is at its bound of {:.3g} ({} where the task is hardest)",
                                   fit.options.guess.high,
                                   share_text(falling ? fit.levels.back() : fit.levels.front())));
}

/// "25 of 60 right at 512", "31 of 50 right from 3.1 to 4.2".
std::string share_text(const LevelGroup& group) {
  const std::string places = group.low == group.high
                                 ? fmt::format("at {:.4g}", group.low)
                                 : fmt::format("from {:.4g} to {:.4g}", group.low, group.high);
  return fmt::format("{:.0f} of {:.0f} right {}", group.correct, group.trials, places);
}

/// The two neighbours that go most strongly against the direction.
void add_reversal(const PsychometricFit& fit, const std::vector<LevelGroup>& groups, std::string& text) {
  const double sign = fit.direction == study::Direction::increasing ? 1 : -1;
  double worst = 0;
  std::size_t at = 0;
  for (std::size_t i = 1; i < groups.size(); ++i) {
    const LevelGroup &a = groups[i - 1], &b = groups[i];
    const double p = (a.correct + b.correct) / (a.trials + b.trials);
    const double variance = p * (1 - p) * (1 / a.trials + 1 / b.trials);
    const double z =
        variance > 0 ? sign * (a.correct / a.trials - b.correct / b.trials) / std::sqrt(variance) : 0;
    if (z > worst) {
      worst = z;
      at = i;
    }
  }
  if (worst > 2)
    text += fmt::format("; not monotone: {}, {} (z = {:.1f})", share_text(groups[at - 1]),
                        share_text(groups[at]), worst);
}

void warn_of_misfit(const PsychometricFit& fit, const FitEvidence& evidence, Warnings& warnings) {
  if (!std::isless(evidence.deviance_p, misfit_p)) return;  // p may be unknown
  const std::vector<LevelGroup>& groups = evidence.goodness.groups;
  const auto worst =
      std::max_element(groups.begin(), groups.end(), [](const LevelGroup& a, const LevelGroup& b) {
        return std::abs(a.deviance_residual) < std::abs(b.deviance_residual);
      });
  std::string text = fmt::format(
      "misfit: deviance {:.4g} on {} degrees of freedom, p = {:.2g}; largest residual {:+.2f} ({}, {:.3g} % "
      "expected)",
      evidence.goodness.deviance, evidence.goodness.degrees_of_freedom, evidence.deviance_p,
      worst->deviance_residual, share_text(*worst), 100 * worst->expected / worst->trials);
  add_reversal(fit, groups, text);
  warnings.push_back(text);
}

void warn_of_counts(const PsychometricFit& fit, Warnings& warnings) {
  const std::int64_t trials =
      std::accumulate(fit.levels.begin(), fit.levels.end(), std::int64_t{0},
                      [](std::int64_t sum, const LevelCounts& l) { return sum + l.trials; });
  if (trials < few_trials)
    warnings.push_back(fmt::format("tiny counts: {} over {}; likelihood intervals hold only roughly",
                                   counted(trials, "trial"), counted(fit.levels.size(), "level")));
  if (fit.levels_without_trials > 0)
    warnings.push_back(counted(fit.levels_without_trials, "row") + " without a trial left out");
  if (fit.levels.size() == 2)
    warnings.push_back("two levels: the fit passes through both, and its shape is not tested");
}

void warn_of_threshold(const PsychometricFit& fit, const FitEvidence& evidence, const std::string& unit,
                       Warnings& warnings) {
  if (evidence.verdict.kind == Verdict::Kind::not_identified) return;
  const double threshold = fit.function.threshold;
  if (evidence.verdict.kind == Verdict::Kind::identified &&
      (threshold < fit.levels.front().level || threshold > fit.levels.back().level))
    warnings.push_back(fmt::format(
        "extrapolated: the threshold {:.4g}{}{} lies outside the levels {:.4g} to {:.4g}", threshold,
        unit.empty() ? "" : " ", unit, fit.levels.front().level, fit.levels.back().level));
  if (!fit.direction_known)
    warnings.push_back("the data do not tell whether performance rises or falls with level");
  if (!std::isfinite(evidence.width_ci95.high))
    warnings.push_back(evidence.width_ci95.low > 0 && std::isfinite(evidence.width_ci95.low)
                           ? fmt::format("the width is not identified: above {:.3g}", evidence.width_ci95.low)
                           : "the width is not identified: none is excluded");
}

}  // namespace

Warnings warnings_on(const PsychometricFit& fit, const FitEvidence& evidence, const std::string& unit) {
  Warnings warnings;
  if (fit.levels.empty()) return {"no row has a trial"};
  if (evidence.verdict.kind != Verdict::Kind::not_identified) {
    warn_of_separation(fit, warnings);
    warn_of_caps(fit, warnings);
  }
  warn_of_misfit(fit, evidence, warnings);
  warn_of_threshold(fit, evidence, unit, warnings);
  warn_of_counts(fit, warnings);
  if (!fit.options.overdispersed && evidence.overdispersion.ci95.low > 0)
    warnings.push_back(
        fmt::format("overdispersed: eta {}at least {:.2g}; binomial intervals are too short",
                    evidence.overdispersion.eta ? fmt::format("{:.2g}, ", *evidence.overdispersion.eta) : "",
                    evidence.overdispersion.ci95.low));
  if (!fit.converged) warnings.push_back("the search did not converge");
  return warnings;
}

}  // namespace seamline::analysis
