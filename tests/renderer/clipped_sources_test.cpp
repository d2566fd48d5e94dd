// A panorama of codes shows a window as white, however bright it was: its surfaces say how bright at least.
#include "composites/light/clipped_sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "renderer/depth/capture.h"
#include "renderer/depth/depth_map.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/transport/transport.h"
#include "shapes.h"

namespace seamline::renderer {
namespace {

/// A closed box of one albedo, lit by a square of its ceiling, and its panorama as a camera of codes has it.
class ClippedRoom {
 public:
  ClippedRoom(float albedo, float radiance)
      : truth_(std::span<const std::shared_ptr<const SurfaceMesh>>(parts(albedo, radiance))) {
    Light lit;
    lit.emitters = std::make_shared<EmittingSurfaces>(parts(albedo, radiance));
    lit.bounces = 12;
    for (int y = 0; y < panorama_.height_px; ++y)
      for (int x = 0; x < panorama_.width_px; ++x) {
        const auto hit = truth_.nearest(
            {Eigen::Vector3f::Zero(),
             panorama_direction(x + 0.5, y + 0.5, panorama_.width_px, panorama_.height_px).cast<float>()});
        Rgb sum = Rgb::Zero();
        constexpr int samples = 64;
        for (int i = 0; i < samples; ++i)
          sum += radiance_with_and_without(truth_, nullptr, *hit, lit, Sampler(1, x, y, i))
                     .without_object.total() /
                 samples;
        panorama_.set_rgb(x, y, sum.min(1.0F));
      }
    local_.emplace(build_depth_mesh(capture_depth(truth_, 1024, 0, 2), {.threads = 2}), Rgb::Constant(0.5F));
  }
  [[nodiscard]] ClippedSources found(int threads = 2) const {
    return find_clipped_sources(panorama_, *local_, 1.0F, threads);
  }
  Image panorama_{64, 32, 3};

 private:
  static std::vector<std::shared_ptr<const SurfaceMesh>> parts(float albedo, float radiance) {
    const auto lamp = test::shape_of(
        {{-0.6F, 1.39F, 0.6F}, {0.6F, 1.39F, 0.6F}, {0.6F, 1.39F, -0.6F}, {-0.6F, 1.39F, -0.6F}},
        {{0, 2, 1}, {0, 3, 2}}, {.albedo = 0, .emission = radiance});
    return {test::box({-2, -1.4F, -2}, {2, 1.4F, 2}, albedo), lamp};
  }
  Geometry truth_;
  std::optional<Geometry> local_;
};

TEST(ClippedSources, BrightSurfacesSayHowBrightTheirLampWas) {
  const ClippedRoom bright(0.8F, 6);
  const ClippedSources found = bright.found();
  EXPECT_GT(found.factor, 3.5);
  EXPECT_LT(found.factor, 6.5);
  EXPECT_GT(found.share, 0.005);
  EXPECT_EQ(bright.found(1).factor, found.factor);
}

TEST(ClippedSources, DarkerOnesSayLessAndUnclippedLampsStayAsTheyAre) {
  const ClippedSources grey = ClippedRoom(0.5F, 6).found();
  EXPECT_GT(grey.factor, 1.5);
  EXPECT_LT(grey.factor, 6.0) << "no surface is white";
  EXPECT_NEAR(grey.factor_of_grey, 6.0, 0.6) << "the lamp's radiance over white's, where every wall is grey";
  EXPECT_EQ(ClippedRoom(0.5F, 0.9F).found().share, 0);
  Image codes(4, 2, 3, 0.5F);
  codes.set_rgb(1, 0, Rgb::Ones());
  raise_clipped_sources(codes, 1, 3);
  EXPECT_EQ(codes.at(1, 0), 3.0F);
  EXPECT_EQ(codes.at(0, 0), 0.5F);
}

}  // namespace
}  // namespace seamline::renderer
