#include "analysis/thresholds/guess_correction.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/analysis/guessing_people.h"

namespace seamline::analysis {
namespace {

using namespace study;
using test::corrected;
using test::GuessingLog;
using test::GuessingStudy;
using test::simulate_guessing;
using test::true_noticeability;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Guessers habits_of(const GuessingStudy& study) {
  Guessers guessers;
  guessers.position.assign(study.habits.position.begin(), study.habits.position.end());
  guessers.rating = study.habits.rating;
  guessers.wrong_answers = 1;
  guessers.position_estimated = true;
  return guessers;
}

/// Root mean square distances over all cells: of the corrected and the uncorrected curve from what the same
/// people saw, and from what the population sees.
struct Distance {
  double corrected_seen = 0, uncorrected_seen = 0, corrected_population = 0, uncorrected_population = 0;
};

/// Mean over a cell's answers of the rating of those who saw, 0 for who did not.
double seen_noticeability(const GuessingLog& simulated, Artifact artifact, int width_px) {
  double sum = 0, answers = 0;
  for (std::size_t i = 0; i < simulated.log.answers.size(); ++i) {
    const Answer& answer = simulated.log.answers[i];
    if (answer.artifact != artifact || answer.depth_width_px != width_px) continue;
    sum += simulated.seen[i] ? answer.rating : 0;
    answers += 1;
  }
  return sum / answers;
}

Distance distance_from_truth(const GuessingStudy& study, std::uint64_t seed) {
  const GuessingLog simulated = simulate_guessing(study, seed);
  const NoticeabilityData data = average_answers(simulated.log, select_participants(simulated.log, false));
  const GuessCorrection correction = corrected(simulated);
  Distance sum;
  for (std::size_t a = 0; a < data.artifacts.size(); ++a)
    for (std::size_t w = 0; w < data.artifacts[a].level.size(); ++w) {
      const Artifact artifact = data.artifacts[a].artifact;
      const int width_px = static_cast<int>(data.artifacts[a].level[w]);
      const double here = correction.curves[a].cells[w].noticeability,
                   plain = data.artifacts[a].cells[w].mean;
      const double seen = seen_noticeability(simulated, artifact, width_px);
      const double population = true_noticeability(study.population, artifact, width_px);
      sum.corrected_seen += std::pow(here - seen, 2);
      sum.uncorrected_seen += std::pow(plain - seen, 2);
      sum.corrected_population += std::pow(here - population, 2);
      sum.uncorrected_population += std::pow(plain - population, 2);
    }
  return {.corrected_seen = std::sqrt(sum.corrected_seen / 28),
          .uncorrected_seen = std::sqrt(sum.uncorrected_seen / 28),
          .corrected_population = std::sqrt(sum.corrected_population / 28),
          .uncorrected_population = std::sqrt(sum.uncorrected_population / 28)};
}

TEST(GuessCorrection, IsNearerToTheTruthThanTheUncorrectedCurve) {
  Distance mean;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Distance distance = distance_from_truth({}, seed);
    EXPECT_LT(distance.corrected_seen, 0.5 * distance.uncorrected_seen) << seed;
    EXPECT_LT(distance.corrected_population, distance.uncorrected_population) << seed;
    mean.corrected_seen += distance.corrected_seen / 20;
    mean.uncorrected_seen += distance.uncorrected_seen / 20;
    mean.corrected_population += distance.corrected_population / 20;
    mean.uncorrected_population += distance.uncorrected_population / 20;
  }
  std::printf("distance from what was seen %.3f (uncorrected %.3f), from the population %.3f (%.3f)\n",
              mean.corrected_seen, mean.uncorrected_seen, mean.corrected_population,
              mean.uncorrected_population);
}

TEST(GuessCorrection, RecoversWhoSawAndHowTheyRated) {
  GuessingStudy study;
  study.people = 1000;
  const GuessingLog simulated = simulate_guessing(study, 1);
  const GuessCorrection correction = corrected(simulated);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(correction.guessers.position[c], study.habits.position[c], 0.01);
  for (std::size_t r = 0; r < 4; ++r)
    EXPECT_NEAR(correction.guessers.rating[r], study.habits.rating[r], 0.01);
  for (const CorrectedCurve& curve : correction.curves)
    for (std::size_t w = 0; w < curve.cells.size(); ++w) {
      double seen = 0, answers = 0;
      for (std::size_t i = 0; i < simulated.log.answers.size(); ++i) {
        const Answer& answer = simulated.log.answers[i];
        if (answer.artifact != curve.artifact || answer.depth_width_px != curve.level[w]) continue;
        answers += 1;
        seen += simulated.seen[i] ? 1 : 0;
      }
      EXPECT_NEAR(curve.cells[w].saw, seen / answers, 0.05);
      EXPECT_NEAR(curve.cells[w].noticeability,
                  seen_noticeability(simulated, curve.artifact, static_cast<int>(curve.level[w])), 0.08);
    }
}

TEST(GuessCorrection, EasyObjectsAreNotMistakenForPositionBias) {
  GuessingStudy study;
  study.habits.position = {1.0 / 3, 1.0 / 3, 1.0 / 3};
  study.people = 1000;
  study.object_shift_octaves = 0.7;
  for (double share : corrected(simulate_guessing(study, 2)).guessers.position)
    EXPECT_NEAR(share, 1.0 / 3, 0.01);
}

/// Where no bound is touched and positions are equal, the fit is the moment estimate: mean score less half
/// the guessers' mean rating for each wrong choice.
TEST(GuessCorrection, EqualsTheMomentEstimateWithinBounds) {
  Guessers guessers = habits_of({});
  guessers.position = {1.0 / 3, 1.0 / 3, 1.0 / 3};
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(CellShape{}.of_cell());
  double right = 0, wrong = 0;
  for (int o = 1; o <= 3; ++o)
    for (int r = 1; r <= 4; ++r) {
      counts[CellShape{}.place(o, o, r)] = 10 + r;
      right += r * (10 + r);
      counts[CellShape{}.place(o, o % 3 + 1, r)] = r <= 3 ? 4 : 0;
      wrong += r <= 3 ? 4 : 0;
    }
  const SeeingCell cell = fit_seeing(counts.data(), guessers);
  EXPECT_TRUE(cell.converged);
  EXPECT_NEAR(cell.saw, 1 - 1.5 * wrong / counts.sum(), 1e-6);
  EXPECT_NEAR(cell.noticeability, (right - wrong * guessers.mean_rating() / 2) / counts.sum(), 1e-6);
}

TEST(GuessCorrection, EachStepOfEmIncreasesTheLikelihood) {
  const GuessingLog simulated = simulate_guessing({}, 3);
  const NoticeabilityData data = average_answers(simulated.log, select_participants(simulated.log, false));
  const GuessTrials trials = count_guess_trials(simulated.log, data, {});
  const Eigen::VectorXd counts = trials.answers.colwise().sum().transpose();
  const Guessers guessers = estimate_guessers(counts, Eigen::VectorXd::Zero(CellShape{}.of_trial()));
  for (std::size_t c = 0; c < trials.cells.size(); ++c) {
    std::vector<double> trace;
    const SeeingCell cell = fit_seeing(counts.data() + c * CellShape{}.of_cell(), guessers, 1e-8, &trace);
    EXPECT_TRUE(cell.converged) << c;
    for (std::size_t i = 1; i < trace.size(); ++i) EXPECT_GE(trace[i], trace[i - 1] - 1e-9) << c << " " << i;
    EXPECT_GT(trace.back(), trace.front() - 1e-9);
  }
}

/// The log likelihood is concave in s q(r), so no other point near or far may be better than the fit.
TEST(GuessCorrection, FindsTheMaximum) {
  const GuessingLog simulated = simulate_guessing({}, 4);
  const NoticeabilityData data = average_answers(simulated.log, select_participants(simulated.log, false));
  const GuessTrials trials = count_guess_trials(simulated.log, data, {});
  const Eigen::VectorXd counts = trials.answers.colwise().sum().transpose();
  const Guessers guessers = habits_of({});
  Random random(5);
  for (std::size_t c = 0; c < trials.cells.size(); ++c) {
    const double* of_cell = counts.data() + c * CellShape{}.of_cell();
    const SeeingCell cell = fit_seeing(of_cell, guessers);
    for (int tried = 0; tried < 200; ++tried) {
      double s = random.uniform(), total = 0, log_likelihood = 0;
      std::array<double, 4> q{};
      for (double& part : q) total += part = -std::log(1 - random.uniform());
      for (int place = 0; place < CellShape{}.of_cell(); ++place) {
        const auto o = static_cast<std::size_t>(place / 12),
                   chosen = static_cast<std::size_t>(place % 12 / 4), r = static_cast<std::size_t>(place % 4);
        const double guess = (1 - s) * guessers.position[chosen] * guessers.rating[r];
        if (of_cell[place] > 0)
          log_likelihood += of_cell[place] * std::log(guess + (o == chosen ? s * q[r] / total : 0));
      }
      EXPECT_LE(log_likelihood, cell.log_likelihood + 1e-4) << c;
    }
  }
}

TEST(GuessCorrection, WithoutAWrongChoiceIsTheUncorrectedCurveAndSaysSo) {
  GuessingLog simulated = simulate_guessing({}, 6);
  for (Answer& answer : simulated.log.answers) answer.chosen_index = answer.object_index;
  const NoticeabilityData data = average_answers(simulated.log, select_participants(simulated.log, false));
  const GuessCorrection correction = corrected(simulated);
  EXPECT_FALSE(correction.guessers.known());
  EXPECT_THAT(correction.notes, Contains(HasSubstr("Nobody chose wrong")));
  for (std::size_t w = 0; w < 7; ++w)
    EXPECT_NEAR(correction.curves[0].cells[w].noticeability, data.artifacts[0].cells[w].mean, 1e-9);
}

TEST(GuessCorrection, WhenEveryoneGuessesNobodyIsSaidToHaveSeen) {
  GuessingStudy study;
  for (auto& [artifact, midpoint_px] : study.population.observer.midpoint) midpoint_px = 0.01;
  const GuessCorrection correction = corrected(simulate_guessing(study, 7), {.replicates = 300});
  for (const CorrectedCurve& curve : correction.curves) {
    EXPECT_FALSE(curve.above_chance) << word(curve.artifact);
    EXPECT_EQ(curve.estimates.perceptual.reason, NoThreshold::curve_below) << word(curve.artifact);
    EXPECT_EQ(curve.estimates.perceptual.ci95.low_x, below_every_level);
  }
  EXPECT_THAT(correction.notes, Contains(HasSubstr("not shown to be more than by guessing")));
}

/// Few people who are nearly always right are not enough for a test at 1 %: that is no proof of chance.
TEST(GuessCorrection, ATestOfTwoPeopleNeverSaysThatTheyGuessed) {
  GuessingStudy study;
  for (auto& [artifact, midpoint_px] : study.population.observer.midpoint) midpoint_px = 1e4;
  study.people = 2;
  bool some = false;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    for (const std::string& note : corrected(simulate_guessing(study, seed), {.replicates = 20}).notes) {
      EXPECT_THAT(note, testing::Not(HasSubstr("describes chance")));
      some = some || note.find("% of the answers (by guessing") != std::string::npos;
    }
  EXPECT_TRUE(some);
}

TEST(GuessCorrection, WarnsWhenGuessersRateSoHighThatAThresholdIsChance) {
  GuessingStudy study;
  study.habits.rating = {0.4, 0.3, 0.2, 0.1};
  EXPECT_THAT(corrected(simulate_guessing(study, 8)).notes, Contains(HasSubstr("Read the corrected PT")));
  EXPECT_THAT(corrected(simulate_guessing({}, 8)).notes, IsEmpty());
}

TEST(GuessCorrection, ReferenceTrialsAreGuesses) {
  GuessingStudy with;
  with.references = 40;
  GuessingLog simulated = simulate_guessing(with, 9);
  for (Answer& answer : simulated.log.answers) answer.chosen_index = answer.object_index;
  const Guessers guessers = corrected(simulated).guessers;
  EXPECT_EQ(guessers.reference_answers, 800);
  EXPECT_EQ(guessers.wrong_answers, 0);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(guessers.position[c], with.habits.position[c], 0.06);
  for (std::size_t r = 0; r < 4; ++r) EXPECT_NEAR(guessers.rating[r], with.habits.rating[r], 0.06);
}

TEST(GuessCorrection, OfOneRightPositionAssumesEqualPositions) {
  GuessingLog simulated = simulate_guessing({}, 10);
  std::erase_if(simulated.log.answers, [](const Answer& answer) { return answer.object_index != 2; });
  const GuessCorrection correction = corrected(simulated);
  EXPECT_FALSE(correction.guessers.position_estimated);
  EXPECT_THAT(correction.notes, Contains(HasSubstr("equal positions are assumed")));
}

TEST(GuessCorrection, IsTheSameForAnyNumberOfThreads) {
  const GuessingLog simulated = simulate_guessing({}, 11);
  const GuessCorrection one = corrected(simulated, {.replicates = 200, .seed = 3, .threads = 1});
  const GuessCorrection three = corrected(simulated, {.replicates = 200, .seed = 3, .threads = 3});
  for (std::size_t a = 0; a < 4; ++a) {
    EXPECT_EQ(one.curves[a].perceptual_bootstrap.low_x, three.curves[a].perceptual_bootstrap.low_x);
    EXPECT_EQ(one.curves[a].estimates.inflection.ci95.high_x,
              three.curves[a].estimates.inflection.ci95.high_x);
  }
}

}  // namespace
}  // namespace seamline::analysis
