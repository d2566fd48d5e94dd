#pragma once
#include <array>
#include <cmath>

#include "analysis/psychometric/intervals/pooled_fit.h"
#include "support/arithmetic/random.h"

namespace seamline::test {
using namespace analysis;
using namespace study;

inline constexpr std::array<double, 7> widths_64_to_4096_px = {64, 128, 256, 512, 1024, 2048, 4096};

/// A group whose thresholds differ: each person's performance falls with width around their own threshold.
struct Group {
  Sigmoid sigmoid = Sigmoid::normal;
  double threshold_px = 512;
  double people_sd_octaves = 0.8;
  double scale_octaves = 0.7;
  double lapse = 0.02;
  int people = 20;
  int trials_per_width = 3;  ///< one for each of the study's three objects
};

inline PsychometricFunction person_of(const Group& group, double shift_octaves) {
  return {.sigmoid = group.sigmoid,
          .axis = Axis::log2,
          .direction = Direction::decreasing,
          .threshold = group.threshold_px * std::exp2(shift_octaves),
          .scale = group.scale_octaves,
          .guess = 1.0 / 3,
          .lapse = group.lapse};
}

inline FitOptions group_options() {
  FitOptions options = options_for_alternatives(3);
  options.direction = Direction::decreasing;
  return options;
}

/// The threshold of the function fitted to what the group is expected to answer: what an interval must hold.
inline double planted_threshold_px(const Group& group) {
  std::vector<LevelCounts> expected;
  for (double width_px : widths_64_to_4096_px) {
    double sum = 0, weights = 0;
    for (double z = -6; z <= 6; z += 0.05) {
      const double weight = std::exp(-z * z / 2);
      sum += weight * response_probability(person_of(group, z * group.people_sd_octaves), width_px);
      weights += weight;
    }
    constexpr std::int64_t trials = 1'000'000'000;
    expected.push_back({.level = width_px,
                        .correct = std::llround(static_cast<double>(trials) * sum / weights),
                        .trials = trials});
  }
  return fit_psychometric(expected, group_options()).function.threshold;
}

inline PooledChoices simulate_group(const Group& group, std::uint64_t seed) {
  PooledChoices choices;
  choices.level.assign(widths_64_to_4096_px.begin(), widths_64_to_4096_px.end());
  choices.correct = choices.trials =
      Eigen::MatrixXd::Zero(group.people, static_cast<Eigen::Index>(choices.level.size()));
  for (int person = 0; person < group.people; ++person) {
    Random random(seed, static_cast<std::uint64_t>(person));
    const PsychometricFunction function = person_of(group, group.people_sd_octaves * random.normal());
    choices.people.push_back("p" + std::to_string(person));
    for (std::size_t i = 0; i < choices.level.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      choices.trials(person, column) = group.trials_per_width;
      choices.correct(person, column) =
          random.binomial(group.trials_per_width, response_probability(function, choices.level[i]));
    }
  }
  return choices;
}

}  // namespace seamline::test
