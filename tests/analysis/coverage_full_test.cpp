// The table of documentation/evidence/coverage.md: run `analysis_full_tests --gtest_filter=Coverage.*` to
// make it again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "analysis/statistics/interval.h"
#include "analysis/thresholds/thresholds.h"
#include "tests/analysis/coverage_tally.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::analysis {
namespace {

using test::CoverageTally;
using test::Population;
using test::simulate_scores;
using test::thresholds_of_expected_means;

constexpr int studies = 1000;
constexpr int people = 20;
constexpr int replicates = 999;
constexpr std::uint64_t more_studies = 2000;
constexpr std::uint64_t other_seeds = 1'000'000;

/// But for what the number of studies leaves open: one standard error.
void expect_within(const CoverageTally& tally, double low, double high, const char* name,
                   const char* artifact) {
  if (tally.studies == 0) return;  // no threshold within the widths
  const double standard_error = 100 * std::sqrt(0.95 * 0.05 / tally.studies);
  EXPECT_GE(tally.percent(), low - standard_error) << name << " " << artifact;
  EXPECT_LE(tally.percent(), high + standard_error) << name << " " << artifact;
}

void measure(const char* name, const Population& population) {
  for (Artifact artifact : paper_artifacts) {
    const CurveThresholds planted = thresholds_of_expected_means(population, artifact);
    CoverageTally pt, sn, ip, pt_logistic, sn_logistic, pt_bootstrap, sn_bootstrap, pt_logistic_bootstrap,
        sn_logistic_bootstrap;
    for (std::uint64_t seed = 1; seed <= studies; ++seed) {
      const ArtifactThresholds found = estimate_thresholds(
          simulate_scores(population, artifact, people, seed), {.replicates = replicates, .seed = seed});
      pt.add(found.estimates.perceptual, planted.perceptual);
      sn.add(found.estimates.slightly_noticeable, planted.slightly_noticeable);
      ip.add(found.estimates.inflection, planted.inflection);
      pt_logistic.add(found.estimates.perceptual_logistic, planted.perceptual_logistic);
      sn_logistic.add(found.estimates.slightly_noticeable_logistic, planted.slightly_noticeable_logistic);
      pt_bootstrap.add(found.perceptual_bootstrap, *planted.perceptual.level_x);
      sn_bootstrap.add(found.slightly_noticeable_bootstrap, *planted.slightly_noticeable.level_x);
      pt_logistic_bootstrap.add(found.perceptual_logistic_bootstrap, planted.perceptual_logistic);
      sn_logistic_bootstrap.add(found.slightly_noticeable_logistic_bootstrap,
                                planted.slightly_noticeable_logistic);
    }
    const char* of = word(artifact).data();
    pt.print(name, of, "PT", planted.perceptual, &pt_bootstrap);
    sn.print(name, of, "SN", planted.slightly_noticeable, &sn_bootstrap);
    ip.print(name, of, "IP", planted.inflection, nullptr);
    pt_logistic.print(name, of, "PT, logistic", planted.perceptual_logistic, &pt_logistic_bootstrap);
    sn_logistic.print(name, of, "SN, logistic", planted.slightly_noticeable_logistic, &sn_logistic_bootstrap);
    for (const CoverageTally* tally : {&pt, &sn, &ip}) expect_within(*tally, 93, 97, name, of);
    for (const CoverageTally* tally : {&pt_logistic, &sn_logistic}) expect_within(*tally, 92, 97.5, name, of);
  }
}

/// The inverted tests alone, which need no bootstrap, on more studies of other seeds.
void measure_tests(const char* name, const Population& population) {
  for (Artifact artifact : paper_artifacts) {
    const CurveThresholds planted = thresholds_of_expected_means(population, artifact);
    CoverageTally pt, sn, pt_logistic, sn_logistic;
    for (std::uint64_t study = 1; study <= more_studies; ++study) {
      const ArtifactThresholds found = estimate_thresholds(
          simulate_scores(population, artifact, people, other_seeds + study), {.replicates = 0});
      pt.add(found.estimates.perceptual, planted.perceptual);
      sn.add(found.estimates.slightly_noticeable, planted.slightly_noticeable);
      pt_logistic.add(found.estimates.perceptual_logistic, planted.perceptual_logistic);
      sn_logistic.add(found.estimates.slightly_noticeable_logistic, planted.slightly_noticeable_logistic);
    }
    const char* of = word(artifact).data();
    pt.print(name, of, "PT", planted.perceptual, nullptr);
    sn.print(name, of, "SN", planted.slightly_noticeable, nullptr);
    pt_logistic.print(name, of, "PT, logistic", planted.perceptual_logistic, nullptr);
    sn_logistic.print(name, of, "SN, logistic", planted.slightly_noticeable_logistic, nullptr);
    for (const CoverageTally* tally : {&pt, &sn}) expect_within(*tally, 93, 97, name, of);
    for (const CoverageTally* tally : {&pt_logistic, &sn_logistic}) expect_within(*tally, 92, 97.5, name, of);
  }
}

Population people_who_differ() {
  Population population;
  population.observer.people_sd_octaves = 0.8;
  population.rating_sd_octaves = 0.5;
  return population;
}

TEST(Coverage, OfTheThresholdObserver) {
  measure("observer", {});
}

TEST(Coverage, OfPeopleWhoDifferMoreAndRateByTheirOwnCriteria) {
  measure("people", people_who_differ());
}

TEST(Coverage, OfOtherSeeds) {
  measure_tests("observer", {});
  measure_tests("people", people_who_differ());
}

/// Thresholds elsewhere, steeper, and ratings that begin further from where people see.
TEST(Coverage, OfAnotherPopulation) {
  Population other = people_who_differ();
  for (auto& [artifact, midpoint_px] : other.observer.midpoint) midpoint_px *= 0.7;
  other.observer.scale_octaves = 0.35;
  other.rating_sd_octaves = 0.8;
  measure_tests("other", other);
}

/// Of how few people the intervals still hold: the lowest and the highest coverage over artifacts, PT and SN.
TEST(Coverage, OfFewPeople) {
  for (const auto& [name, population] :
       {std::pair{"observer", Population{}}, std::pair{"people", people_who_differ()}})
    for (const int few : {2, 3, 4, 5, 7, 10}) {
      double lowest = 100, highest = 0;
      for (const Artifact artifact : paper_artifacts) {
        const CurveThresholds planted = thresholds_of_expected_means(population, artifact);
        CoverageTally pt, sn;
        for (std::uint64_t seed = 1; seed <= studies; ++seed) {
          const CurveThresholds found =
              estimate_thresholds(simulate_scores(population, artifact, few, seed), {.replicates = 0})
                  .estimates;
          pt.add(found.perceptual, planted.perceptual);
          sn.add(found.slightly_noticeable, planted.slightly_noticeable);
        }
        for (const CoverageTally* tally : {&pt, &sn}) {
          lowest = std::min(lowest, tally->percent());
          highest = std::max(highest, tally->percent());
        }
      }
      std::printf("| %s | %d | %.1f to %.1f |\n", name, few, lowest, highest);
      std::fflush(stdout);
      if (few >= 10) {
        EXPECT_GE(lowest, 91) << name;
      }
    }
}

TEST(Coverage, BiasWith2000Observers) {
  for (Artifact artifact : paper_artifacts) {
    const CurveThresholds planted = thresholds_of_expected_means({}, artifact);
    constexpr int large_studies = 100;
    double pt = 0, sn = 0, ip = 0, pt_square = 0, sn_square = 0;
    for (std::uint64_t seed = 1; seed <= large_studies; ++seed) {
      const ArtifactScores scores = simulate_scores({}, artifact, 2000, seed);
      const CurveThresholds found = thresholds_of_means(levels_on_axis(scores), means_on_axis(scores));
      const double pt_error = *found.perceptual.level_x - *planted.perceptual.level_x;
      const double sn_error = *found.slightly_noticeable.level_x - *planted.slightly_noticeable.level_x;
      pt += pt_error / large_studies;
      sn += sn_error / large_studies;
      pt_square += pt_error * pt_error / large_studies;
      sn_square += sn_error * sn_error / large_studies;
      ip += (*found.inflection.level_x - *planted.inflection.level_x) / large_studies;
    }
    std::printf("| %s | %+.4f (%.3f) | %+.4f (%.3f) | %+.4f |\n", word(artifact).data(), pt,
                std::sqrt(pt_square), sn, std::sqrt(sn_square), ip);
    EXPECT_LT(std::abs(pt), 0.02);
    EXPECT_LT(std::abs(sn), 0.02);
  }
}

}  // namespace
}  // namespace seamline::analysis
