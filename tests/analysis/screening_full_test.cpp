// The table of documentation/screening.md: run `analysis_full_tests --gtest_filter=ScreeningRates.*` to make
// it again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include "analysis/screening/screening.h"
#include "tests/analysis/guessing_people.h"
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
  EXPECT_GE(rates[true].percent(rates[true].correlation), 99.5) << name;
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

}  // namespace
}  // namespace seamline::analysis
