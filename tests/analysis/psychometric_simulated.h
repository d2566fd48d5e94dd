#pragma once
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/psychometric/likelihood/binomial_sampler.h"
#include "analysis/psychometric/report/fit_json.h"
#include "analysis/psychometric/report/fit_quantities.h"
#include "analysis/psychometric/report/fit_text.h"
#include "support/arithmetic/random.h"

namespace seamline::test {
using namespace analysis;
using namespace study;

/// Where the planted threshold lies: within the second to the last but one level, within a level's distance
/// of an outermost one, or up to two and a half levels further out.
enum class Place { inside, near, beyond };
inline constexpr std::array<const char*, 3> place_words = {"inside", "near", "beyond"};
inline constexpr std::array<std::int64_t, 4> trials_a_level = {12, 20, 40, 60};
inline constexpr std::array<const char*, 4> sigmoid_words = {"normal", "logistic", "Weibull", "Gumbel"};

/// Counts at seven levels from a function that is known, and how they are fitted.
struct SimulatedSet {
  PsychometricFunction planted;
  std::vector<LevelCounts> counts;
  FitOptions options;
  Place place = Place::inside;
  std::int64_t trials = 0;
  std::size_t sigmoid = 0;  ///< of `sigmoid_words`
};

/// Set number `seed` of a design that goes through three places, four sigmoids (normal, logistic and Weibull
/// on log2 levels 64 to 4096; Gumbel on linear levels 100, 400, 900 ... 4900, whose gaps differ) and four
/// numbers of trials; scales, lapses, guess rates and directions are drawn. The scale is 0.15 to 1.5 mean
/// gaps. The lapse rate is 0 to 0.06 and fitted freely in three of four sets, known in the fourth.
inline SimulatedSet simulated_set(std::uint64_t seed) {
  Random random(seed, 0x7365746f66636f75ULL);
  SimulatedSet set;
  set.place = static_cast<Place>(seed % 3);
  set.sigmoid = seed / 3 % 4;
  set.trials = trials_a_level[seed / 12 % 4];
  const bool is_linear = set.sigmoid == 3;
  constexpr int levels = 7;
  const auto axis_of = [&](double index) {
    return is_linear ? 100 * (index + 1) * (index + 1) : 6 + index;  // from level to level, 0 to 6
  };
  const double side = random.uniform() < 0.5 ? -1 : 1, u = random.uniform();
  const double off_centre = set.place == Place::inside ? 2 * u
                            : set.place == Place::near ? 2 + 2 * u
                                                       : 4 + 1.5 * u;
  const double place = 3 + side * off_centre, gap = is_linear ? 800 : 1;
  const double threshold = is_linear && place < -0.9 ? 1 + 300 * (place + 0.9) : axis_of(place);
  const std::array<double, 3> guesses = {1.0 / 3, 0.5, 0};
  set.planted = {.sigmoid = set.sigmoid == 0   ? Sigmoid::normal
                            : set.sigmoid == 1 ? Sigmoid::logistic
                                               : Sigmoid::gumbel,
                 .axis = is_linear ? Axis::linear : Axis::log2,
                 .direction = random.uniform() < 0.5 ? Direction::increasing : Direction::decreasing,
                 .threshold = is_linear ? threshold : std::exp2(threshold),
                 .scale = gap * 0.15 * std::pow(10, random.uniform()),
                 .guess = guesses[random.below(guesses.size())],
                 .lapse = random.uniform() < 0.4 ? 0 : 0.06 * random.uniform()};
  for (int i = 0; i < levels; ++i) {
    const double level = is_linear ? axis_of(i) : std::exp2(axis_of(i));
    set.counts.push_back(
        {.level = level,
         .correct = sample_binomial(set.trials, response_probability(set.planted, level), random),
         .trials = set.trials});
  }
  set.options.sigmoid = set.planted.sigmoid;
  set.options.axis = set.planted.axis;
  set.options.direction = set.planted.direction;
  set.options.guess = fixed_rate(set.planted.guess);
  set.options.lapse = random.uniform() < 0.75 ? free_rate(0.1) : fixed_rate(set.planted.lapse);
  return set;
}

/// Lengths on the axis in mean gaps between levels.
inline double length_in_gaps(const SimulatedSet& set, const Interval& interval) {
  return set.planted.axis == Axis::linear ? (interval.high - interval.low) / 800
                                          : std::log2(interval.high / interval.low);
}

inline bool is_closed(const Interval& interval) {
  return std::isfinite(interval.low) && std::isfinite(interval.high);
}

inline bool holds(const Interval& interval, double value) {
  return interval.low <= value && value <= interval.high;
}

/// What a report says against itself, in words; empty when nothing.
inline std::string contradiction(const JudgedFit& report) {
  using Kind = Verdict::Kind;
  const Interval &ci95 = report.threshold_ci95, &range = report.verdict.range;
  const Kind kind = report.verdict.kind;
  const bool has_number = kind == Kind::identified || kind == Kind::between;
  const FitQuantity threshold = quantities(report).front();
  if (has_number != is_closed(ci95)) return "verdict " + report.verdict.text + " beside another interval";
  if (has_number != threshold.estimate.has_value())
    return "an estimate without a closed interval, or none in it";
  if (threshold.estimate && !holds(ci95, *threshold.estimate))
    return "the estimate lies outside its interval";
  if (range.low != ci95.low || range.high != ci95.high) return "range and interval differ";
  if (kind == Kind::below && !(std::isinf(ci95.low) && std::isfinite(ci95.high)))
    return "below, but not a bound";
  if (kind == Kind::above && !(std::isfinite(ci95.low) && std::isinf(ci95.high)))
    return "above, but not a bound";
  if (kind == Kind::not_identified && (std::isfinite(ci95.low) || std::isfinite(ci95.high)))
    return "not identified, but an interval excludes something";
  if (report.fit.is_step && has_number && report.fit.search.step) {
    const FitProblem& problem = report.fit.search.problem;
    for (double t : {report.fit.search.step->low_t, report.fit.search.step->high_t})
      if (std::isfinite(t) && !holds({.low = ci95.low * (1 - 1e-9), .high = ci95.high * (1 + 1e-9)},
                                     level_of(problem.axis, problem.to_axis(t))))
        return "a threshold that is as likely lies outside the interval";
  }
  std::vector<FitQuantity> all = quantities(report);
  for (const FitQuantity& quantity : percent_quantities(report)) all.push_back(quantity);
  for (const FitQuantity& quantity : all) {
    if (quantity.estimate && !holds(quantity.ci95, *quantity.estimate))
      return quantity.name + " lies outside its interval";
    if (!quantity.estimate && quantity.reason.empty()) return "no " + quantity.name + ", and no reason";
    if (quantity.ci95.low > quantity.ci95.high) return quantity.name + ": an interval upside down";
    if (!quantity.bootstrap_ci95 || quantity.name == "lapse") continue;
    if (quantity.estimate && !holds(*quantity.bootstrap_ci95, *quantity.estimate))
      return quantity.name + " lies outside its bootstrap interval";
    if (is_closed(*quantity.bootstrap_ci95) && !is_closed(quantity.ci95))
      return quantity.name + ": a closed bootstrap interval beside an open one";
  }
  for (const std::string& text : {fit_text(report), fit_json(report)})
    for (const char* word : {" inf", " nan", "-inf", "-nan", "(inf", "(nan"})
      if (text.find(word) != std::string::npos) return std::string("a text says '") + word + "'";
  return {};
}

}  // namespace seamline::test
