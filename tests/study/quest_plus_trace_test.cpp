// One run of the questplus package, step by step: 3AFC Weibull on log10 widths.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "study/placement/quest_plus_grid.h"

namespace seamline::study {
namespace {

using nlohmann::json;

constexpr std::array<const char*, 4> names = {"threshold", "slope", "lapse_rate", "lower_asymptote"};

QuestPlusGrid grid_of(const json& trace) {
  QuestPlusGrid grid;
  for (std::size_t i = 0; i < names.size(); ++i)
    grid.values[i] = trace["param_grid"][names[i]].get<std::vector<double>>();
  grid.values.back() = {0};  // no ratings
  return grid;
}

/// 1 - l - (1 - g - l) exp(-10^(b (x - t)))
double weibull(const QuestPlusGrid& grid, int point, double x) {
  const double t = grid.value(Parameter::threshold, point), b = grid.value(Parameter::scale, point);
  const double l = grid.value(Parameter::lapse, point), g = grid.value(Parameter::guess, point);
  return 1 - l - (1 - g - l) * std::exp(-std::pow(10, b * (x - t)));
}

TEST(QuestPlusTrace, ChoosesTheSameStimuliAndFindsTheSameMeans) {
  std::ifstream in(SEAMLINE_SOURCE_DIR "/tests/data/questplus_traces.json");
  const json traces = json::parse(in);
  ASSERT_FALSE(traces["cases"].empty());
  double largest_error = 0;
  for (const json& trace : traces["cases"]) {
    const QuestPlusGrid grid = grid_of(trace);
    const auto stimuli = trace["stim_grid"].get<std::vector<double>>();
    const QuestPlusTables tables = make_quest_plus_tables(
        static_cast<int>(stimuli.size()), 2, grid.points(), [&](int stimulus, int point) {
          const double yes = weibull(grid, point, stimuli[static_cast<std::size_t>(stimulus)]);
          return std::vector<double>{1 - yes, yes};
        });
    QuestPlusPosterior posterior = uniform_posterior(grid.points());
    ASSERT_GE(trace["steps"].size(), 40U);
    for (const json& step : trace["steps"]) {
      const std::vector<double> expected = expected_entropies_nats(tables, posterior);
      const auto least = std::min_element(expected.begin(), expected.end());
      ASSERT_EQ(least - expected.begin(), step["stim_index"].get<int>());
      EXPECT_NEAR(*least, step["expected_entropy_min"].get<double>(), 1e-9);
      learn(posterior, tables, step["stim_index"].get<int>(), step["response"].get<int>());
      for (std::size_t i = 0; i < names.size(); ++i) {
        const double error = std::abs(moments(grid, posterior, every_parameter[i]).mean -
                                      step["post_mean"][names[i]].get<double>());
        EXPECT_LE(error, 1e-9);
        largest_error = std::max(largest_error, error);
      }
    }
    EXPECT_NEAR(entropy_nats(posterior.mass), trace["final"]["posterior_entropy_nats"].get<double>(), 1e-9);
    for (std::size_t i = 0; i < names.size(); ++i)
      EXPECT_NEAR(moments(grid, posterior, every_parameter[i]).sd,
                  trace["final"]["sd"][names[i]].get<double>(), 1e-9);
  }
  RecordProperty("largest_error_of_a_mean", std::to_string(largest_error));
  std::printf("largest error of a posterior mean: %.2g\n", largest_error);
}

}  // namespace
}  // namespace seamline::study
