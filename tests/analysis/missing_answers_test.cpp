// Logs in which not everybody answered at every level: each number is over those who did, and says how many.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/log_analysis/report_numbers.h"
#include "analysis/report/page/methods_text.h"
#include "analysis/statistics/resampling.h"
#include "support/text/numbers.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::analysis {
namespace {

using namespace study;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Twenty people, of whom the first six have no answer to receivers at 512 px.
LogContents with_a_hole() {
  LogContents log = test::simulate_log(20, 5);
  std::erase_if(log.answers, [](const Answer& answer) {
    return answer.artifact == Artifact::receiver && answer.depth_width_px == 512 &&
           answer.participant.size() == 5 && answer.participant[4] < '6';
  });
  return log;
}

std::string methods_of(const Analysis& analysis) {
  return plain_text(methods_text(analysis, report_numbers(analysis)));
}

TEST(MissingAnswers, TakeNobodyOffTheOtherWidthsAndAreCounted) {
  const Analysis whole = analyze(test::simulate_log(20, 5), false, {.replicates = 200, .threads = 1});
  const Analysis holed = analyze(with_a_hole(), false, {.replicates = 200, .threads = 1});
  const ArtifactScores &before = whole.data.artifacts.at(0), &after = holed.data.artifacts.at(0);
  ASSERT_EQ(after.artifact, Artifact::receiver);
  for (std::size_t w = 0; w < after.cells.size(); ++w) {
    EXPECT_EQ(after.cells[w].n, after.level[w] == 512 ? 14 : 20);
    if (after.level[w] != 512) {
      EXPECT_EQ(after.cells[w].mean, before.cells[w].mean);
    }
  }
  EXPECT_EQ(holed.thresholds[0].participants, 20);
  EXPECT_EQ(holed.thresholds[0].fewest, 14);
  EXPECT_EQ(holed.thresholds[1].estimates.perceptual.ci95.low_x,
            whole.thresholds[1].estimates.perceptual.ci95.low_x);
  EXPECT_TRUE(std::isfinite(holed.thresholds[0].estimates.slightly_noticeable.ci95.low_x));
  const std::string sentence = "receiver 14 to 20 of the 20 used";
  EXPECT_THAT(holed.notes, Contains(HasSubstr(sentence)));
  EXPECT_THAT(methods_of(holed), HasSubstr(sentence));
  EXPECT_THAT(source_sentence(holed), HasSubstr(sentence));  // of captions
  EXPECT_EQ(answered_text(whole), "");
  EXPECT_EQ(source_sentence(whole), "20 simulated observers (threshold).");
  EXPECT_THAT(methods_of(whole), Not(HasSubstr("Not everybody")));
}

TEST(MissingAnswers, SomebodyWithoutAnArtifactIsCountedToo) {
  LogContents log = test::simulate_log(5, 1);
  std::erase_if(log.answers, [](const Answer& answer) {
    return answer.artifact == Artifact::shadow && answer.participant == "sim-3";
  });
  EXPECT_THAT(answered_text(analyze(std::move(log), false, {.replicates = 100, .threads = 1})),
              HasSubstr("shadow 4 of the 5 used"));
}

/// Means and covariances by hand, of four people and two widths, of which the last person has one.
TEST(MissingAnswers, CovarianceIsOfThePeopleWhoHaveBoth) {
  Eigen::MatrixXd score(4, 2);
  score << 1, 2, 3, 4, 2, 0, 4, nan;
  const MeanVector means = mean_and_covariance(score);
  EXPECT_DOUBLE_EQ(means.mean[0], 2.5);
  EXPECT_DOUBLE_EQ(means.mean[1], 2);
  EXPECT_EQ(means.fewest, 3);
  EXPECT_DOUBLE_EQ(means.covariance(0, 0), 5.0 / 3 / 4);
  EXPECT_DOUBLE_EQ(means.covariance(1, 1), 4.0 / 3);
  EXPECT_DOUBLE_EQ(means.covariance(0, 1), 3.0 / 12);  // S of (1, 2), (3, 4), (2, 0) is 1
}

/// The bootstrap's spread is the standard error of a mean over those who answered.
TEST(MissingAnswers, ReplicatesSpreadAsTheMeansDo) {
  Random random(4);
  Eigen::MatrixXd score(60, 2);
  for (Eigen::Index p = 0; p < score.rows(); ++p) {
    const double own = random.normal();
    score(p, 0) = own + random.normal();
    score(p, 1) = p % 3 == 0 ? nan : own + random.normal();
  }
  const MeanVector means = mean_and_covariance(score);
  Eigen::MatrixXd drawn(8000, 2);
  for_each_replicate(score, {.replicates = 8000, .seed = 1, .threads = 1},
                     [&](int r, const Eigen::VectorXd& mean) { drawn.row(r) = mean.transpose(); });
  const Eigen::RowVectorXd middle = drawn.colwise().mean();
  const Eigen::MatrixXd off = drawn.rowwise() - middle, spread = off.transpose() * off / 8000.0;
  for (int j = 0; j < 2; ++j)
    for (int k = 0; k < 2; ++k)
      EXPECT_NEAR(spread(j, k), means.covariance(j, k), 0.08 * means.covariance(0, 0)) << j << k;
}

/// Of many people blocks are drawn: as wide, with and without missing answers.
TEST(MissingAnswers, BlocksOfManyPeopleSpreadAsThePeopleDo) {
  Random random(5);
  Eigen::MatrixXd score(2500, 2);
  for (Eigen::Index p = 0; p < score.rows(); ++p) {
    const double own = random.normal();
    score(p, 0) = own + random.normal();
    score(p, 1) = p % 3 == 0 ? nan : own + random.normal();
  }
  for (const Eigen::Index columns : {1, 2}) {  // the first alone is complete
    const Eigen::MatrixXd of = score.leftCols(columns);
    const MeanVector means = mean_and_covariance(of);
    Eigen::MatrixXd drawn(4000, columns);
    for_each_replicate(of, {.replicates = 4000, .seed = 1, .threads = 1},
                       [&](int r, const Eigen::VectorXd& mean) { drawn.row(r) = mean.transpose(); });
    const Eigen::RowVectorXd middle = drawn.colwise().mean();
    const Eigen::MatrixXd off = drawn.rowwise() - middle, spread = off.transpose() * off / 4000.0;
    for (Eigen::Index j = 0; j < columns; ++j) {
      EXPECT_NEAR(middle[j], means.mean[j], 0.1 * std::sqrt(means.covariance(j, j)));
      EXPECT_NEAR(spread(j, j), means.covariance(j, j), 0.15 * means.covariance(j, j));
    }
  }
}

/// Nobody is missing: the same bits as before anybody could be.
TEST(MissingAnswers, WhereNobodyIsMissingNothingChanges) {
  Eigen::MatrixXd score(5, 2);
  score << 0, 1, 1, 2, 4, 3, 2, 2, 1, 0;
  const MeanVector means = mean_and_covariance(score);
  EXPECT_EQ(means.mean, score.colwise().mean().transpose());
  EXPECT_EQ(means.fewest, 5);
}

}  // namespace
}  // namespace seamline::analysis
