// What the surfaces of a photographed panorama send to objects follows what these let them receive.
#include "composites/light/sent_light.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "renderer/depth/capture.h"
#include "renderer/depth/depth_map.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/transport/transport.h"
#include "shapes.h"

namespace seamline::renderer {
namespace {

using Meshes = std::vector<std::shared_ptr<const SurfaceMesh>>;
constexpr float floor_m = -1.6F;

std::shared_ptr<const SurfaceMesh> floor_of(float albedo) {
  return test::shape_of({{-40, floor_m, 40}, {40, floor_m, 40}, {40, floor_m, -40}, {-40, floor_m, -40}},
                        {{0, 1, 2}, {0, 2, 3}}, {.albedo = albedo});
}

/// A floor under a sky of radiance 1, as a panorama shows it: radiances of sky and floor.
struct PhotographedFloor {
  std::shared_ptr<Geometry> local;
  Light light;
  SentLight sent;

  explicit PhotographedFloor(float floor_radiance, int albedo_columns = 256) {
    Image panorama(256, 128, 3, 1.0F);
    for (int y = 64; y < 128; ++y)
      for (int x = 0; x < 256; ++x) panorama.set_rgb(x, y, Rgb::Constant(floor_radiance));
    const DepthMesh mesh =
        build_depth_mesh(capture_depth(Geometry(Meshes{floor_of(0.5F)}), 1024, 0, 2), {.threads = 2});
    local = std::make_shared<Geometry>(mesh, Rgb::Constant(0.5F));
    light.environment = std::make_shared<EnvironmentMap>(std::move(panorama), 0.0F);
    light.bounces = 8;
    sent = follow_received_light(local, light, 8.0F, albedo_columns, 2);
  }
};

/// Radiance of a real point with the object, as a share of that without.
float ratio_at(const Geometry& real, const Geometry& object, const Light& light, float x_m, int samples) {
  const auto point = real.nearest({Eigen::Vector3f::Zero(), Eigen::Vector3f(x_m, floor_m, -2).normalized()});
  float without_object = 0, with_object = 0;
  for (int i = 0; point && i < samples; ++i) {
    const RadiancePair pair = radiance_with_and_without(real, &object, *point, light, Sampler(1, 0, 0, i));
    without_object += pair.without_object.total()[1];
    with_object += pair.with_object.total()[1];
  }
  return with_object / without_object;
}

TEST(SentLight, ContactShadowsAreAsDeepAsInTheSceneItself) {
  for (const auto& [albedo, columns] : {std::pair{0.3F, 256}, std::pair{0.8F, 256}, std::pair{0.8F, 128}}) {
    const PhotographedFloor photo(albedo,
                                  columns);  // under a whole sky of radiance 1 a floor sends its albedo
    EXPECT_NEAR(photo.sent.share_above_one, 0, 0.001);
    const Meshes ball = {test::sphere({0, floor_m + 0.4F, -2}, 0.4F, 64, 0.5F, 1)};
    const Geometry object(ball), truth(Meshes{floor_of(albedo)});
    Light sky;
    sky.environment_radiance = Rgb::Ones();
    sky.bounces = 8;
    for (const float x_m : {0.05F, 0.15F, 0.3F, 0.5F, 0.9F})
      EXPECT_NEAR(ratio_at(*photo.local, object, photo.light, x_m, 4096),
                  ratio_at(truth, object, sky, x_m, 4096), 0.03F)
          << albedo << " at " << x_m << " m from the foot";
  }
}

TEST(SentLight, AFloorBrighterThanItsLightAllowsSendsWhatAWhiteOneWould) {
  const PhotographedFloor photo(3.0F);
  EXPECT_NEAR(photo.sent.most_albedo, 3, 0.5);
  EXPECT_GT(photo.sent.share_above_one, 0.95);
  const Meshes ball = {test::sphere({0, floor_m + 0.4F, -2}, 0.4F, 64, 0.9F, 1)};
  const Geometry object(ball);
  for (const float x_m : {0.05F, 0.15F, 0.3F, 0.5F, 0.9F})
    EXPECT_LT(ratio_at(*photo.local, object, photo.light, x_m, 4096), 1.02F) << x_m;
}

/// A room lit by one window, whose floor is white; a panorama of codes shows the floor brighter than it can
/// be, and the window no brighter than white.
class WindowRoom {
 public:
  static constexpr float low_m = -1.2F, high_m = 1.6F, half_m = 3.0F, wall_radiance = 0.026F;

  WindowRoom() : truth_(std::span<const std::shared_ptr<const SurfaceMesh>>(parts())) {
    Image panorama(256, 128, 3);
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 256; ++x) {
        const auto hit = truth_.nearest(
            {Eigen::Vector3f::Zero(), panorama_direction(x + 0.5, y + 0.5, 256, 128).cast<float>()});
        panorama.set_rgb(x, y, hit->albedo[1] > 0.5F ? Rgb::Constant(0.263F) : hit->emission);
      }
    const DepthMesh mesh = build_depth_mesh(capture_depth(truth_, 1024, 0, 2), {.threads = 2});
    local_ = std::make_shared<Geometry>(mesh, Rgb::Constant(0.5F));
    light_.environment = std::make_shared<EnvironmentMap>(std::move(panorama), 0.0F);
    light_.bounces = lit_.bounces = 8;
    lit_.emitters = std::make_shared<EmittingSurfaces>(parts());
    sent_ = follow_received_light(local_, light_, 1.0F, 256, 2);
  }

  [[nodiscard]] const SentLight& sent() const { return sent_; }
  [[nodiscard]] float ratio_in_truth(const Geometry& object, const Eigen::Vector3f& towards) const {
    return ratio(truth_, object, lit_, towards);
  }
  [[nodiscard]] float ratio_in_photograph(const Geometry& object, const Eigen::Vector3f& towards) const {
    return ratio(*local_, object, light_, towards);
  }

 private:
  static Meshes parts() {
    const auto quad = [](const std::array<Eigen::Vector3f, 4>& corner, float albedo, float radiance) {
      return test::shape_of({corner[0], corner[1], corner[2], corner[3]}, {{0, 1, 2}, {0, 2, 3}},
                            {.albedo = albedo, .emission = radiance});
    };
    const float h = half_m, y0 = low_m, y1 = high_m, window_m = 0.001F - half_m;
    return {quad({{{-h, y0, h}, {h, y0, h}, {h, y0, -h}, {-h, y0, -h}}}, 1, 0),
            quad({{{-h, y1, h}, {h, y1, h}, {h, y1, -h}, {-h, y1, -h}}}, 0, wall_radiance),
            quad({{{-h, y0, -h}, {h, y0, -h}, {h, y1, -h}, {-h, y1, -h}}}, 0, wall_radiance),
            quad({{{-h, y0, h}, {h, y0, h}, {h, y1, h}, {-h, y1, h}}}, 0, wall_radiance),
            quad({{{-h, y0, -h}, {-h, y0, h}, {-h, y1, h}, {-h, y1, -h}}}, 0, wall_radiance),
            quad({{{h, y0, -h}, {h, y0, h}, {h, y1, h}, {h, y1, -h}}}, 0, wall_radiance),
            quad({{{-0.79F, 0.04F, window_m},
                   {0.79F, 0.04F, window_m},
                   {0.79F, 1.24F, window_m},
                   {-0.79F, 1.24F, window_m}}},
                 0, 1)};
  }
  static float ratio(const Geometry& real, const Geometry& object, const Light& light,
                     const Eigen::Vector3f& towards) {
    auto point = real.nearest({Eigen::Vector3f::Zero(), towards.normalized()});
    point->albedo = Rgb::Ones();
    float without_object = 0, with_object = 0;
    for (int i = 0; i < 8192; ++i) {
      const RadiancePair pair = radiance_with_and_without(real, &object, *point, light, Sampler(1, 0, 0, i));
      without_object += pair.without_object.total()[1];
      with_object += pair.with_object.total()[1];
    }
    return with_object / without_object;
  }

  Geometry truth_;
  std::shared_ptr<Geometry> local_;
  Light light_, lit_;
  SentLight sent_;
};

TEST(SentLight, AFloorTooBrightForItsWindowIsShadowedAsAWhiteOneInThatRoom) {
  const WindowRoom room;
  EXPECT_GT(room.sent().share_above_one, 0.3);
  const Meshes ball = {test::sphere({0, WindowRoom::low_m + 0.25F, -1.8F}, 0.25F, 64, 0.8F, 1)};
  const Geometry object(ball);
  for (const float z_m : {-2.5F, -2.1F, -1.9F, -1.7F, -1.6F, -1.5F, -1.3F, -1.0F}) {
    const Eigen::Vector3f place(0.05F, WindowRoom::low_m, z_m);
    EXPECT_NEAR(room.ratio_in_photograph(object, place), room.ratio_in_truth(object, place), 0.04F) << z_m;
  }
}

TEST(SentLight, TheImpliedAlbedoIsTheScenesOwn) {
  for (const std::optional<double> error : {std::optional<double>{}, std::optional<double>{0.034}}) {
    const PhotographedFloor photo(0.3F, implied_albedo_columns(error));
    EXPECT_NEAR(photo.local->nearest({Eigen::Vector3f::Zero(), {0, -1, 0}})->albedo[1], 0.3F, 0.01F);
  }
}

}  // namespace
}  // namespace seamline::renderer
