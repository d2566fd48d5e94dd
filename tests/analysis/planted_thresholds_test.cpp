// Where simulated observers' expected mean truly crosses, whatever widths are tested.
#include "analysis/thresholds/planted_noticeability.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/analysis/threshold_people.h"

namespace seamline::analysis {
namespace {

const std::vector<double> paper_levels(test::paper_widths_px.begin(), test::paper_widths_px.end());

/// People who are all alike: P(1 + 3P) + (1 - P) / 3 is a quadratic of P, and its slope in x is largest where
/// a second one is 0.
TEST(PlantedThresholds, AreTheClosedFormOfPeopleWhoAreAlike) {
  ObserverDefinition observer;
  observer.people_sd_octaves = 0;
  observer.scale_octaves = 0.7;
  const PlantedThresholds planted = planted_thresholds(observer, {}, 400, paper_levels);
  const auto x_of_seen = [&](double seen) { return std::log2(400) + 0.7 * std::log((1 - seen) / seen); };
  const double at_pt = (-2 / 3.0 + std::sqrt(4 / 9.0 + 2)) / 6;
  const double at_sn = (-2 / 3.0 + std::sqrt(4 / 9.0 + 8)) / 6;
  const double at_ip = (32 / 3.0 + std::sqrt(1024 / 9.0 + 48)) / 36;
  EXPECT_NEAR(planted.perceptual_x, x_of_seen(at_pt), 1e-9);
  EXPECT_NEAR(planted.slightly_noticeable_x, x_of_seen(at_sn), 1e-9);
  EXPECT_NEAR(planted.inflection_x, x_of_seen(at_ip), 1e-4);
}

/// Octaves above the midpoint, by Gauss-Hermite quadrature and Brent's method in another language.
TEST(PlantedThresholds, AreThoseOfAnIndependentComputation) {
  struct Reference {
    double scale, sd, pt, sn, ip;
  };
  constexpr std::array<Reference, 3> references = {{{0.5, 0.5, 1.137163922, 0.414870068, -0.343327},
                                                    {0.8, 0.3, 1.456891937, 0.454940600, -0.506447},
                                                    {0.3, 0.9, 1.473636925, 0.679027931, -0.232789}}};
  for (const Reference& reference : references) {
    ObserverDefinition observer;
    observer.scale_octaves = reference.scale;
    observer.people_sd_octaves = reference.sd;
    const PlantedThresholds planted = planted_thresholds(observer, {}, 300, paper_levels);
    EXPECT_NEAR(planted.perceptual_x - std::log2(300), reference.pt, 1e-8);
    EXPECT_NEAR(planted.slightly_noticeable_x - std::log2(300), reference.sn, 1e-8);
    EXPECT_NEAR(planted.inflection_x - std::log2(300), reference.ip, 1e-3);
  }
}

/// Fewer widths move what straight lines find, and not the truth; beyond the widths tested there is one too.
TEST(PlantedThresholds, DoNotDependOnTheWidthsTested) {
  const ObserverDefinition observer;
  const PlantedThresholds fine = planted_thresholds(observer, {}, 620, paper_levels);
  const PlantedThresholds coarse = planted_thresholds(observer, {}, 620, {64, 512, 4096});
  const PlantedThresholds short_of_it = planted_thresholds(observer, {}, 620, {64, 128, 256});
  EXPECT_EQ(fine.perceptual_x, coarse.perceptual_x);
  EXPECT_EQ(fine.perceptual_x, short_of_it.perceptual_x);
  EXPECT_NEAR(*coarse.limit.perceptual.level_x - coarse.perceptual_x, 1.29, 0.01);
  EXPECT_FALSE(short_of_it.limit.perceptual.level_x);
}

/// The same people on a linear axis, and on one where noticeability rises.
TEST(PlantedThresholds, AreOfAnyAxis) {
  ObserverDefinition observer;
  observer.scale_linear = 2;
  observer.people_sd_linear = 3;
  LevelAxis axis{.quantity = Quantity::sun_radius_deg, .noticeability = Direction::decreasing, .unit = 5};
  ASSERT_TRUE(is_linear(axis));
  const std::vector<double> levels = {0, 10, 20, 30};
  const PlantedThresholds falls = planted_thresholds(observer, axis, 12, levels);
  const double pt = level_at(axis, falls.perceptual_x);
  EXPECT_GT(pt, 12);
  EXPECT_NEAR(planted_noticeability(observer, axis, 12, pt), perceptual_level, 1e-9);
  axis.noticeability = Direction::increasing;
  observer.direction = Direction::increasing;
  const PlantedThresholds rises = planted_thresholds(observer, axis, 12, {30, 20, 10, 0});
  EXPECT_NEAR(level_at(axis, rises.perceptual_x) - 12, 12 - pt, 1e-8);
}

}  // namespace
}  // namespace seamline::analysis
