// The people that a plan assumes: expected means beside their own answers, and beside closed computations.
#include "analysis/foresight/assumed_people.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "analysis/foresight/simulated_answers.h"
#include "analysis/thresholds/planted_noticeability.h"
#include "study/observers/observer.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::analysis {
namespace {

const PlannedCurve receiver{.artifact = Artifact::receiver, .condition = "", .objects = 3, .midpoint = 300};

TEST(AssumedPeople, WhoAreTheThresholdObserversHaveTheirMeans) {
  for (const auto& [scale, sd] : {std::pair{0.5, 0.5}, std::pair{0.05, 0.8}, std::pair{1.0, 0.0}}) {
    PlannedPopulation population;
    population.observer.scale_octaves = scale;
    population.observer.people_sd_octaves = sd;
    for (const int width : test::paper_widths_px)
      EXPECT_NEAR(mean_noticeability(population, receiver, std::log2(width), JointMean::as_counted),
                  study::expected_noticeability(population.observer, Artifact::receiver, width), 1e-9)
          << scale << " " << sd << " " << width;
    const PlantedThresholds planted = planted_thresholds(population.observer, {}, 300, {64, 512, 4096});
    EXPECT_NEAR(true_crossing(population, receiver, 0.5, JointMean::as_counted), planted.perceptual_x, 1e-8);
    EXPECT_NEAR(true_crossing(population, receiver, 1.0, JointMean::as_counted),
                planted.slightly_noticeable_x, 1e-8);
  }
}

/// By the midpoint rule over two normal densities (threshold_people.h).
TEST(AssumedPeople, WhoseCriteriaDifferHaveTheMeansOfAnotherComputation) {
  test::Population other;
  other.rating_sd_octaves = 0.7;
  PlannedPopulation population;
  population.assumed.criteria_sd = 0.7;
  for (const int width : test::paper_widths_px)
    EXPECT_NEAR(mean_noticeability(population, receiver, std::log2(width), JointMean::as_counted),
                test::detail::expected(other, Artifact::receiver, width), 1e-6);
}

/// Everything at once: the mean of many simulated answers, corrected and not, within four standard errors.
TEST(AssumedPeople, AnswerAsTheirMeansSay) {
  PlannedPopulation population;
  population.assumed = {
      .lapse = 0.1, .slope_sd = 0.4, .criteria_sd = 0.5, .artifact_sd = 0.6, .high_guesses = 0.3};
  const std::vector<double> levels = {64, 256, 1024, 4096};
  constexpr int people = 4000;
  const SimulatedAnswers answers = simulate_answers(population, {receiver, receiver}, levels, people, 7, 0);
  const double guess_rating = mean_guess_rating(answers, people);
  EXPECT_NEAR(guess_rating, 1.3, 0.02);
  for (const bool corrected : {false, true}) {
    const Eigen::MatrixXd scores =
        scores_of(answers, 1, people, corrected ? std::optional(1.3) : std::nullopt);
    for (std::size_t level = 0; level < levels.size(); ++level) {
      const Eigen::VectorXd column = scores.col(static_cast<Eigen::Index>(level));
      const CellMean mean = mean_over_participants({column.begin(), column.end()});
      EXPECT_NEAR(mean.mean,
                  mean_noticeability(population, receiver, std::log2(levels[level]),
                                     corrected ? JointMean::seen : JointMean::as_counted),
                  4 * mean.sem)
          << corrected << " " << levels[level];
    }
  }
}

/// A study without further assumptions draws the answers of `make_observer` and `respond`, one for one.
TEST(AssumedPeople, WithoutFurtherAssumptionsAnswerDrawForDraw) {
  const PlannedPopulation population;
  const std::vector<double> levels = {64, 300, 512, 4096};
  const SimulatedAnswers answers = simulate_answers(population, {receiver}, levels, 20, 3, 5);
  for (int p = 0; p < 20; ++p) {
    Random random(3, 5 + static_cast<std::uint64_t>(p));
    const study::Observer person =
        study::make_observer(study::ObserverKind::threshold, population.observer, random);
    for (std::size_t level = 0; level < levels.size(); ++level) {
      double sum = 0;
      for (int object = 1; object <= 3; ++object) {
        Stimulus stimulus;
        stimulus.artifact = Artifact::receiver;
        stimulus.level = levels[level];
        stimulus.object_index = object;
        const study::Response response = study::respond(person, stimulus, random);
        if (response.chosen_index == object) sum += response.rating;
      }
      EXPECT_EQ(scores_of(answers, 0, 20, {})(p, static_cast<Eigen::Index>(level)), sum / 3);
    }
  }
}

TEST(AssumedPeople, AreSaidInWords) {
  PlannedPopulation population;
  const std::string plain = assumptions_text(population, {receiver});
  EXPECT_NE(plain.find("receiver 300 with a standard deviation of 0.5 octaves"), std::string::npos) << plain;
  EXPECT_NE(plain.find("There are no lapses."), std::string::npos);
  population.assumed.lapse = 0.02;
  EXPECT_NE(assumptions_text(population, {receiver}).find("In 2 % of the trials"), std::string::npos);
}

}  // namespace
}  // namespace seamline::analysis
