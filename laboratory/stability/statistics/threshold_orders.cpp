// Orders of what is estimated from people.
#include <cmath>

#include "analysis/thresholds/thresholds.h"
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/orders.h"
#include "laboratory/stability/statistics/curve_fit_cases.h"
#include "laboratory/stability/statistics/rating_cases.h"
#include "support/arithmetic/random.h"

namespace seamline::stability {
namespace {

double standard_deviation(const std::vector<double>& values) {
  double mean = 0, squares = 0;
  for (const double value : values) mean += value / values.size();
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / (values.size() - 1));
}

}  // namespace

OrderSeries perceptual_threshold_order() {
  return {.name = "threshold-participants",
          .line = "PT, participants",
          .tried = "the standard deviation of PT over 200 studies of 20 to 1,280 simulated people",
          .expected = -0.5,
          .tolerance = 0.08,
          .reason =
              "a standard deviation of 200 is known to 5 %, the exponent over a factor of 64 to 0.016; "
              "PT of 20 people is not quite normal; five times that",
          .panel = 2,
          .measure = [] {
            std::vector<std::pair<double, double>> points;
            for (int people = 20; people <= 1280; people *= 4) {
              std::vector<double> thresholds;
              for (std::uint64_t study = 0; study < 200; ++study) {
                const ArtifactScores scores =
                    simulated_scores(people, 1000 * study + static_cast<std::uint64_t>(people));
                std::vector<double> means;
                for (const CellMean& cell : scores.cells) means.push_back(cell.mean);
                const ThresholdEstimate estimate =
                    thresholds_of_means(levels_on_axis(scores), means).perceptual;
                thresholds.push_back(estimate.level_x.value());
              }
              points.emplace_back(people, standard_deviation(thresholds));
            }
            return points;
          }};
}

OrderSeries fitted_threshold_order() {
  return {
      .name = "threshold-answers",
      .line = "fitted threshold, answers a level",
      .tried =
          "the standard deviation of a fitted threshold over 100 data sets of 40 to 2,560 answers a level",
      .expected = -0.5,
      .tolerance = 0.1,
      .reason =
          "a standard deviation of 100 is known to 7 %, the exponent over a factor of 64 to 0.023; four "
          "times that",
      .panel = 2,
      .measure = [] {
        std::vector<std::pair<double, double>> points;
        for (int answers = 40; answers <= 2560; answers *= 4) {
          std::vector<double> thresholds;
          for (std::uint64_t set = 0; set < 100; ++set) {
            Random random(answers, set);
            std::vector<LevelCounts> counts = counts_at_widths(answers, [](double) { return 0.0; });
            for (LevelCounts& level : counts)
              level.correct =
                  random.binomial(answers, response_probability(planted_function(0.02), level.level));
            thresholds.push_back(
                std::log2(fit_psychometric(counts, falling_choice_of_three()).function.threshold));
          }
          points.emplace_back(answers, standard_deviation(thresholds));
        }
        return points;
      }};
}

}  // namespace seamline::stability
