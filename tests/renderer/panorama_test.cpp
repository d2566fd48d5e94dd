// Pictures of all directions: where their pixels look, what rows are worth, and that the last column stands
// beside the first.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "raytracer/error/error_estimate.h"
#include "raytracer/scene/eyes.h"
#include "raytracer/scene/panorama_camera.h"
#include "raytracer/scene/truth_scene.h"
#include "renderer/picture/bounce_filter.h"
#include "renderer/picture/pocket_filter.h"
#include "stimuli/definition/looks/study_look.h"
#include "support/arithmetic/random.h"

namespace seamline::renderer {
namespace {

Camera camera_of(double horizontal_fov_deg, const Eigen::Vector3d& look_at_m) {
  SceneDefinition scene;
  scene.camera = CameraDefinition{
      .position_m = {1, 2, 3}, .look_at_m = look_at_m, .horizontal_fov_deg = horizontal_fov_deg};
  Eigen::Vector3d centre_m;
  return scene_camera(scene, {}, 128, 64, centre_m);
}

TEST(Panorama, LooksWhitherThePerspectiveCameraDoesAndAllRound) {
  for (const Eigen::Vector3d& ahead : {Eigen::Vector3d{0, 0, -1}, {2, 0, 1}, {-3, 0, -0.5}}) {
    const Eigen::Vector3d at = Eigen::Vector3d(1, 2, 3) + ahead;
    const Camera perspective = camera_of(90, at), panorama = camera_of(panorama_fov_deg, at);
    EXPECT_TRUE(wraps(panorama));
    EXPECT_FALSE(wraps(perspective));
    EXPECT_LT((panorama.direction(64, 32) - perspective.direction(64, 32)).norm(), 1e-6F);
    EXPECT_LT((panorama.direction(80, 32) - perspective.direction(128, 32)).norm(), 1e-6F);  // 45 degrees
    EXPECT_LT((panorama.direction(96, 32) - perspective.axes.col(0)).norm(), 1e-6F);
    EXPECT_LT((panorama.direction(0, 32) - panorama.direction(128, 32)).norm(), 1e-6F);
    EXPECT_LT((panorama.direction(17, 0) - Eigen::Vector3f::UnitY()).norm(), 1e-6F);
  }
}

/// Of two eyes, and of one more panorama from the axis where parallax is the mesh's.
Camera stereo_camera(Parallax parallax) {
  return view_camera(camera_of(panorama_fov_deg, {2, 2, 4}),
                     {.kind = ViewKind::omnidirectional, .separation_m = 0.2, .parallax = parallax});
}

TEST(Panorama, EachEyeSeesAPointFromItsPlaceBesideTheAxis) {
  const Camera camera = stereo_camera(Parallax::depth);
  ASSERT_EQ(camera.width_px, 128);
  ASSERT_EQ(camera.height_px, 3 * 64);
  const std::array<double, 3> eye_right_m = {-0.1, 0.1, 0};
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    // A point by its azimuth from the middle column, its distance from the axis and its height.
    const double azimuth = (random.uniform() - 0.5) * 6, distance_m = 0.3 + 5 * random.uniform(),
                 height_m = 4 * (random.uniform() - 0.5);
    const Eigen::Vector3f ahead = camera.direction(64, 32), right(-ahead.z(), 0, ahead.x());
    const Eigen::Vector3f point = (static_cast<float>(distance_m * std::cos(azimuth)) * ahead +
                                   static_cast<float>(distance_m * std::sin(azimuth)) * right +
                                   static_cast<float>(height_m) * Eigen::Vector3f::UnitY());
    for (std::size_t eye = 0; eye < 3; ++eye) {
      const double e = eye_right_m[eye];
      const double seen_at = azimuth - std::asin(e / distance_m);
      const double elevation = std::atan2(height_m, std::sqrt(distance_m * distance_m - e * e));
      const double column = (seen_at / (2 * std::numbers::pi) + 0.5) * 128;
      const double row = (0.5 - elevation / std::numbers::pi) * 64;
      if (column < 0 || column >= 128) continue;
      const int x = static_cast<int>(column), y = static_cast<int>(row) + 64 * static_cast<int>(eye);
      const Eigen::Vector3f direction = camera.direction_within(
          x, y, static_cast<float>(column - std::floor(column)), static_cast<float>(row - std::floor(row)));
      const float miss_m = (point - camera.place_m(x, y)).cross(direction).norm();
      // The eye stands as for the pixel's middle: at most half a column beside.
      EXPECT_LT(miss_m, 1e-5 + std::abs(e) * std::numbers::pi / 128) << i << " eye " << eye;
    }
  }
}

TEST(Panorama, RowsOfTheEyesPanoramasAreWorthTheSame) {
  const TileGrid one{128, 64, true}, two{128, 128, true};
  for (int tile = 0; tile < one.count(); ++tile) {
    EXPECT_DOUBLE_EQ(two.weight(tile), one.weight(tile));
    EXPECT_DOUBLE_EQ(two.weight(one.count() + tile), one.weight(tile));
    EXPECT_DOUBLE_EQ(two.share(tile), one.share(tile) / 2);
  }
}

TEST(Panorama, RowsAreWorthTheirSolidAngle) {
  const TileGrid grid{128, 64, true};
  double all = 0;
  for (int tile = 0; tile < grid.count(); ++tile) all += grid.share(tile);
  EXPECT_NEAR(all, 1, 1e-12);
  // From the pole to 90 degrees: half of the sphere; a quarter of the columns.
  EXPECT_NEAR(grid.share(0), 0.125, 1e-12);
  // The first 16 rows are 45 degrees from the pole: (1 - cos 45) / 2 of the sphere.
  const BlockGrid blocks{128, 64, true};
  EXPECT_NEAR(8 * blocks.share(0), (1 - std::numbers::sqrt2 / 2) / 2, 1e-12);
  EXPECT_EQ((TileGrid{128, 64}.share(0)), 0.125);
}

TEST(Panorama, AnErrorNearThePoleCountsForLess) {
  const auto wrong_in_row = [](int row) {
    const Image right(128, 64, 3, 0.2F);
    HalfPictures pictures{.filtered = {right, right}, .sampled = {right, right}};
    for (int x = 0; x < 128; ++x)
      for (int c = 0; c < 3; ++c)
        pictures.filtered[0].at(x, row, c) = pictures.sampled[0].at(x, row, c) = 0.25F;
    return pictures;
  };
  const double pole = estimate_error(wrong_in_row(0), 0, 1, true).image.noise;
  const double middle = estimate_error(wrong_in_row(31), 0, 1, true).image.noise;
  const double flat = estimate_error(wrong_in_row(31), 0, 1).image.noise;
  EXPECT_NEAR(pole / middle, std::sin(std::numbers::pi / 128) / std::cos(std::numbers::pi / 128), 1e-9);
  EXPECT_NEAR(middle / flat, std::numbers::pi / 2, 0.01);
}

/// The same picture with its columns moved to the left, those on the left coming in on the right.
template <class Value>
std::vector<Value> turned_round(const std::vector<Value>& values, int width_px, int columns) {
  std::vector<Value> out = values;
  for (auto row = out.begin(); row != out.end(); row += width_px)
    std::rotate(row, row + columns, row + width_px);
  return out;
}

/// A floor all round, two metres below, with a crease.
std::vector<Surface> ground(const TileGrid& grid) {
  std::vector<Surface> surfaces;
  const Camera camera = panorama_camera(grid.width_px, grid.height_px);
  for (int y = 0; y < grid.height_px; ++y)
    for (int x = 0; x < grid.width_px; ++x) {
      const Eigen::Vector3f direction = camera.centre_direction(x, y);
      if (direction.y() > -0.1F) {
        surfaces.emplace_back();
        continue;
      }
      const float distance_m = -2 / direction.y();
      surfaces.push_back({.normal = Eigen::Vector3f::UnitY(),
                          .position_m = direction * distance_m,
                          .distance_m = distance_m,
                          .inverse_reach = x % 50 == 0 ? 3.0F : 0.5F});
    }
  return surfaces;
}

TEST(Panorama, FiltersKnowNoFirstColumn) {
  const TileGrid grid{96, 48, true};
  const std::vector<Surface> surfaces = ground(grid);
  Random random(7);
  std::vector<BounceTexel> sampled(surfaces.size());
  for (BounceTexel& texel : sampled) {
    texel.without_object(0) = Rgb::Constant(static_cast<float>(random.uniform()));
    texel.without_samples(0) = texel.without_samples(1) = 2.0F;
  }
  for (const bool keeps_sum : {true, false}) {
    const FilterStrength strength{.levels = 3, .reach_divisor = 0.05F, .keeps_sum = keeps_sum};
    std::vector<BounceTexel> filtered = sampled;
    filter_bounce(surfaces, grid, strength, 2, filtered);
    const std::vector<BounceTexel> wanted = turned_round(filtered, grid.width_px, 37);
    std::vector<BounceTexel> found = turned_round(sampled, grid.width_px, 37);
    filter_bounce(turned_round(surfaces, grid.width_px, 37), grid, strength, 2, found);
    int changed = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      ASSERT_EQ(found[i].without_object(0)[0], wanted[i].without_object(0)[0]) << i;
      changed += filtered[i].without_object(0)[0] != sampled[i].without_object(0)[0] ? 1 : 0;
    }
    EXPECT_GT(changed, 1000);
  }
}

TEST(Panorama, PocketsAreFilteredAcrossTheSeam) {
  const TileGrid grid{64, 32, true};
  std::vector<StimulusPixel> sums(64 * 32);
  for (StimulusPixel& pixel : sums) pixel.uncovered_surfaces = 1;
  const std::vector<Guide> guides(sums.size(), {.normal = Eigen::Vector3f::UnitY(), .distance_m = 1});
  const std::vector<bool> all(sums.size(), true);
  std::vector<float> light(sums.size(), 0.0F);
  light[grid.index(0, 16)] = 1;
  const std::vector<float> round = filter_pockets(light, sums, all, guides, grid, 1);
  const std::vector<float> flat = filter_pockets(light, sums, all, guides, {64, 32}, 1);
  EXPECT_NEAR(round[grid.index(63, 16)], round[grid.index(1, 16)], 1e-7F);
  EXPECT_GT(round[grid.index(63, 16)], 0.01F);
  EXPECT_EQ(flat[grid.index(63, 16)], 0.0F);
}

TEST(Panorama, TilesOnEitherSideOfTheSeamAreNeighbours) {
  TileSet one(12, 0);
  one[4] = 1;  // the first of the second row of four
  const TileSet around = with_neighbours({128, 96, true}, one);
  EXPECT_EQ(around, (TileSet{1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1}));
  EXPECT_EQ(with_neighbours({128, 96}, one), (TileSet{1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0}));
}

}  // namespace
}  // namespace seamline::renderer
