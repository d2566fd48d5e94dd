#include <cmath>

#include "analysis/psychometric/intervals/bootstrap_intervals.h"
#include "analysis/psychometric/intervals/fit_intervals.h"
#include "analysis/psychometric/likelihood/psychometric_fit.h"
#include "laboratory/convergence/estimates/estimates.h"
#include "support/arithmetic/random.h"
#include "support/running/progress.h"

namespace seamline::renderer {
namespace {

using analysis::LevelCounts;
using analysis::PsychometricFit;

/// One of three objects is chosen, as in the paper.
const study::PsychometricFunction true_function{.sigmoid = Sigmoid::normal,
                                                .axis = Axis::log2,
                                                .direction = Direction::decreasing,
                                                .threshold = 426,
                                                .scale = 1,
                                                .guess = 1.0 / 3,
                                                .lapse = 0.02};

/// Answers at the paper's seven widths.
std::vector<LevelCounts> simulated_answers(std::int64_t trials_a_level, Random& random) {
  std::vector<LevelCounts> counts;
  for (int width_px = 64; width_px <= 4096; width_px *= 2) {
    const double level = width_px;
    counts.push_back({.level = level,
                      .correct = random.binomial(static_cast<int>(trials_a_level),
                                                 study::response_probability(true_function, level)),
                      .trials = trials_a_level});
  }
  return counts;
}

double evaluation_seconds(const PsychometricFit& fit) {
  constexpr int evaluations = 20000;
  const double before = processor_seconds();
  double sum = 0;
  for (int i = 0; i < evaluations; ++i)
    sum += analysis::log_likelihood(fit.search.problem, fit.search.best.theta, 0);
  return (processor_seconds() - before + (std::isnan(sum) ? 1 : 0)) / evaluations;
}

}  // namespace

EstimateResult measure_fit(std::uint64_t seed) {
  constexpr int fits = 100, levels = 7;
  EstimateResult result{.part = "fit",
                        .amount = "answers",
                        .unit = "octaves",
                        .truth =
                            "the threshold of the function that gave the answers (426 px, spread 1 "
                            "octave, 1 of 3 guessed, 2 % lapses)",
                        .rows = {},
                        .limit = {.what = "one evaluation of the likelihood", .seconds_each = 0},
                        .expected = -0.5,
                        .why =
                            "independent answers; few of them can leave the threshold at the edge of the "
                            "search, which is steeper"};
  Progress progress("fit", 6);
  for (std::int64_t trials = 8; trials <= 8192; trials *= 4) {
    Random random(seed, trials);
    double squares = 0, seconds = 0;
    for (int i = 0; i < fits; ++i) {
      const std::vector<LevelCounts> counts = simulated_answers(trials, random);
      const double before = processor_seconds();
      const PsychometricFit fit = analysis::fit_psychometric(counts, analysis::options_for_alternatives(3));
      seconds += processor_seconds() - before;
      const double octaves = std::log2(fit.function.threshold / true_function.threshold);
      squares += octaves * octaves;
      if (i == 0) result.limit.seconds_each = evaluation_seconds(fit);
    }
    result.rows.push_back({"maximum likelihood", static_cast<double>(levels * trials), seconds / fits,
                           std::sqrt(squares / fits)});
    progress.advance(1, "answers");
  }
  return result;
}

EstimateResult measure_interval(std::uint64_t seed) {
  constexpr int most_replicates = 51200, repeats = 16;
  Random random(seed);
  const PsychometricFit fit =
      analysis::fit_psychometric(simulated_answers(60, random), analysis::options_for_alternatives(3));
  const auto ends_of = [&](int replicates, std::uint64_t stream) {
    return analysis::bootstrap_intervals(fit, {.replicates = replicates, .seed = seed + stream}).threshold;
  };
  const analysis::Interval truth = ends_of(most_replicates, 1000);
  EstimateResult result{
      .part = "interval",
      .amount = "replicates",
      .unit = "octaves",
      .truth = "both ends of the same interval with 51,200 replicates of another seed",
      .rows = {},
      .limit = {.what = "one evaluation of the likelihood", .seconds_each = evaluation_seconds(fit)},
      .expected = -0.5,
      .why = "quantiles of independent replicates"};
  Progress progress("interval", 4);
  const auto error_of = [&](const analysis::Interval& found) {
    const double low = std::log2(found.low / truth.low), high = std::log2(found.high / truth.high);
    return (low * low + high * high) / 2;
  };
  for (int replicates = 50; replicates <= 3200; replicates *= 4) {
    double squares = 0;
    const double before = processor_seconds();
    for (int i = 0; i < repeats; ++i) squares += error_of(ends_of(replicates, static_cast<std::uint64_t>(i)));
    result.rows.push_back({"bootstrap", static_cast<double>(replicates),
                           (processor_seconds() - before) / repeats, std::sqrt(squares / repeats)});
    progress.advance(1, "replicates");
  }
  return result;
}

}  // namespace seamline::renderer
