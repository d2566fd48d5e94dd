// Thresholds of the group where levels were placed by the answers: they hold where the mean noticeability of
// people who are not the model truly crosses, and pooled curves do not.
#include "analysis/joint/joint_placed.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "analysis/joint/joint_sharing.h"
#include "analysis/joint/joint_thresholds.h"
#include "tests/analysis/true_people.h"

namespace seamline::analysis {
namespace {

constexpr std::array<double, 7> levels_x = {6, 7, 8, 9, 10, 11, 12};

/// Answers of people on one curve. A level is left for the next harder one when the object was found, and for
/// the next easier one when it was missed, with a rating that pushes further: levels follow the person.
JointData staircase_answers(const test::TruePeople& people, int count, int trials, std::uint64_t seed) {
  JointData data{.curves = {"receiver"}, .people = {}, .cells = {}, .answers = {}, .references = {}};
  for (const double x : levels_x) data.cells.push_back({.curve = 0, .x = x});
  data.answers =
      Eigen::MatrixXd::Zero(count, static_cast<Eigen::Index>(levels_x.size()) * data.cell_counts());
  data.references = Eigen::MatrixXd::Zero(count, data.ratings);
  for (int person = 0; person < count; ++person) {
    Random random(seed, static_cast<std::uint64_t>(person));
    data.people.push_back(std::to_string(person));
    const double middle = std::log2(people.midpoint_px[0]) + people.people_sd * random.normal();
    const double rating_shift = people.rating_sd * random.normal();
    int level = 3;
    for (int trial = 0; trial < trials; ++trial) {
      const double d = (middle - levels_x[static_cast<std::size_t>(level)]) / people.scale_octaves;
      const double u = random.uniform();
      const bool seen = u < test::detail::seen_share(people.seeing, d);
      const bool right = seen || random.below(3) == 0;
      int rating = 1;
      for (int k = 1; seen && k < 4; ++k)
        rating +=
            u < test::detail::seen_and_rated(people, d, d + rating_shift / people.scale_octaves, k) ? 1 : 0;
      data.answers(person, level * data.cell_counts() + (right ? 0 : data.ratings) + rating - 1) += 1;
      level = std::clamp(level + (right ? (rating > 2 ? 2 : rating > 1 ? 1 : 0) : -1), 0, 6);
    }
  }
  return data;
}

const JointThreshold& of(const std::vector<JointThreshold>& rows, JointQuantity quantity) {
  return *std::find_if(rows.begin(), rows.end(),
                       [&](const JointThreshold& row) { return row.quantity == quantity; });
}

TEST(JointPlaced, IntervalsHoldTheTrueCrossingWherePooledCurvesDoNot) {
  for (const test::TruePeople& people :
       {test::TruePeople{}, test::TruePeople{.name = "unlike", .people_sd = 0.8}}) {
    constexpr int studies = 12;
    const double truth = std::log2(people.midpoint_px[0]) + test::true_crossing_octaves(people, 1, true);
    int held = 0, pooled_held = 0;
    double bias = 0, pooled_bias = 0;
    for (int study = 0; study < studies; ++study) {
      const JointData data = staircase_answers(people, 16, 40, 900 + static_cast<std::uint64_t>(study));
      const JointFit placed = fit_placed(data), pooled = fit_joint(data);
      ASSERT_TRUE(placed.estimated()) << placed.explanation;
      ASSERT_TRUE(pooled.estimated()) << pooled.explanation;
      const auto look = [&](const JointFit& fit, const JointJackknife& left_out, int& hold, double& error) {
        const JointThreshold row =
            of(joint_thresholds(fit, data, left_out), JointQuantity::slightly_noticeable_corrected);
        hold += row.here.ci95.low_x <= truth && truth <= row.here.ci95.high_x ? 1 : 0;
        error += (row.here.level_x.value_or(truth) - truth) / studies;
      };
      look(placed, leave_placed_people_out(placed, data, 1), held, bias);
      look(pooled, leave_people_out(pooled, data, 1), pooled_held, pooled_bias);
    }
    std::printf("%s: placed holds %d of %d, bias %+.3f octaves; pooled %d, %+.3f\n", people.name.c_str(),
                held, studies, bias, pooled_held, pooled_bias);
    EXPECT_GE(held, studies - 3) << people.name;
    EXPECT_LT(std::abs(bias), 0.12) << people.name;
  }
}

TEST(JointPlaced, GradientsOfMeansOverPeopleAreTheirDifferences) {
  const JointData data = staircase_answers({}, 10, 40, 5);
  const JointFit fit = fit_placed(data);
  ASSERT_TRUE(fit.estimated()) << fit.explanation;
  for (const JointQuantity quantity :
       {JointQuantity::perceptual, JointQuantity::slightly_noticeable_corrected, JointQuantity::detection}) {
    const auto place = place_of(fit.model, fit.theta, 0, quantity);
    ASSERT_TRUE(place);
    const SoughtMean sought = *sought_mean(quantity);
    EXPECT_NEAR(mean_at_x(fit.model, fit.theta, 0, sought.mean, place->x).value, sought.level, 1e-9);
    for (Eigen::Index i = 0; i < fit.theta.size(); ++i) {
      constexpr double step = 1e-5;
      Eigen::VectorXd more = fit.theta, less = fit.theta;
      more[i] += step;
      less[i] -= step;
      const double difference =
          (place_of(fit.model, more, 0, quantity)->x - place_of(fit.model, less, 0, quantity)->x) /
          (2 * step);
      EXPECT_NEAR(place->gradient[i], difference, 1e-6) << i;
    }
  }
  EXPECT_FALSE(place_of(fit.model, fit.theta, 0, JointQuantity::inflection));
}

/// The same people's answers on both curves.
JointData side_by_side(const JointData& one, const JointData& other) {
  JointData both = one;
  both.curves = {"receiver", "shadow"};
  for (JointCell cell : other.cells) {
    cell.curve = 1;
    both.cells.push_back(cell);
  }
  both.answers.resize(one.answers.rows(), one.answers.cols() + other.answers.cols());
  both.answers << one.answers, other.answers;
  return both;
}

TEST(JointPlaced, AnswersDecideWhatCurvesShare) {
  const JointData steep = staircase_answers({.scale_octaves = 0.2}, 20, 40, 11),
                  also_steep = staircase_answers({.scale_octaves = 0.2}, 20, 40, 12),
                  flat = staircase_answers({.scale_octaves = 1.2}, 20, 40, 13);
  const SharedFit alike = fit_shared(side_by_side(steep, also_steep), {}, true, fit_placed);
  ASSERT_EQ(alike.tests.size(), 4U) << "a cell without an expected count says nothing of parallel ratings";
  for (const SharingTest& test : alike.tests) EXPECT_GT(test.p, 0.001) << test.shared;
  const SharedFit unlike = fit_shared(side_by_side(steep, flat), {}, true, fit_placed);
  ASSERT_FALSE(unlike.refused.empty());
  EXPECT_EQ(unlike.refused[0].shared, "scale");
  EXPECT_FALSE(unlike.fit.model.sharing.scale);
  EXPECT_GT(unlike.fit.log_likelihood, fit_placed(side_by_side(steep, flat)).log_likelihood);
}

TEST(JointPlaced, TheSameBitsForAnyNumberOfThreads) {
  const JointData data = staircase_answers({}, 6, 30, 7);
  const JointFit fit = fit_placed(data);
  ASSERT_TRUE(fit.estimated()) << fit.explanation;
  EXPECT_EQ(leave_placed_people_out(fit, data, 1).covariance,
            leave_placed_people_out(fit, data, 3).covariance);
}

}  // namespace
}  // namespace seamline::analysis
