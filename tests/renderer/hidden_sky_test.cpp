// Through a window, other places see sky that the panorama's own place does not.
#include "composites/light/hidden_sky.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "renderer/depth/capture.h"
#include "renderer/depth/depth_map.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/transport/transport.h"
#include "shapes.h"

namespace seamline::renderer {
namespace {

using Meshes = std::vector<std::shared_ptr<const SurfaceMesh>>;

/// Floor and walls of a room whose ceiling is open, black.
Meshes open_room() {
  const auto quad = [](const std::array<Eigen::Vector3f, 4>& c) {
    return test::shape_of({c[0], c[1], c[2], c[3]}, {{0, 1, 2}, {0, 2, 3}}, {.albedo = 0});
  };
  return {quad({{{-2, -1, 2}, {2, -1, 2}, {2, -1, -2}, {-2, -1, -2}}}),
          quad({{{-2, -1, -2}, {2, -1, -2}, {2, 1, -2}, {-2, 1, -2}}}),
          quad({{{-2, -1, 2}, {2, -1, 2}, {2, 1, 2}, {-2, 1, 2}}}),
          quad({{{-2, -1, -2}, {-2, -1, 2}, {-2, 1, 2}, {-2, 1, -2}}}),
          quad({{{2, -1, -2}, {2, -1, 2}, {2, 1, 2}, {2, 1, -2}}})};
}

TEST(HiddenSky, ASkyOfOneRadianceLightsEveryPlaceOfARoomAsInTheRoomItself) {
  const Geometry truth(open_room());
  Image panorama(512, 256, 3);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 512; ++x)
      if (!truth.occluded(
              {Eigen::Vector3f::Zero(), panorama_direction(x + 0.5, y + 0.5, 512, 256).cast<float>()}))
        panorama.set_rgb(x, y, Rgb::Constant(3.0F));
  const DepthMesh mesh = build_depth_mesh(capture_depth(truth, 1024, 0, 2), {.threads = 2});
  const auto local = std::make_shared<const Geometry>(mesh, Rgb::Zero());
  Light photographed, sky;
  photographed.environment = std::make_shared<EnvironmentMap>(std::move(panorama), 0.0F);
  photographed.photographed = local;
  photographed.hidden_sky = fill_hidden_sky(*local, *photographed.environment, 2);
  ASSERT_NE(photographed.hidden_sky, nullptr);
  sky.environment_radiance = Rgb::Constant(3.0F);
  for (const auto& [x_m, z_m] : {std::pair{0.0F, -0.5F}, {1.8F, 0.0F}, {-1.5F, -1.8F}}) {
    const Eigen::Vector3f towards = Eigen::Vector3f(x_m, -1, z_m).normalized();
    std::array<float, 2> sent = {};
    for (const bool is_photograph : {false, true}) {
      auto point = (is_photograph ? *local : truth).nearest({Eigen::Vector3f::Zero(), towards});
      ASSERT_TRUE(point);
      point->albedo = Rgb::Ones();
      for (int i = 0; i < 4096; ++i)
        sent[is_photograph ? 1U : 0U] +=
            radiance_with_and_without(is_photograph ? *local : truth, nullptr, *point,
                                      is_photograph ? photographed : sky, Sampler(1, 0, 0, i))
                .without_object.total()[1] /
            4096;
    }
    EXPECT_NEAR(sent[1] / sent[0], 1, 0.03) << x_m << " " << z_m;
  }
}

TEST(HiddenSky, IsNoneWhereNothingIsHiddenOrNothingIsSky) {
  const EnvironmentMap panorama(Image(64, 32, 3, 1.0F), 0.0F);
  const Meshes closed = {test::box({-2, -1, -2}, {2, 1, 2}, 0.5F)};
  EXPECT_EQ(fill_hidden_sky(Geometry(closed), panorama, 1), nullptr);
  EXPECT_EQ(fill_hidden_sky(Geometry(Meshes{}), panorama, 1), nullptr);
}

}  // namespace
}  // namespace seamline::renderer
