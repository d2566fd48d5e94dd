// The tables of documentation/evidence/statistics.md over 20,000 simulated sets: run
// `analysis_full_tests --gtest_filter=PsychometricSimulated.*` to make them again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <map>

#include "tests/analysis/psychometric_simulated.h"

namespace seamline::analysis {
using namespace study;
namespace {

using test::SimulatedSet;

constexpr std::uint64_t sets = 20'000;
constexpr std::uint64_t sets_between_tables = 1000;
constexpr int replicates = 300;

double median(std::vector<double> values) {
  if (values.empty()) return nan;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Tally {
  int covered = 0, too_high = 0, too_low = 0, closed = 0;
  std::vector<double> lengths;
  void add(const Interval& interval, double planted) {
    covered += test::holds(interval, planted) ? 1 : 0;
    too_high += interval.low > planted ? 1 : 0;
    too_low += interval.high < planted ? 1 : 0;
    closed += test::is_closed(interval) ? 1 : 0;
  }
};

struct Row {
  int sets = 0, steps = 0, contradictions = 0;
  Tally profile, bootstrap;
  double profile_ms = 0, bootstrap_ms = 0;

  void print(const std::string& name) const {
    const double share = 100.0 / sets;
    std::printf(
        "| %s | %d | %.0f | %.0f | %.1f | %.1f | %.1f | %.2f | %.1f | %.1f | %.1f | %.2f | %.1f | %.1f | %d "
        "|\n",
        name.c_str(), sets, share * steps, share * profile.closed, share * profile.covered,
        share * profile.too_high, share * profile.too_low, median(profile.lengths), share * bootstrap.covered,
        share * bootstrap.too_high, share * bootstrap.too_low, median(bootstrap.lengths), profile_ms / sets,
        bootstrap_ms / sets, contradictions);
  }
};

/// Of the processor: others may use the machine.
double milliseconds() {
  return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void print_all(const std::map<std::string, Row>& rows) {
  for (const auto& [name, row] : rows) row.print(name);
  std::fflush(stdout);
}

TEST(PsychometricSimulated, TwentyThousandSetsWithoutAContradiction) {
  std::map<std::string, Row> rows;
  for (std::uint64_t seed = 0; seed < sets; ++seed) {
    const SimulatedSet set = test::simulated_set(seed);
    FitRequest request{.percents = {75}, .deviance_replicates = 0, .seed = seed};
    double start = milliseconds();
    const JudgedFit alone = judge_fit(set.counts, set.options, request);
    const double profile_ms = milliseconds() - start;
    request.bootstrap_replicates = replicates;
    request.percents.clear();
    start = milliseconds();
    const JudgedFit report = judge_fit(set.counts, set.options, request);
    const double bootstrap_ms = milliseconds() - start - profile_ms;
    std::string found = test::contradiction(alone);
    if (found.empty()) found = test::contradiction(report);
    EXPECT_EQ(found, "") << seed;
    const std::string place = test::place_words[static_cast<std::size_t>(set.place)];
    for (const std::string& name :
         {std::string("all"), place + ", " + std::to_string(set.trials) + " trials",
          std::string(test::sigmoid_words[set.sigmoid]),
          std::string(set.options.lapse.is_free() ? "lapse free" : "lapse known")}) {
      Row& row = rows[name];
      ++row.sets;
      row.steps += report.fit.is_step ? 1 : 0;
      row.contradictions += found.empty() ? 0 : 1;
      row.profile_ms += profile_ms;
      row.bootstrap_ms += bootstrap_ms;
      row.profile.add(report.threshold_ci95, set.planted.threshold);
      row.bootstrap.add(report.bootstrap->threshold, set.planted.threshold);
      if (!test::is_closed(report.threshold_ci95) || !test::is_closed(report.bootstrap->threshold)) continue;
      row.profile.lengths.push_back(test::length_in_gaps(set, report.threshold_ci95));
      row.bootstrap.lengths.push_back(test::length_in_gaps(set, report.bootstrap->threshold));
    }
    if ((seed + 1) % sets_between_tables == 0) print_all(rows);  // it runs for minutes: what is known so far
  }
  print_all(rows);
  for (std::int64_t trials : test::trials_a_level) {
    const Row& inside = rows.at("inside, " + std::to_string(trials) + " trials");
    EXPECT_GE(100.0 * inside.profile.covered / inside.sets, 93.5) << trials;
    EXPECT_GE(100.0 * inside.bootstrap.covered / inside.sets, 92) << trials;
  }
}

}  // namespace
}  // namespace seamline::analysis
