#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "analysis/over_scenes/scene_thresholds.h"
#include "support/running/parallel.h"
#include "tests/analysis/scene_people.h"

namespace seamline::test {

namespace {

using namespace analysis;

struct FullCoverage {
  int found = 0, like_these = 0, these = 0;
  double length = 0, between = 0;
};

/// PT, SN and both corrected, in this order.
std::array<FullCoverage, 4> full_coverage(const ScenePeople& of, int studies) {
  std::vector<CurveOverScenes> all(static_cast<std::size_t>(studies));
  run_parallel(studies, 1, [&](int study) {
    all[static_cast<std::size_t>(study)] =
        threshold_over_scenes(answer_in_scenes(of, static_cast<std::uint64_t>(study) + 1), 1);
  });
  std::array<FullCoverage, 4> coverage;
  for (std::size_t q = 0; q < coverage.size(); ++q) {
    const double truth = of.mean_x + true_scene_offset(of, q % 2 == 0 ? 0.5 : 1, q >= 2);
    for (const CurveOverScenes& over : all) {
      const ThresholdOverScenes& found = over.thresholds[q];
      if (!found.reason.empty()) continue;
      ++coverage[q].found;
      coverage[q].like_these += found.like_these.low_x <= truth && truth <= found.like_these.high_x ? 1 : 0;
      coverage[q].these += found.these.low_x <= truth && truth <= found.these.high_x ? 1 : 0;
      coverage[q].length += 2 * found.spreads.half_like_these();
      coverage[q].between += found.spreads.between_scenes * found.spreads.between_scenes;
    }
  }
  return coverage;
}

}  // namespace

/// How often both intervals hold the mean of all scenes. SEAMLINE_TRUE_STUDIES: how many of each row (default
/// 200).
TEST(OverScenesCoverage, OfScenesLikeThese) {
  const char* asked = std::getenv("SEAMLINE_TRUE_STUDIES");
  const int studies = asked == nullptr ? 200 : std::stoi(asked);
  std::printf("form,between,people,scenes,quantity,studies,found,like_these,these,length,between_found\n");
  constexpr std::array forms = {"normal", "uniform", "skewed"};
  constexpr std::array quantities = {"PT", "SN", "PT corrected", "SN corrected"};
  for (const auto& [form, sd] : {std::pair{SceneSpreadForm::normal, 0.5},
                                 {SceneSpreadForm::normal, 0.0},
                                 {SceneSpreadForm::uniform, 0.5},
                                 {SceneSpreadForm::skewed, 0.5}})
    for (const int scenes : {3, 5, 10}) {
      const ScenePeople of{.scene_sd = sd, .form = form, .scenes = scenes, .count = 20};
      const std::array<FullCoverage, 4> rows = full_coverage(of, studies);
      for (std::size_t q = 0; q < rows.size(); ++q) {
        const FullCoverage& row = rows[q];
        std::printf("%s,%g,%d,%d,%s,%d,%d,%.1f,%.1f,%.2f,%.3f\n", forms[static_cast<std::size_t>(form)], sd,
                    of.count, scenes, quantities[q], studies, row.found, 100.0 * row.like_these / row.found,
                    100.0 * row.these / row.found, row.length / row.found,
                    std::sqrt(row.between / row.found));
        std::fflush(stdout);
        // Scenes that are not spread normally are held less often with few of them, as by any t interval. A
        // row of few studies may fall below by chance: four standard errors (3 in 100,000 of a row).
        const double least = form == SceneSpreadForm::normal ? 0.92 : 0.87;
        EXPECT_GE(row.like_these, row.found * least - 4 * std::sqrt(row.found * least * (1 - least)));
      }
    }
}

}  // namespace seamline::test
