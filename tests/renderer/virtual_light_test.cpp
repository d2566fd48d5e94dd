// Light that exists only with the objects: real surfaces of a photograph brighten as they would in truth.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <span>

#include "composites/fast_photo.h"
#include "composites/photo_composite.h"
#include "renderer/depth/capture.h"
#include "renderer/depth/depth_mesh.h"
#include "shapes.h"

namespace seamline::renderer {
namespace {

constexpr float lit_floor_m = -1.5F, lit_floor_albedo = 0.35F, sky_of_photograph = 0.8F;

/// A floor of an albedo that the local scene does not know, under a sky, and its photograph.
class VirtualLight : public testing::Test {
 protected:
  VirtualLight() : depth_(mesh(), Rgb::Constant(0.5F)), nothing_(Meshes()) {
    camera_.width_px = 32;
    camera_.height_px = 24;
    camera_.axes.col(1) = Eigen::Vector3f(0, 0.6F, -0.8F);  // looks down onto the floor
    camera_.axes.col(2) = Eigen::Vector3f(0, 0.8F, 0.6F);
    photograph_ = Image(32, 24, 3, lit_floor_albedo * sky_of_photograph);
    light_.environment_radiance = Rgb::Constant(sky_of_photograph);
    light_.bounces = 0;
    lamp_.bounces = 0;
    lamp_.skips_sky = true;
    Lamp lamp;
    lamp.position_m = {0.3F, -0.5F, -1.2F};
    lamp.intensity_w_sr = Rgb(2, 1, 0.5F);
    lamp_.lamps = {lamp};
  }
  static std::span<const std::shared_ptr<const SurfaceMesh>> Meshes() { return {}; }
  static DepthMesh mesh() {
    const std::vector<std::shared_ptr<const SurfaceMesh>> room = {test::floor(lit_floor_m, 20)};
    return build_depth_mesh(capture_depth(Geometry(room), 1024, 0, 2), {.threads = 2});
  }
  [[nodiscard]] PhotoScene scene(const Light* added) const {
    return {.photograph = photograph_,
            .camera = camera_,
            .depth = depth_,
            .objects = nothing_,
            .light = light_,
            .added = added};
  }
  [[nodiscard]] Image picture(const Light* added, Compositing compositing = Compositing::ratio) const {
    return compose_photo(photo_by_path(scene(added), {}, 0, {.spp = 64, .threads = 2}).sums, compositing, 2)
        .picture;
  }

  Camera camera_;
  Image photograph_;
  Light light_, lamp_;
  Geometry depth_, nothing_;
};

TEST_F(VirtualLight, ALampBrightensASurfaceAsMuchAsItsTrueAlbedoWould) {
  const Image made = picture(&lamp_);
  const Lamp& lamp = lamp_.lamps[0];
  for (const auto& [x, y] : {std::pair{16, 12}, {8, 16}, {24, 6}}) {
    const auto hit = depth_.nearest(centre_ray(camera_, x, y));
    ASSERT_TRUE(hit);
    const Eigen::Vector3f to_lamp = lamp.position_m - hit->position_m;
    const float square_m2 = to_lamp.squaredNorm(), cosine = to_lamp.normalized().y();
    for (int c = 0; c < 3; ++c) {
      const float added =
          lit_floor_albedo / std::numbers::pi_v<float> * lamp.intensity_w_sr[c] * cosine / square_m2;
      EXPECT_NEAR(made.at(x, y, c) - photograph_.at(x, y, c), added, 0.03F * added)
          << x << " " << y << " " << c;
    }
  }
}

TEST_F(VirtualLight, LightAddsUpAndNoneChangesNothing) {
  Light twice = lamp_, none = lamp_;
  twice.lamps[0].intensity_w_sr *= 2;
  none.lamps[0].intensity_w_sr = Rgb::Zero();
  const Image without = picture(nullptr), once = picture(&lamp_), two = picture(&twice),
              dark = picture(&none);
  EXPECT_EQ(dark.values, without.values);
  for (std::size_t i = 0; i < once.values.size(); ++i)
    ASSERT_NEAR(two.values[i] - without.values[i], 2 * (once.values[i] - without.values[i]), 1e-5F);
}

TEST_F(VirtualLight, NoSurfaceBecomesBrighterThanAWhiteOneWould) {
  photograph_ = Image(32, 24, 3, 5 * sky_of_photograph);  // of no surface under this sky
  const Image made = picture(&lamp_);
  const auto hit = depth_.nearest(centre_ray(camera_, 16, 12));
  const Eigen::Vector3f to_lamp = lamp_.lamps[0].position_m - hit->position_m;
  const float white = lamp_.lamps[0].intensity_w_sr[0] * to_lamp.normalized().y() / to_lamp.squaredNorm() /
                      std::numbers::pi_v<float>;
  EXPECT_NEAR(made.at(16, 12) - photograph_.at(16, 12), white, 0.03F * white);
}

TEST_F(VirtualLight, ObjectsStandInItsWay) {
  const std::vector<std::shared_ptr<const SurfaceMesh>> ball = {
      test::sphere({0.3F, -0.9F, -1.2F}, 0.1F, 32, 0.5F, 1)};
  const Geometry objects(ball);
  const PhotoScene shaded{.photograph = photograph_,
                          .camera = camera_,
                          .depth = depth_,
                          .objects = objects,
                          .light = light_,
                          .added = &lamp_};
  EXPECT_FALSE(fast_can_render(shaded));
  const PhotoEstimate made = photo_by_path(shaded, {}, 0, {.spp = 16, .threads = 2});
  // Below the ball the lamp does not reach: what was added there is nothing.
  int dark = 0, lit = 0;
  for (std::size_t i = 0; i < made.sums.halves[0].size(); ++i) {
    if (made.sums.halves[0][i].uncovered_surfaces < 8) continue;
    ((made.sums.added[0][i].sent > 0.0F).any() ? lit : dark) += 1;
  }
  EXPECT_GT(dark, 5);
  EXPECT_GT(lit, 100);
}

}  // namespace
}  // namespace seamline::renderer
