// Mixed models over participants, and differences between groups.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/ordinal/likelihood/gauss_hermite.h"
#include "analysis/psychometric/likelihood/binomial_sampler.h"
#include "analysis/psychometric/people/group_differences.h"
#include "analysis/psychometric/people/people_likelihood.h"
#include "study/placement/sigmoid_shape.h"
#include "support/arithmetic/random.h"
#include "support/text/numbers.h"

namespace seamline::analysis {
namespace {

/// What is planted: thresholds of people normal on a linear axis from -3 to 3.
struct PlantedPeople {
  int people = 12, trials = 20;
  double mean = 0, sd = 0.6, scale = 0.8, log_scale_sd = 0.3, guess = 0.5, lapse = 0.02;
};

double standard_normal(Random& random) {
  return study::sigmoid_quantile(Sigmoid::normal, std::clamp(random.uniform(), 1e-12, 1 - 1e-12));
}

std::vector<std::vector<LevelCounts>> simulated_people(const PlantedPeople& planted, std::uint64_t seed) {
  std::vector<std::vector<LevelCounts>> people;
  for (int person = 0; person < planted.people; ++person) {
    Random random(seed, static_cast<std::uint64_t>(person));
    const double m = planted.mean + planted.sd * standard_normal(random);
    const double s = planted.scale * std::exp(planted.log_scale_sd * standard_normal(random));
    std::vector<LevelCounts> counts;
    for (int i = -3; i <= 3; ++i) {
      const double p = planted.guess + (1 - planted.guess - planted.lapse) *
                                           study::sigmoid_value(Sigmoid::normal, (i - m) / s);
      counts.push_back({.level = static_cast<double>(i),
                        .correct = sample_binomial(planted.trials, p, random),
                        .trials = planted.trials});
    }
    people.push_back(counts);
  }
  return people;
}

FitOptions options_of(const PlantedPeople& planted) {
  FitOptions options;
  options.axis = study::Axis::linear;
  options.direction = study::Direction::increasing;
  options.guess = fixed_rate(planted.guess);
  options.lapse = fixed_rate(planted.lapse);
  return options;
}

std::vector<LevelCounts> together(const std::vector<std::vector<LevelCounts>>& people) {
  std::vector<LevelCounts> all;
  for (const auto& one : people) all.insert(all.end(), one.begin(), one.end());
  return all;
}

PeopleFit fit_of(const std::vector<std::vector<LevelCounts>>& people, const FitOptions& options) {
  return fit_people(fit_psychometric(together(people), options), people);
}

FittedGroup group_of(const std::vector<std::vector<LevelCounts>>& people, const FitOptions& options,
                     std::size_t first_person) {
  FittedGroup group;
  group.sums.fit = fit_psychometric(together(people), options);
  for (std::size_t p = 0; p < people.size(); ++p) group.people.push_back(first_person + p);
  group.mixed = fit_people(group.sums.fit, people);
  return group;
}

/// The integral by brute force: sums over a fine grid of both effects.
double brute_force(const FitProblem& person, const PeopleTheta& theta) {
  constexpr double step = 0.05;
  double largest = -infinity, sum = 0;
  for (int pass = 0; pass < 2; ++pass)
    for (int i = -140; i <= 140; ++i)
      for (int j = -140; j <= 140; ++j) {
        const double u = i * step, v = j * step;
        const double height =
            log_likelihood(person, {theta[0] + theta[4] * u, theta[1] + theta[5] * v, theta[2], theta[3]},
                           0) -
            (u * u + v * v) / 2;
        if (pass == 0)
          largest = std::max(largest, height);
        else
          sum += std::exp(height - largest);
      }
  return largest + std::log(sum * step * step / (2 * std::numbers::pi));
}

TEST(PsychometricPeople, TheIntegralIsThatOfBruteForce) {
  const PlantedPeople planted{.people = 3, .trials = 8};
  const auto people = simulated_people(planted, 5);
  const PsychometricFit sums = fit_psychometric(together(people), options_of(planted));
  const PeopleProblem problem = make_people_problem(sums.search.problem, people);
  PeopleTheta theta;
  theta << 0.02, std::log(0.15), 0.02, 0.5, 0.12, 0.35;
  for (const FitProblem& person : problem.each)
    EXPECT_NEAR(person_part(person, theta, people_quadrature_nodes).value, brute_force(person, theta), 2e-4);
  for (const FitProblem& person : problem.each)
    EXPECT_NEAR(person_part(person, theta, 25).value, brute_force(person, theta), 2e-6);
}

TEST(PsychometricPeople, DerivativesAreThoseOfTheValue) {
  const PlantedPeople planted{.people = 3, .trials = 12};
  const auto people = simulated_people(planted, 6);
  const PsychometricFit sums = fit_psychometric(together(people), options_of(planted));
  const FitProblem person = make_people_problem(sums.search.problem, people).each[1];
  PeopleTheta theta;
  theta << 0.02, std::log(0.15), 0.02, 0.5, 0.12, 0.35;
  const PersonPart part = person_part(person, theta, 25);
  for (int i = 0; i < 6; ++i) {
    PeopleTheta up = theta, down = theta;
    up[i] += 1e-4;
    down[i] -= 1e-4;
    const PersonPart above = person_part(person, up, 25), below = person_part(person, down, 25);
    EXPECT_NEAR(part.gradient[i], (above.value - below.value) / 2e-4, 1e-4 * (1 + std::abs(part.gradient[i])))
        << i;
    const PeopleTheta column = (above.gradient - below.gradient) / 2e-4;
    for (int j = 0; j < 6; ++j)
      EXPECT_NEAR(part.hessian(i, j), column[j], 3e-3 * (1 + std::abs(column[j]))) << i << j;
  }
}

TEST(PsychometricPeople, IntervalsOverParticipantsHoldThePlantedMean) {
  constexpr int sets = 60;
  int identified = 0, held = 0, width_held = 0;
  double bias = 0;
  for (int set = 0; set < sets; ++set) {
    const PlantedPeople planted{.people = 8};
    const PeopleFit fit =
        fit_of(simulated_people(planted, 100 + static_cast<std::uint64_t>(set)), options_of(planted));
    if (!fit.identified) continue;
    ++identified;
    held += fit.threshold_ci95.low <= 0 && 0 <= fit.threshold_ci95.high ? 1 : 0;
    const double width = planted.scale * study::scales_in_width(Sigmoid::normal);
    width_held += fit.width_ci95.low <= width && width <= fit.width_ci95.high ? 1 : 0;
    bias += fit.threshold / sets;
  }
  EXPECT_GE(identified, 57);
  EXPECT_GE(held, 52);  // 95 % of 60 is 57, standard error 1.7
  EXPECT_GE(width_held, 52);
  EXPECT_NEAR(bias, 0, 0.12);
}

TEST(PsychometricPeople, PeopleAreDrawnTowardsTheMean) {
  const PlantedPeople planted{.people = 10, .trials = 6, .sd = 1};
  const auto people = simulated_people(planted, 9);
  const PeopleFit fit = fit_of(people, options_of(planted));
  ASSERT_TRUE(fit.identified) << fit.why;
  double squares = 0;
  for (const PersonEstimate& one : fit.each) {
    squares += (one.threshold - fit.threshold) * (one.threshold - fit.threshold) / 10;
    EXPECT_LT(one.threshold_ci95.low, one.threshold);
    EXPECT_GT(one.threshold_ci95.high, one.threshold);
  }
  EXPECT_LT(std::sqrt(squares), fit.threshold_sd);
  EXPECT_GT(std::sqrt(squares), 0.3 * fit.threshold_sd);
}

TEST(PsychometricPeople, NoModelWithoutPeopleWhoDiffer) {
  const PlantedPeople planted{.people = 2};
  EXPECT_EQ(fit_of(simulated_people(planted, 1), options_of(planted)).why,
            "2 participants, and how people differ takes at least three");
  const PlantedPeople chance{.people = 6, .guess = 0.5, .lapse = 0.49};
  auto people = simulated_people(chance, 2);
  const PeopleFit flat = fit_of(people, options_of({}));
  EXPECT_FALSE(flat.identified);
  EXPECT_FALSE(flat.why.empty());
}

/// The same people in two conditions: their differences vary less than they do.
TEST(PsychometricPeople, WithinParticipantsTheDifferenceIsThatOfEachPerson) {
  const PlantedPeople before{.people = 9, .trials = 400, .sd = 1, .log_scale_sd = 0};
  PlantedPeople after = before;
  after.mean = 0.3;  // the same seed: the same people, each moved by as much
  const FittedGroup first = group_of(simulated_people(before, 77), options_of(before), 0);
  const std::vector<FittedGroup> within = {first,
                                           group_of(simulated_people(after, 77), options_of(after), 0)};
  const std::vector<FittedGroup> between = {first,
                                            group_of(simulated_people(after, 77), options_of(after), 9)};
  const GroupDifference paired = group_pairs(within).front().threshold,
                        apart = group_pairs(between).front().threshold;
  ASSERT_TRUE(paired.estimate && apart.estimate);
  EXPECT_NEAR(*paired.estimate, 0.3, 0.1);
  EXPECT_EQ(*paired.estimate, *apart.estimate);
  EXPECT_LT(paired.ci95.high - paired.ci95.low, 0.5 * (apart.ci95.high - apart.ci95.low));
  EXPECT_LT(paired.p, 0.01);
  EXPECT_GT(apart.p, 0.05);
}

TEST(PsychometricPeople, PAgreesWithTheIntervalAndIsAdjustedOverPairs) {
  const PlantedPeople planted{.people = 1, .trials = 60};
  std::vector<FittedGroup> groups;
  for (const double mean : {0.0, 0.1, 0.9}) {
    PlantedPeople one = planted;
    one.mean = mean;
    one.sd = 0;
    FittedGroup group;
    group.sums = judge_fit(together(simulated_people(one, 31)), options_of(one), {.deviance_replicates = 0});
    groups.push_back(group);
  }
  const std::vector<GroupPair> pairs = group_pairs(groups);
  ASSERT_EQ(pairs.size(), 3U);
  for (const GroupPair& pair : pairs)
    for (const GroupDifference* difference : {&pair.threshold, &pair.log2_width}) {
      ASSERT_TRUE(difference->estimate);
      if (std::isnan(difference->p)) continue;  // a width that may be 0 has no ratio
      const bool excludes_zero = difference->ci95.low > 0 || difference->ci95.high < 0;
      EXPECT_EQ(difference->p < 0.05, excludes_zero);
      EXPECT_GE(difference->adjusted_p, difference->p);
      EXPECT_LE(difference->adjusted_p, 1);
    }
  EXPECT_LT(pairs[1].threshold.adjusted_p, 0.05);  // 0.0 and 0.9
}

}  // namespace
}  // namespace seamline::analysis
