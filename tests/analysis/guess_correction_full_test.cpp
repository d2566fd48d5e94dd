// The tables of documentation/evidence/statistics.md: run `analysis_full_tests
// --gtest_filter=GuessCorrectionCoverage.*` to make them again.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/analysis/coverage_tally.h"
#include "tests/analysis/guessing_people.h"

namespace seamline::analysis {
namespace {

using test::corrected;
using test::CoverageTally;
using test::GuessingStudy;
using test::Population;

constexpr int studies = 1000;
constexpr int replicates = 499;

CurveThresholds true_thresholds(const Population& population, Artifact artifact) {
  std::vector<double> means;
  for (int width_px : test::paper_widths_px)
    means.push_back(test::true_noticeability(population, artifact, width_px));
  return thresholds_of_means(log2_widths({test::paper_widths_px.begin(), test::paper_widths_px.end()}),
                             means);
}

void measure(const char* name, const GuessingStudy& study) {
  struct Row {
    CoverageTally pt, sn, pt_bootstrap, sn_bootstrap, ip, pt_logistic, sn_logistic;
  };
  std::array<Row, 4> rows;
  std::array<CurveThresholds, 4> truth;
  for (std::size_t a = 0; a < 4; ++a) truth[a] = true_thresholds(study.population, paper_artifacts[a]);
  for (std::uint64_t seed = 1; seed <= studies; ++seed) {
    const GuessCorrection found =
        corrected(test::simulate_guessing(study, seed), {.replicates = replicates, .seed = seed});
    for (std::size_t a = 0; a < 4; ++a) {
      const CorrectedCurve& curve = found.curves[a];
      rows[a].pt.add(curve.estimates.perceptual, truth[a].perceptual);
      rows[a].sn.add(curve.estimates.slightly_noticeable, truth[a].slightly_noticeable);
      rows[a].ip.add(curve.estimates.inflection, truth[a].inflection);
      rows[a].pt_logistic.add(curve.estimates.perceptual_logistic, truth[a].perceptual_logistic);
      rows[a].sn_logistic.add(curve.estimates.slightly_noticeable_logistic,
                              truth[a].slightly_noticeable_logistic);
      rows[a].pt_bootstrap.add(curve.perceptual_bootstrap, *truth[a].perceptual.level_x);
      rows[a].sn_bootstrap.add(curve.slightly_noticeable_bootstrap, *truth[a].slightly_noticeable.level_x);
    }
  }
  for (std::size_t a = 0; a < 4; ++a) {
    const char* artifact = word(paper_artifacts[a]).data();
    rows[a].pt.print(name, artifact, "PT", truth[a].perceptual, &rows[a].pt_bootstrap);
    rows[a].sn.print(name, artifact, "SN", truth[a].slightly_noticeable, &rows[a].sn_bootstrap);
    rows[a].ip.print(name, artifact, "IP", truth[a].inflection, nullptr);
    rows[a].pt_logistic.print(name, artifact, "PT, logistic", truth[a].perceptual_logistic, nullptr);
    rows[a].sn_logistic.print(name, artifact, "SN, logistic", truth[a].slightly_noticeable_logistic, nullptr);
    for (const CoverageTally* tally : {&rows[a].pt, &rows[a].sn})
      EXPECT_GE(tally->percent(), 92) << name << " " << artifact;
  }
}

TEST(GuessCorrectionCoverage, OfTheThresholdObserver) {
  GuessingStudy study;
  study.habits = {.position = {1.0 / 3, 1.0 / 3, 1.0 / 3}, .rating = {1, 0, 0, 0}};
  measure("observer", study);
}

TEST(GuessCorrectionCoverage, OfPeopleWhoDifferAndGuessByHabit) {
  GuessingStudy study;
  study.population.observer.people_sd_octaves = 0.8;
  study.population.rating_sd_octaves = 0.5;
  measure("people", study);
}

}  // namespace
}  // namespace seamline::analysis
