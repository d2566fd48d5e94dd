// Psychometric fits: the search alone, with the three profile intervals, and a bootstrap replicate.
#include <benchmark/benchmark.h>

#include <cmath>

#include "analysis/psychometric/intervals/bootstrap_intervals.h"
#include "analysis/psychometric/intervals/fit_intervals.h"

namespace seamline {
using namespace analysis;
namespace {

/// Seven widths of a 3-alternative task, 60 trials each.
const std::vector<LevelCounts> seven_widths = {{64, 59, 60},   {128, 58, 60},  {256, 52, 60}, {512, 41, 60},
                                               {1024, 27, 60}, {2048, 22, 60}, {4096, 19, 60}};

FitOptions options_with(std::optional<Direction> direction) {
  FitOptions options = options_for_alternatives(3);
  options.direction = direction;
  return options;
}

void psychometric_fit(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(fit_psychometric(seven_widths, options_with(Direction::decreasing)));
}
BENCHMARK(psychometric_fit)->Unit(benchmark::kMicrosecond);

void psychometric_fit_with_profile_intervals(benchmark::State& state) {
  for (auto _ : state) {
    const PsychometricFit fit = fit_psychometric(seven_widths, options_with(std::nullopt));
    benchmark::DoNotOptimize(threshold_interval(fit));
    benchmark::DoNotOptimize(width_interval(fit));
    benchmark::DoNotOptimize(lapse_interval(fit));
  }
}
BENCHMARK(psychometric_fit_with_profile_intervals)->Unit(benchmark::kMicrosecond);

void psychometric_fit_of_a_hundred_single_trials(benchmark::State& state) {
  std::vector<LevelCounts> counts;
  for (int i = 0; i < 100; ++i)
    counts.push_back(
        {.level = std::exp2(6 + 6.0 * i / 99), .correct = (i * 7919) % 100 < 110 - i ? 1 : 0, .trials = 1});
  for (auto _ : state) {
    const PsychometricFit fit = fit_psychometric(counts, options_with(Direction::decreasing));
    benchmark::DoNotOptimize(threshold_interval(fit));
  }
}
BENCHMARK(psychometric_fit_of_a_hundred_single_trials)->Unit(benchmark::kMicrosecond);

void bootstrap_of_100_replicates(benchmark::State& state) {
  const PsychometricFit fit = fit_psychometric(seven_widths, options_with(Direction::decreasing));
  for (auto _ : state) benchmark::DoNotOptimize(bootstrap_intervals(fit, {.replicates = 100}));
}
BENCHMARK(bootstrap_of_100_replicates)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace seamline
