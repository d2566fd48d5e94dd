// What error against run time rests on: the slope fit, the two renderings that the coupled one stands for,
// and the rule for the mesh tolerance.
#include "laboratory/convergence/convergence_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "laboratory/convergence/convergence_light.h"
#include "laboratory/convergence/convergence_mesh.h"
#include "laboratory/convergence/convergence_slope.h"
#include "stimuli/study_file/study_file.h"

namespace seamline::renderer {
namespace {

TEST(LogLogSlope, FindsAPlantedPower) {
  for (const double power : {-2.0, -0.5, 0.0, 1.0}) {
    std::vector<double> x, y;
    for (int i = 0; i < 6; ++i) {
      x.push_back(0.003 * std::exp2(i));
      y.push_back(7.5 * std::pow(x.back(), power));
    }
    EXPECT_NEAR(log_log_slope(x, y).value(), power, 1e-12);
  }
}

TEST(LogLogSlope, IsLeastSquaresInLogarithms) {
  // Logs (0, 0), (1, 2), (2, 1): slope (sum of (x - 1)(y - 1)) / (sum of (x - 1)^2) = 1 / 2.
  const std::vector<double> x = {1, 10, 100}, y = {1, 100, 10};
  EXPECT_NEAR(log_log_slope(x, y).value(), 0.5, 1e-12);
}

TEST(LogLogSlope, LeavesOutWhatHasNoLogarithm) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  const std::vector<double> x = {1, 2, 0, -1, 3, nan, inf, 4}, y = {1, 4, 9, 9, 0, 9, 9, 16};
  EXPECT_NEAR(log_log_slope(x, y).value(), 2, 1e-12);
}

TEST(LogLogSlope, NeedsTwoDifferentPlaces) {
  EXPECT_FALSE(log_log_slope({}, {}).has_value());
  const std::vector<double> one = {2}, twice = {0.3, 0.3}, values = {1, 5}, zeros = {0, 0};
  EXPECT_FALSE(log_log_slope(one, one).has_value());
  EXPECT_FALSE(log_log_slope(twice, values).has_value());
  EXPECT_FALSE(log_log_slope(values, zeros).has_value());
}

TEST(MeshRule, OnePixelInAThousandAndEightSteps) {
  EXPECT_TRUE(keeps_rule({.changed_share = 0.001, .largest_change_steps = 8}));
  EXPECT_FALSE(keeps_rule({.changed_share = 0.0011, .largest_change_steps = 2}));
  EXPECT_FALSE(keeps_rule({.changed_share = 0.0001, .largest_change_steps = 9}));
}

class SmallSubject : public testing::Test {
 protected:
  ConvergenceSubject subject_ =
      load_subject(read_study(std::filesystem::path(SEAMLINE_SOURCE_DIR) / "stimuli" / "quick.toml"),
                   {.only = "bedroom-receiver-statue-0064", .threads = 2, .width_px = 32, .height_px = 18});
};

TEST_F(SmallSubject, CoupledIsTwoRenderingsThatShareTheirSamplePoints) {
  // A rendering of the world with the object in it, all in one geometry, and one of the world without.
  const Geometry with = subject_.scene.geometry(true, {1, 2, 3});
  const Geometry& without = subject_.geometry.truth;
  const Camera& camera = subject_.scene.camera;
  double difference = 0, sum = 0;
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x) {
      const Sampler sampler(1, x, y, 0);
      const auto point = without.nearest(camera_ray(camera, x, y, sampler));
      if (!point) continue;
      const Light& light = subject_.scene.light;
      const RadiancePair pair =
          radiance_with_and_without(without, &subject_.geometry.object, *point, light, sampler);
      const Rgb alone =
          radiance_with_and_without(without, nullptr, *point, light, sampler).without_object.total();
      const Rgb together =
          radiance_with_and_without(with, nullptr, *point, light, sampler).without_object.total();
      EXPECT_LT((pair.without_object.total() - alone).abs().maxCoeff(), 1e-6F);
      difference += static_cast<double>((pair.with_object.total() - together).abs().maxCoeff());
      sum += static_cast<double>(together.maxCoeff());
    }
  // Two geometries may answer differently on an edge, no more.
  EXPECT_LT(difference, 1e-3 * sum);
}

TEST_F(SmallSubject, IndependentRenderingsKeepCoverageAndTheLevelOfLight) {
  const Geometry depth =
      subject_geometry(subject_, subject_mesh(subject_, subject_.map, MeshDensity::adaptive, 1e-4));
  PathRuns runs(subject_, depth);
  const StimulusSums without = runs.coupled(4, 1).sums;
  const StimulusSums with = runs.coupled(4, 2).sums;
  const StimulusSums joined = join_independent(without, with);
  for (std::size_t i = 0; i < joined.halves[0].size(); ++i) {
    const auto uncovered = [&](const StimulusSums& sums) {
      return static_cast<float>(sums.halves[0][i].uncovered_surfaces) +
             static_cast<float>(sums.halves[1][i].uncovered_surfaces);
    };
    EXPECT_EQ(uncovered(joined), uncovered(with));
    if (uncovered(without) != uncovered(with)) continue;
    const Rgb expected = without.halves[0][i].without_object + without.halves[1][i].without_object;
    EXPECT_LT((joined.halves[0][i].without_object - expected).abs().maxCoeff(), 1e-4F);
  }
  // Joined with itself, a rendering is what it was.
  const Image same = compose(join_independent(with, with)).picture, itself = compose(with).picture;
  for (std::size_t i = 0; i < same.values.size(); ++i) EXPECT_NEAR(same.values[i], itself.values[i], 1e-4F);
}

/// A stimulus of a ready study, small.
ConvergenceSubject subject_of(const char* study, const char* stimulus) {
  return load_subject(read_study(std::filesystem::path(SEAMLINE_SOURCE_DIR) / "stimuli" / study),
                      {.only = stimulus, .threads = 2, .width_px = 24, .height_px = 14});
}

TEST(MeasureLight, StrategiesAgreeAboutTheMeanAndMoreRaysLeaveLessNoise) {
  for (const auto& [study, stimulus] :
       {std::pair{"environment_light.toml", "gazebo-shadow-lion-interior-0064"},
        std::pair{"many_lights.toml", "gazebo-shadow-lion-lamps-0064"}}) {
    const LightResult result = measure_light(subject_of(study, stimulus));
    EXPECT_GE(result.agreements.size(), 2U) << stimulus;
    for (const LightResult::Agreement& one : result.agreements)
      EXPECT_LT(std::abs(one.excess), 4 * one.standard_error + 1e-3) << one.light << " by " << one.strategy;
    for (const LightRow& row : result.rows) {
      const auto finer = std::find_if(result.rows.begin(), result.rows.end(), [&](const LightRow& other) {
        return row.light == other.light && row.strategy == other.strategy && row.rays == other.rays &&
               4 * row.spp == other.spp;
      });
      if (finer == result.rows.end()) continue;
      EXPECT_LT(finer->error, 0.9 * row.error) << row.light << " by " << row.strategy << " " << row.spp;
    }
  }
}

}  // namespace
}  // namespace seamline::renderer
