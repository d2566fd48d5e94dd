// The board of a marker as a scene file.
#include "laboratory/figures/marker_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "raytracer/scene/scene_file.h"
#include "raytracer/scene/truth_scene.h"
#include "raytracer/tracing/geometry.h"
#include "registration/calibration/aruco.h"

namespace seamline::renderer {
namespace {

/// Rays from the camera through the squares meet black and white as the pattern says, with white all round.
TEST(MarkerScene, ItsSquaresAreThePattern) {
  const auto path = std::filesystem::path(SEAMLINE_TEST_OUTPUT) / "marker.glb";
  std::filesystem::create_directories(path.parent_path());
  const MarkerBoard board{.side_m = 0.12, .wall_m = 0.7, .camera_m = 1.5};
  write_marker_scene(path, board);
  const SceneFile file = read_scene_file(path);
  ASSERT_EQ(file.meshes.size(), 3U);
  ASSERT_TRUE(file.camera);
  SceneDefinition definition;
  Eigen::Vector3d centre_m;
  const Camera camera = scene_camera(definition, file, 640, 480, centre_m);
  EXPECT_NEAR(centre_m.z(), 1.5, 1e-6);
  EXPECT_NEAR(2 * std::atan(static_cast<double>(camera.tan_half_horizontal)) * 180 / std::numbers::pi,
              marker_view_deg, 1e-3);
  const Geometry geometry(place_meshes(file, Eigen::Affine3d::Identity(), centre_m, 0.5, 0));
  using registration::marker_squares;
  for (int row = -2; row <= marker_squares + 1; ++row)
    for (int column = -2; column <= marker_squares + 1; ++column) {
      const double square_m = board.side_m / marker_squares;
      const Eigen::Vector3d towards((column + 0.5 - 0.5 * marker_squares) * square_m,
                                    (0.5 * marker_squares - row - 0.5) * square_m, -board.camera_m);
      const auto hit = geometry.nearest({Eigen::Vector3f::Zero(), towards.normalized().cast<float>()});
      ASSERT_TRUE(hit);
      const bool in_marker = row >= 0 && row < marker_squares && column >= 0 && column < marker_squares;
      const bool on_board = row >= -1 && row <= marker_squares && column >= -1 && column <= marker_squares;
      const bool white =
          !in_marker ||
          registration::marker_pattern[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] != 0;
      EXPECT_NEAR(-hit->position_m.z(), on_board ? 1.5 : 2.2, 1e-5);
      EXPECT_NEAR(hit->albedo[0], !on_board ? 0.4 : white ? 0.85 : 0.05, 1e-6) << row << " " << column;
    }
}

}  // namespace
}  // namespace seamline::renderer
