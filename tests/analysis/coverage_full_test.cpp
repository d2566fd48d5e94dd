// The table of documentation/coverage.md: run `analysis_full_tests --gtest_filter=Coverage.*` to make it
// again.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "analysis/interval.h"
#include "analysis/thresholds.h"
#include "tests/analysis/threshold_people.h"

namespace seamline {
namespace {

using testing::planted_thresholds;
using testing::Population;
using testing::simulate_scores;

constexpr int studies = 1000;
constexpr int people = 20;
constexpr int replicates = 999;

/// How often intervals held a planted value, and by which end they missed it.
struct Tally {
  int held = 0, too_high = 0, too_low = 0, open = 0;
  void add(const WidthInterval& interval, double log2_px) {
    if (interval.low_log2_px > log2_px)
      ++too_high;
    else if (interval.high_log2_px < log2_px)
      ++too_low;
    else
      ++held;
    open += std::isfinite(interval.low_log2_px) && std::isfinite(interval.high_log2_px) ? 0 : 1;
  }
  [[nodiscard]] double percent() const { return 100.0 * held / studies; }
};

void print(const char* population, Artifact artifact, const char* quantity, double planted,
           const Tally& tally, const Tally* bootstrap) {
  std::printf("| %s | %s | %s | %.0f | %.1f | %.1f | %.1f | %.0f | %s |\n", population, word(artifact).data(),
              quantity, std::exp2(planted), tally.percent(), 100.0 * tally.too_high / studies,
              100.0 * tally.too_low / studies, 100.0 * tally.open / studies,
              bootstrap == nullptr ? "" : std::to_string(bootstrap->percent()).substr(0, 4).c_str());
}

void measure(const char* name, const Population& population) {
  for (Artifact artifact : paper_artifacts) {
    const CurveThresholds planted = planted_thresholds(population, artifact);
    const double pt = *planted.perceptual.log2_px, sn = *planted.slightly_noticeable.log2_px,
                 ip = *planted.inflection.log2_px;
    Tally pt_score, sn_score, ip_score, pt_bootstrap, sn_bootstrap;
    for (std::uint64_t seed = 1; seed <= studies; ++seed) {
      const ArtifactThresholds found = estimate_thresholds(
          simulate_scores(population, artifact, people, seed), {.replicates = replicates, .seed = seed});
      pt_score.add(found.estimates.perceptual.ci95, pt);
      sn_score.add(found.estimates.slightly_noticeable.ci95, sn);
      ip_score.add(found.estimates.inflection.ci95, ip);
      pt_bootstrap.add(found.perceptual_bootstrap, pt);
      sn_bootstrap.add(found.slightly_noticeable_bootstrap, sn);
    }
    print(name, artifact, "PT", pt, pt_score, &pt_bootstrap);
    print(name, artifact, "SN", sn, sn_score, &sn_bootstrap);
    print(name, artifact, "IP", ip, ip_score, nullptr);
    for (const Tally* tally : {&pt_score, &sn_score, &ip_score}) {
      EXPECT_GE(tally->percent(), 93) << name << " " << word(artifact);
      EXPECT_LE(tally->percent(), 97.5) << name << " " << word(artifact);
    }
  }
}

TEST(Coverage, OfTheThresholdObserver) {
  measure("observer", {});
}

TEST(Coverage, OfPeopleWhoDifferMoreAndRateByTheirOwnCriteria) {
  Population population;
  population.observer.people_sd_octaves = 0.8;
  population.rating_sd_octaves = 0.5;
  measure("people", population);
}

TEST(Coverage, BiasWith2000Observers) {
  for (Artifact artifact : paper_artifacts) {
    const CurveThresholds planted = planted_thresholds({}, artifact);
    constexpr int large_studies = 100;
    double pt = 0, sn = 0, ip = 0, pt_square = 0, sn_square = 0;
    for (std::uint64_t seed = 1; seed <= large_studies; ++seed) {
      const CurveThresholds found =
          estimate_thresholds(simulate_scores({}, artifact, 2000, seed), {.replicates = 0}).estimates;
      const double pt_error = *found.perceptual.log2_px - *planted.perceptual.log2_px;
      const double sn_error = *found.slightly_noticeable.log2_px - *planted.slightly_noticeable.log2_px;
      pt += pt_error / large_studies;
      sn += sn_error / large_studies;
      pt_square += pt_error * pt_error / large_studies;
      sn_square += sn_error * sn_error / large_studies;
      ip += (*found.inflection.log2_px - *planted.inflection.log2_px) / large_studies;
    }
    std::printf("| %s | %+.4f (%.3f) | %+.4f (%.3f) | %+.4f |\n", word(artifact).data(), pt,
                std::sqrt(pt_square), sn, std::sqrt(sn_square), ip);
    EXPECT_LT(std::abs(pt), 0.02);
    EXPECT_LT(std::abs(sn), 0.02);
  }
}

}  // namespace
}  // namespace seamline
