#include "analysis/psychometric/intervals/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/psychometric/likelihood/count_terms.h"

namespace seamline::analysis {

namespace {

std::string level_text(double level, const std::string& unit) {
  return fmt::format("{:.4g}{}{}", level, unit.empty() ? "" : " ", unit);
}

Verdict none(const std::string& why) {
  return {.kind = Verdict::Kind::not_identified, .text = "not identified: " + why, .range = {}, .why = why};
}

Verdict below(double level, const std::string& unit) {
  return {.kind = Verdict::Kind::below, .text = "below " + level_text(level, unit), .range = {.high = level}};
}

Verdict above(double level, const std::string& unit) {
  return {.kind = Verdict::Kind::above, .text = "above " + level_text(level, unit), .range = {.low = level}};
}

/// Whether a constant probability within [low, high] explains k of n.
bool explained(double k, double n, double low, double high) {
  const double p = k / n, q = std::clamp(p, low, high);
  return binomial_term(k, n, p, 1 - p).value - binomial_term(k, n, q, 1 - q).value <= chi_squared_95 / 2;
}

/// Every answer, or nearly, is right: the threshold lies beyond the hardest level tested.
Verdict at_ceiling(const PsychometricFit& fit, const Interval& ci95, const std::string& unit) {
  if (!fit.options.direction)
    return none("every level at the ceiling, and the direction of the function is not given");
  const double lowest = fit.levels.front().level, highest = fit.levels.back().level;
  if (fit.direction == study::Direction::increasing && std::isfinite(ci95.high))
    return below(std::max(lowest, ci95.high), unit);
  if (fit.direction == study::Direction::decreasing && std::isfinite(ci95.low))
    return above(std::min(highest, ci95.low), unit);
  return none("every level at the ceiling, with too few trials for a bound");
}

Verdict flat(const PsychometricFit& fit, const Interval& ci95, const std::string& unit) {
  double k = 0, n = 0;
  for (const LevelCounts& level : fit.levels) {
    k += static_cast<double>(level.correct);
    n += static_cast<double>(level.trials);
  }
  const Rate& guess = fit.options.guess;
  const Rate& lapse = fit.options.lapse;
  const bool chance = explained(k, n, guess.low, guess.high);
  const bool ceiling = explained(k, n, 1 - lapse.high, 1 - lapse.low);
  if (chance && ceiling)
    return none(fmt::format("{:.0f} trials are too few to tell chance from the ceiling", n));
  if (chance) return none("every level at chance");
  if (ceiling) return at_ceiling(fit, ci95, unit);
  if (k / n < guess.low)
    return none(fmt::format("{:.3g} % right over all levels, below chance", 100 * k / n));
  return none(fmt::format("performance does not change with level ({:.3g} % right)", 100 * k / n));
}

Verdict of_interval(const PsychometricFit& fit, const Interval& ci95, const std::string& unit) {
  const bool open_below = !std::isfinite(ci95.low), open_above = !std::isfinite(ci95.high);
  if (open_below && open_above) return none("no threshold is excluded");
  if (open_below) return below(ci95.high, unit);
  if (open_above) return above(ci95.low, unit);
  if (fit.is_step && !fit.search.step->through_level)
    return {.kind = Verdict::Kind::between,
            .text = fmt::format("between {:.4g} and {}", ci95.low, level_text(ci95.high, unit)),
            .range = ci95};
  return {.kind = Verdict::Kind::identified, .text = "identified", .range = ci95};
}

}  // namespace

ThresholdFinding judge_threshold(const PsychometricFit& fit, const Interval& ci95, const std::string& unit) {
  if (fit.levels.empty()) return {.verdict = none("no trials"), .estimate = {}, .ci95 = {}};
  if (fit.levels.size() == 1) return {.verdict = none("one level tested"), .estimate = {}, .ci95 = {}};
  const bool is_flat = fit.search.best.value - fit.flat_log_likelihood <= chi_squared_95 / 2;
  ThresholdFinding finding;
  finding.verdict = is_flat ? flat(fit, ci95, unit) : of_interval(fit, ci95, unit);
  finding.ci95 = finding.verdict.range;
  if (std::isfinite(finding.ci95.low) && std::isfinite(finding.ci95.high))
    finding.estimate = std::clamp(fit.function.threshold, finding.ci95.low, finding.ci95.high);
  return finding;
}

Verdict verdict_on(const PsychometricFit& fit, const Interval& ci95, const std::string& unit) {
  return judge_threshold(fit, ci95, unit).verdict;
}

std::string verdict_sentence(const Verdict& verdict) {
  switch (verdict.kind) {
    case Verdict::Kind::identified:
      return "The answers determine the threshold.";
    case Verdict::Kind::below:
    case Verdict::Kind::above:
    case Verdict::Kind::between:
      return "The threshold lies " + verdict.text + ".";
    case Verdict::Kind::not_identified:
      return "The answers do not determine a threshold: " + verdict.why + ".";
  }
  return verdict.text;
}

}  // namespace seamline::analysis
