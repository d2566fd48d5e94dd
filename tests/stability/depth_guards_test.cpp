// Each guard of depth maps and of the adaptive mesh is taken away, and the case that watches it must fail.
#include <gtest/gtest.h>

#include <limits>

#include "laboratory/stability/depth/bound_cases.h"
#include "laboratory/stability/depth/depth_size_cases.h"
#include "laboratory/stability/depth/depth_value_cases.h"
#include "renderer/depth/full_mesh.h"
#include "support/files/image.h"

namespace seamline::stability {
using namespace renderer;
namespace {

/// Takes every texel for a distance.
DepthMesh mesh_without_cleaning(const DepthMap& map, const MeshOptions&) {
  return build_full_mesh(make_dense_sphere(map, 0, 1), 1);
}

TEST(DepthGuards, TexelsThatAreNoDistancesSpoilTheMesh) {
  EXPECT_EQ(try_bad_texels(0, true).error, 0);
  EXPECT_GT(try_bad_texels(0, true, mesh_without_cleaning).error, 0);
}

/// Sky as something far away.
DepthMesh mesh_with_far_sky(const DepthMap& map, const MeshOptions& options) {
  DepthMap filled = map;
  for (float& distance_m : filled.distance_m)
    if (is_hole(distance_m)) distance_m = 1e4F;
  return build_depth_mesh(filled, options);
}

TEST(DepthGuards, SkyThatIsTakenForAWallHidesEverything) {
  EXPECT_EQ(try_one_texel().error, 0);
  EXPECT_GT(try_one_texel(mesh_with_far_sky).error, 0);
}

TEST(DepthGuards, FilesOfAnySizeAreAcceptedWithoutTheCheck) {
  const ReadRule read_anything = [](const std::filesystem::path& path) {
    Image image = read_image(path);
    return DepthMap{.width_px = image.width_px, .height_px = image.height_px, .distance_m = image.values};
  };
  for (const bool odd : {true, false}) {
    EXPECT_EQ(try_wrong_sizes(odd).error, 0);
    EXPECT_GE(try_wrong_sizes(odd, read_anything).error, 5);
  }
}

const RandomMaps few{.count = 30, .seed = 3};

TEST(DepthGuards, AMeshThatDoesNotLookAtItsToleranceExceedsIt) {
  EXPECT_LE(try_bound(few).error, 1 + 1e-6);
  const BoundRule loose = [](const DenseSphere& sphere, double) {
    return build_adaptive_mesh(sphere, 0.5, 1);
  };
  EXPECT_GT(try_bound(few, loose).error, 2);
  EXPECT_GT(try_tolerance_0(few, loose).error, 0);
}

TEST(DepthGuards, AMeshThatFillsHolesCoversThem) {
  EXPECT_EQ(try_holes(few).error, 0);
  const BoundRule filling = [](const DenseSphere& sphere, double tolerance) {
    DepthMap map = make_depth_map(sphere.width, [&](int column, int row) {
      return is_hole(sphere.at(row, column)) ? 5.0 : static_cast<double>(sphere.at(row, column));
    });
    return build_adaptive_mesh(make_dense_sphere(map, 0, 1, sphere.width), tolerance, 1);
  };
  EXPECT_GT(try_holes(few, filling).error, 0);
}

TEST(DepthGuards, AMeshThatSaysNothingOfItsErrorIsCaught) {
  EXPECT_LE(try_reported_error(few).error, 1e-6);
  const BoundRule silent = [](const DenseSphere& sphere, double tolerance) {
    DepthMesh mesh = build_adaptive_mesh(sphere, tolerance, 1);
    mesh.max_relative_error = 0;
    return mesh;
  };
  EXPECT_GT(try_reported_error(few, silent).error, 0.1);
}

TEST(DepthGuards, AMeshThatLacksATriangleIsNotWatertight) {
  const RandomMaps whole{.count = 5, .seed = 3, .kind = {.holes = false}};
  EXPECT_EQ(try_watertight(whole).error, 0);
  const BoundRule cracked = [](const DenseSphere& sphere, double tolerance) {
    DepthMesh mesh = build_adaptive_mesh(sphere, tolerance, 1);
    mesh.triangles.pop_back();
    return mesh;
  };
  EXPECT_EQ(try_watertight(whole, cracked).error, 15);
}

}  // namespace
}  // namespace seamline::stability
