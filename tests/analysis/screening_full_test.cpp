// The table of documentation/evidence/statistics.md: run `analysis_full_tests
// --gtest_filter=ScreeningRates.*` to make it again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "analysis/screening/screening.h"
#include "tests/analysis/guessing_people.h"
#include "tests/analysis/honest_studies.h"
#include "tests/analysis/random_raters.h"

namespace seamline::analysis {
using namespace study;
namespace {

using test::GuessingStudy;

constexpr int studies = 500;

/// How often participants of one kind are named.
struct Rate {
  int people = 0, kurtosis = 0, correlation = 0, p913 = 0;
  void add(const ScreenedPerson& person) {
    ++people;
    kurtosis += person.kurtosis.rejected ? 1 : 0;
    correlation += person.correlation.rejected ? 1 : 0;
    p913 += person.correlation.below_p913 ? 1 : 0;
  }
  [[nodiscard]] double percent(int count) const { return 100.0 * count / people; }
  void print(const char* population, const char* kind) const {
    std::printf("| %s | %s | %d | %.2f | %.2f | %.2f |\n", population, kind, people, percent(kurtosis),
                percent(correlation), percent(p913));
  }
};

void measure(const char* name, const GuessingStudy& study, int random_people) {
  std::map<bool, Rate> rates;
  for (std::uint64_t seed = 1; seed <= studies; ++seed) {
    const LogContents log = test::with_random_raters(study, random_people, seed);
    const ScoreMatrix scores = score_matrix(log, select_participants(log, false));
    for (const ScreenedPerson& person : screen_participants(scores, {}).people)
      rates[person.code.starts_with("random")].add(person);
  }
  rates[false].print(name, random_people > 0 ? "good, beside 4 random" : "good");
  EXPECT_LE(rates[false].percent(rates[false].correlation), 0.5) << name;
  if (random_people == 0) return;
  rates[true].print(name, "random");
  // Of the few who are not named most are in studies where the screen does not judge.
  EXPECT_GE(rates[true].percent(rates[true].correlation), 94) << name;
}

TEST(ScreeningRates, OfTheThresholdObserver) {
  GuessingStudy study;
  study.habits = {.position = {1.0 / 3, 1.0 / 3, 1.0 / 3}, .rating = {1, 0, 0, 0}};
  measure("observer", study, 0);
  measure("observer", study, 4);
}

TEST(ScreeningRates, OfPeopleWhoDiffer) {
  measure("people", test::people_who_differ(), 0);
  measure("people", test::people_who_differ(), 4);
}

/// Of each design: how often the correlation screen judges, and whom any screen of scores names.
TEST(ScreeningRates, OfHonestStudiesOfManyDesigns) {
  constexpr int studies_of_a_design = 300;
  for (const test::HonestStudy& design : test::honest_studies())
    for (const int random_people : {0, 4}) {
      int good = 0, good_named = 0, ignoring = 0, random = 0, random_named = 0, judged = 0;
      for (std::uint64_t seed = 1; seed <= studies_of_a_design; ++seed) {
        const LogContents log = test::simulate_honest_study(design, random_people, seed);
        const ScoreMatrix scores = score_matrix(log, select_participants(log, false));
        const Screening screening = screen_participants(scores, {});
        judged += screening.judged(ScreeningRule::correlation) ? 1 : 0;
        const std::vector<CorrelationCheck> unjudged = screen_by_correlation(scores.score, scores.cell);
        for (std::size_t p = 0; p < scores.people.size(); ++p) {
          const bool named = screening.people[p].named();
          const bool is_random = scores.people[p].starts_with("random");
          (is_random ? random : good) += 1;
          (is_random ? random_named : good_named) += named ? 1 : 0;
          ignoring += !is_random && unjudged[p].rejected ? 1 : 0;
        }
      }
      const auto percent = [](int part, int all) { return all > 0 ? 100.0 * part / all : 0.0; };
      std::printf("| %s | %d | %.0f | %.2f | %.2f | %s |\n", design.name.c_str(), random_people,
                  percent(judged, studies_of_a_design), percent(ignoring, good), percent(good_named, good),
                  random > 0 ? std::to_string(std::lround(percent(random_named, random))).c_str() : "");
      std::fflush(stdout);
      EXPECT_LE(percent(good_named, good), 1) << design.name;
    }
}

}  // namespace
}  // namespace seamline::analysis
