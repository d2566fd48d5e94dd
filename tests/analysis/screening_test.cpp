#include "analysis/screening/screening.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "support/text/numbers.h"
#include "tests/analysis/guessing_people.h"
#include "tests/analysis/honest_studies.h"
#include "tests/analysis/random_raters.h"

namespace seamline::analysis {
using namespace study;
namespace {

using test::GuessingStudy;
using test::people_who_differ;
using test::simulate_guessing;
using test::with_random_raters;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

Screening screened(const LogContents& log, const std::vector<CatchAnswer>& catches = {}) {
  return screen_participants(score_matrix(log, select_participants(log, false)), catches);
}

/// Good raters: the `threshold` observers of a study, who rate a guess 1.
TEST(Screening, RejectsNoneOf20GoodRaters) {
  GuessingStudy study;
  study.habits = {.position = {1.0 / 3, 1.0 / 3, 1.0 / 3}, .rating = {1, 0, 0, 0}};
  for (std::uint64_t seed = 1; seed <= 15; ++seed)
    EXPECT_THAT(screened(simulate_guessing(study, seed).log).named(), IsEmpty()) << seed;
}

/// Of people whose thresholds and criteria differ and who rate guesses up to 3 the kurtosis rule rejects
/// some, a few in a thousand (documentation/evidence/statistics.md has the rates); here a bound.
TEST(Screening, NamesHardlyAnyoneBecauseTheyDiffer) {
  std::size_t named = 0;
  for (std::uint64_t seed = 1; seed <= 15; ++seed)
    named += screened(simulate_guessing(people_who_differ(), seed).log).named().size();
  EXPECT_LE(named, 4U);  // of 300
}

TEST(Screening, CorrelationFindsRandomRaters) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    const std::vector<std::string> named =
        screened(with_random_raters(people_who_differ(), 4, seed)).named_by(ScreeningRule::correlation);
    found += static_cast<std::size_t>(std::count_if(
        named.begin(), named.end(), [](const std::string& code) { return code.starts_with("random"); }));
  }
  EXPECT_GE(found, 58U);  // of 60
}

/// Few stimuli, one artifact, placement by the answers, little to see: people who look are not named,
/// whatever generator they come from. documentation/evidence/statistics.md has the rates of 300 studies of
/// each design.
TEST(Screening, NamesHardlyAnyHonestPersonInAnyDesign) {
  for (const test::HonestStudy& design : test::honest_studies()) {
    std::size_t named = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
      named += screened(test::simulate_honest_study(design, 0, seed)).named().size();
    EXPECT_LE(named, 1U) << design.name << ", of 60";
  }
}

TEST(Screening, JudgesWhereMuchIsVisibleAndFindsRandomRatersThere) {
  for (const std::size_t design : {0, 1}) {
    const Screening screening = screened(test::simulate_honest_study(test::honest_studies()[design], 4, 1));
    EXPECT_TRUE(screening.judged(ScreeningRule::correlation)) << screening.honest.correlation;
    EXPECT_THAT(screening.named_by(ScreeningRule::correlation),
                ElementsAre("random0", "random1", "random2", "random3"));
    EXPECT_EQ(why_not_judged(screening, ScreeningRule::correlation), "");
    EXPECT_EQ(limit_text(screening), "0.33");
  }
}

TEST(Screening, SaysThatTooLittleWasVisibleAndNamesNobody) {
  const Screening screening = screened(test::simulate_honest_study(test::honest_studies()[3], 4, 1));
  EXPECT_FALSE(screening.judged(ScreeningRule::correlation));
  EXPECT_THAT(screening.named_by(ScreeningRule::correlation), IsEmpty());
  EXPECT_GT(screening.honest.correlation, 0.05);
  EXPECT_THAT(why_not_judged(screening, ScreeningRule::correlation),
              testing::StartsWith("too little was visible: it would name "));
}

/// The estimate of who would be named is near what a screen without judgement does to honest people.
TEST(Screening, ItsShareOfHonestPeopleIsTheShareThatIsNamed) {
  for (const std::size_t design : {3, 6}) {
    double expected = 0;
    int named = 0, people = 0;
    constexpr int studies = 10;
    for (std::uint64_t seed = 1; seed <= studies; ++seed) {
      const LogContents log = test::simulate_honest_study(test::honest_studies()[design], 0, seed);
      const ScoreMatrix scores = score_matrix(log, select_participants(log, false));
      expected += simulate_honest_people(scores, 2000).correlation / studies;
      for (const CorrelationCheck& check : screen_by_correlation(scores.score, scores.cell)) {
        named += check.rejected ? 1 : 0;
        ++people;
      }
    }
    EXPECT_NEAR(expected, named / static_cast<double>(people), 0.13) << design;
  }
}

TEST(Screening, CriticalCorrelationIsExceededAsRarelyAsItSays) {
  EXPECT_NEAR(critical_correlation(20, 0.025), 0.4438, 1e-4);  // tables of r, 18 degrees of freedom
  EXPECT_EQ(critical_correlation(2, 0.025), 1);
}

TEST(Screening, KurtosisByHand) {
  // Ten people, of whom one is far above the others on one stimulus and far below on the next.
  Eigen::MatrixXd score(10, 3);
  score.col(0).setConstant(2);
  score.col(1).setConstant(2);
  score.col(2).setConstant(3);  // all agree: nobody is extreme
  score(0, 0) = 4;
  score(0, 1) = 0;
  const std::vector<KurtosisCount> counts = screen_by_kurtosis(score);
  // m2 = 0.36, S^2 = 0.4, m4 = (1.8^4 + 9 * 0.2^4) / 10, kurtosis 8.1: the limit is sqrt(20 * 0.4) = 2.83.
  EXPECT_EQ(counts[0].above + counts[0].below, 0);
  // With 40 people S^2 is 0.1: the limit, 1.41, is passed on both sides.
  Eigen::MatrixXd more = Eigen::MatrixXd::Constant(40, 3, 2);
  more(0, 0) = 4;
  more(0, 1) = 0;
  const std::vector<KurtosisCount> rejected = screen_by_kurtosis(more);
  EXPECT_EQ(rejected[0].above, 1);
  EXPECT_EQ(rejected[0].below, 1);
  EXPECT_EQ(rejected[0].stimuli, 3);
  EXPECT_TRUE(rejected[0].rejected);
  EXPECT_FALSE(rejected[1].rejected);
  EXPECT_EQ(rejected[1].above + rejected[1].below, 0);
  // Always high is another criterion, not a bad rater.
  more(0, 1) = 4;
  EXPECT_FALSE(screen_by_kurtosis(more)[0].rejected);
}

TEST(Screening, WhereEverybodyAgreesNobodyIsRejected) {
  for (const KurtosisCount& count : screen_by_kurtosis(Eigen::MatrixXd::Constant(20, 84, 1.0 / 3)))
    EXPECT_FALSE(count.rejected);
  for (const CorrelationCheck& check :
       screen_by_correlation(Eigen::MatrixXd::Constant(20, 84, 1.0 / 3), std::vector<int>(84, 0)))
    EXPECT_FALSE(check.rejected);
}

TEST(Screening, SomebodyWhoSaysTheSameToEverythingIsFound) {
  LogContents log = simulate_guessing({}, 1).log;
  for (Answer& answer : log.answers)
    if (answer.participant == "p3") answer.chosen_index = answer.object_index, answer.rating = 2;
  EXPECT_THAT(screened(log).named_by(ScreeningRule::correlation), ElementsAre("p3"));
}

TEST(Screening, MissingScoresAreLeftOut) {
  Eigen::MatrixXd score = Eigen::MatrixXd::Constant(40, 3, 2);
  score(0, 0) = 4;
  score(0, 1) = 0;
  score(0, 2) = nan;
  EXPECT_EQ(screen_by_kurtosis(score)[0].stimuli, 2);
  EXPECT_TRUE(screen_by_kurtosis(score)[0].rejected);
  const Eigen::Vector4d a(1, 2, nan, 4), b(2, 4, 9, 8);
  EXPECT_DOUBLE_EQ(pearson_correlation(a, b), 1);
}

TEST(Screening, CatchTrialsNameWhoDoesNotLook) {
  const LogContents log = simulate_guessing({}, 1).log;
  std::vector<CatchAnswer> catches;
  for (const ParticipantRecord& record : log.participants)
    for (int i = 0; i < 4; ++i)
      catches.push_back({.participant = record.code, .right = record.code != "p7" || i < 2});
  catches[0].right = false;  // one slip in four is forgiven
  const Screening screening = screened(log, catches);
  EXPECT_TRUE(screening.catch_trials);
  EXPECT_THAT(screening.named_by(ScreeningRule::attention), ElementsAre("p7"));
  EXPECT_THAT(screening.named(), ElementsAre("p7"));
  EXPECT_EQ(screening.people[7].attention.shown, 4);
  EXPECT_FALSE(screened(log).catch_trials);
}

/// The public set: 79 stimuli (lines) x 26 observers.
Eigen::MatrixXd public_votes(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<std::vector<double>> lines;
  for (std::string line; std::getline(in, line);) {
    lines.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) lines.back().push_back(std::stod(cell));
  }
  Eigen::MatrixXd votes(static_cast<Eigen::Index>(lines.at(0).size()),
                        static_cast<Eigen::Index>(lines.size()));
  for (std::size_t s = 0; s < lines.size(); ++s)
    for (std::size_t p = 0; p < lines[s].size(); ++p)
      votes(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(s)) = lines[s][p];
  return votes;
}

TEST(Screening, OfAPublicSetByKurtosisRejectsTheSecondObserverOnly) {
  const Eigen::MatrixXd votes = public_votes(SEAMLINE_SOURCE_DIR "/tests/data/bt500_raw_votes.csv");
  ASSERT_EQ(votes.rows(), 26);
  ASSERT_EQ(votes.cols(), 79);
  std::vector<int> by_kurtosis, by_correlation;
  std::vector<int> condition(79);
  for (int i = 0; i < 79; ++i) condition[static_cast<std::size_t>(i)] = i;
  const std::vector<KurtosisCount> kurtosis = screen_by_kurtosis(votes);
  const std::vector<CorrelationCheck> correlation = screen_by_correlation(votes, condition);
  for (int p = 0; p < 26; ++p) {
    if (kurtosis[static_cast<std::size_t>(p)].rejected) by_kurtosis.push_back(p);
    if (correlation[static_cast<std::size_t>(p)].rejected) by_correlation.push_back(p);
  }
  EXPECT_THAT(by_kurtosis, ElementsAre(1));
  EXPECT_THAT(by_correlation, ElementsAre(0, 1, 2, 3, 4));  // the five whose votes follow nobody
}

}  // namespace
}  // namespace seamline::analysis
