// Composites in which something given answers in place of the local scene: the fast estimator beside the path
// one, each with the error that it reports.
#include <gtest/gtest.h>

#include "composites/fast_photo.h"
#include "composites/photo_composite.h"
#include "composites/photograph.h"
#include "renderer/depth/capture.h"
#include "renderer/depth/depth_mesh.h"
#include "shapes.h"
#include "stimuli/pictures/difference.h"

namespace seamline::renderer {
namespace {

using Meshes = std::vector<std::shared_ptr<const SurfaceMesh>>;

enum class Seen { view, panorama };
enum class Lit { sun_and_sky, photographed };

/// A floor and posts under a sun, as a coarse depth map knows them; one post stands before a ball. Behind the
/// floor's end there is sky, and the photograph is another colour everywhere.
class MaskedWorld {
 public:
  MaskedWorld(Seen seen, Lit lit) {
    camera_ = Camera{.width_px = 60, .height_px = 40};
    if (seen == Seen::panorama) camera_ = panorama_camera(96, 48);
    const Meshes world = {test::floor(-1, 8), test::box({-0.5F, -1, -3.2F}, {-0.2F, 0.4F, -3}, 0.5F),
                          test::box({1.2F, -1, -5.5F}, {1.6F, 1.5F, -5}, 0.5F)};
    map_ = capture_depth(Geometry(world), 256, 0, 2);
    mesh_ = build_depth_mesh(map_, {.threads = 2});
    depth_ = std::make_shared<const Geometry>(mesh_, Rgb::Constant(0.5F));
    objects_.emplace(ball_);
    photograph_ = Image(camera_.width_px, camera_.height_px, 3);
    for (int y = 0; y < camera_.height_px; ++y)
      for (int x = 0; x < camera_.width_px; ++x)
        photograph_.set_rgb(x, y, colour(camera_.centre_direction(x, y)));
    light_.bounces = 2;
    light_.suns = {{Eigen::Vector3f(0.5F, 1, 0.3F).normalized(), Rgb(3, 2.7F, 2.4F), 0.02F}};
    if (lit == Lit::sun_and_sky) {
      light_.environment_radiance = Rgb(0.3F, 0.4F, 0.5F);
      return;
    }
    Image around(128, 64, 3);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 128; ++x)
        around.set_rgb(x, y, colour(panorama_direction(x + 0.5, y + 0.5, 128, 64).cast<float>()));
    light_.environment = std::make_shared<EnvironmentMap>(std::move(around), 0.0F);
    light_.photographed = depth_;
  }

  /// Makes the ball a polished one.
  void polish() {
    SurfaceMesh ball = *ball_[0];
    ball.albedo = Rgb::Zero();
    ball.f0 = Rgb::Constant(0.9F);
    ball.alpha = 0.02F;
    ball_ = {std::make_shared<const SurfaceMesh>(std::move(ball))};
    objects_.emplace(ball_);
  }

  /// Who is in front by depth itself, looked up where the camera looks; `bits`: of a depth buffer, 0: metres.
  [[nodiscard]] OcclusionTest test(int bits) const {
    OcclusionTest test{.sights = {PanoramaSight{map_, 0}}, .forward = -camera_.axes.col(2)};
    if (bits > 0) test.buffer = sensors::DepthBuffer{.nearest_m = 0.1, .farthest_m = 100, .bits = bits};
    return test;
  }
  /// White in stripes that cross ball, posts and the shadows: before what the local scene has there and
  /// behind it. By direction, or of the photograph's shape in another resolution.
  [[nodiscard]] Mask stripes(bool by_direction, float slope) const {
    const auto value = [&](const Eigen::Vector3f& direction) {
      const float along = direction.x() + slope * direction.y();
      return std::clamp(0.5F + 2.5F * std::sin(18 * along), 0.0F, 1.0F);
    };
    if (by_direction) {
      DirectionMask mask = even_mask(1024, 0);
      for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 1024; ++x)
          mask.texels[static_cast<std::size_t>(y * 1024 + x)] =
              value(panorama_direction(x + 0.5, y + 0.5, 1024, 512).cast<float>());
      return mask;
    }
    PhotographMask mask{Image(3 * camera_.width_px, 3 * camera_.height_px, 1)};
    for (int y = 0; y < mask.values.height_px; ++y)
      for (int x = 0; x < mask.values.width_px; ++x)
        mask.values.at(x, y) =
            value(camera_.direction((static_cast<float>(x) + 0.5F) / 3, (static_cast<float>(y) + 0.5F) / 3));
    return mask;
  }

  [[nodiscard]] PhotoScene scene(const OcclusionTest* test, const Mask* matte) const {
    return {.photograph = photograph_,
            .camera = camera_,
            .depth = *depth_,
            .objects = *objects_,
            .light = light_,
            .occlusion = {.test = test},
            .shadow_matte = matte};
  }
  [[nodiscard]] PhotoEstimate fast(const PhotoScene& scene, std::optional<double> error,
                                   const PassOptions& pass) const {
    return photo_by_fast(scene, {surface_of_depth(mesh_, 0.5), ball_}, error, 0, pass);
  }

  /// Both estimators' pictures agree as far as both say, over the picture and in their sum up to white.
  void expect_agreement(const PhotoScene& scene, const char* what, int traced_spp = 48) const {
    ASSERT_TRUE(fast_can_render(scene));
    const double asked = camera_.directions ? 0.004 : 0.01;  // of a panorama the object is a small part
    const PhotoEstimate quick = fast(scene, asked, {.seed = 5, .threads = 2});
    const PhotoEstimate traced = photo_by_path(scene, {}, 0, {.spp = traced_spp, .seed = 9, .threads = 2});
    const Image a = compose(quick.sums).picture, b = compose(traced.sums).picture;
    EXPECT_LE(quick.error.rmse(), asked) << what;
    EXPECT_LT(display_rmse(a, b, 0), quick.error.rmse() + traced.error.rmse()) << what;
    EXPECT_GT(display_rmse(a, photograph_, 0), 1.5 * asked) << what << ": the object is seen";
    double of_a = 0, of_b = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
      of_a += std::min(1.0, double{a.values[i]}), of_b += std::min(1.0, double{b.values[i]});
    EXPECT_NEAR(of_a / of_b, 1, 0.003) << what;
  }

 private:
  static Rgb colour(const Eigen::Vector3f& direction) {
    return 0.35F + 0.2F * Rgb(direction.x(), direction.y(), -direction.z());
  }

  Camera camera_;
  Image photograph_;
  Light light_;
  DepthMap map_;
  DepthMesh mesh_;
  std::shared_ptr<const Geometry> depth_;
  Meshes ball_ = {test::sphere({-0.2F, -0.4F, -3.8F}, 0.6F, 48, 0.6F, 1)};
  std::optional<Geometry> objects_;
};

TEST(PhotoMask, FastAndPathAgreeWhoeverIsInFront) {
  for (const Seen seen : {Seen::view, Seen::panorama}) {
    const MaskedWorld world(seen, Lit::sun_and_sky);
    OcclusionTest painted = world.test(0), seen_from_centre = world.test(0);
    painted.mask = world.stripes(false, 1);
    seen_from_centre.mask = world.stripes(true, 1);
    world.expect_agreement(world.scene(&painted, nullptr), "mask of the photograph's shape");
    if (seen == Seen::panorama)
      world.expect_agreement(world.scene(&seen_from_centre, nullptr), "mask by direction");
    const OcclusionTest in_metres = world.test(0), in_buffer = world.test(12);
    world.expect_agreement(world.scene(&in_metres, nullptr), "depth test");
    if (seen == Seen::view) world.expect_agreement(world.scene(&in_buffer, nullptr), "depth buffer");
  }
}

TEST(PhotoMask, FastAndPathAgreeOnAMirrorThatASoftSunShinesOn) {
  for (const Lit lit : {Lit::sun_and_sky, Lit::photographed}) {
    MaskedWorld world(Seen::view, lit);
    world.polish();
    world.expect_agreement(world.scene(nullptr, nullptr), "polished", 256);
    OcclusionTest painted = world.test(0);
    painted.mask = world.stripes(false, 1);
    world.expect_agreement(world.scene(&painted, nullptr), "polished, mask", 256);
  }
}

TEST(PhotoMask, FastAndPathAgreeWhereverTheSunIsSaidToBe) {
  for (const Lit lit : {Lit::sun_and_sky, Lit::photographed})
    for (const bool by_direction : {false, true}) {
      const MaskedWorld world(by_direction ? Seen::panorama : Seen::view, lit);
      const Mask matte = world.stripes(by_direction, -2);
      world.expect_agreement(world.scene(nullptr, &matte), "matte");
      OcclusionTest painted;
      painted.mask = world.stripes(!by_direction, 1);
      world.expect_agreement(world.scene(&painted, &matte), "mask and matte");
    }
}

TEST(PhotoMask, AMaskThatSaysWhatTheLocalSceneSaysChangesNothing) {
  // Depth of the mesh itself, finer than the picture: only samples beside an edge may differ.
  const MaskedWorld world(Seen::view, Lit::sun_and_sky);
  const OcclusionTest test = world.test(0);
  const PassOptions pass{.spp = 32, .threads = 2};
  const Image by_mesh = compose(world.fast(world.scene(nullptr, nullptr), {}, pass).sums).picture;
  const Image by_test = compose(world.fast(world.scene(&test, nullptr), {}, pass).sums).picture;
  int other = 0;
  for (std::size_t i = 0; i < by_mesh.values.size(); ++i)
    other += std::abs(by_mesh.values[i] - by_test.values[i]) > 1e-3F ? 1 : 0;
  EXPECT_GT(other, 0);
  EXPECT_LT(other, static_cast<int>(by_mesh.values.size()) / 50);
}

TEST(PhotoMask, NothingIsSeenOfAnObjectBehindAWhiteMaskAndAllBeforeABlackOne) {
  const MaskedWorld world(Seen::view, Lit::sun_and_sky);
  for (const float value : {0.0F, 1.0F}) {
    OcclusionTest test;
    test.mask = even_mask(16, value);
    const StimulusSums sums = world.fast(world.scene(&test, nullptr), {}, {.spp = 16, .threads = 2}).sums;
    const StimulusSums by_path =
        photo_by_path(world.scene(&test, nullptr), {}, 0, {.spp = 16, .threads = 2}).sums;
    double seen = 0, seen_by_path = 0, uncovered = 0, uncovered_by_path = 0;
    for (std::size_t half = 0; half < 2; ++half)
      for (std::size_t i = 0; i < sums.halves[half].size(); ++i) {
        seen += double{sums.halves[half][i].object.sum()};
        seen_by_path += double{by_path.halves[half][i].object.sum()};
        uncovered += double{sums.halves[half][i].uncovered_surfaces};
        uncovered_by_path += double{by_path.halves[half][i].uncovered_surfaces};
      }
    EXPECT_EQ(seen > 0, value == 0.0F);
    EXPECT_NEAR(seen, seen_by_path, 0.02 * seen_by_path);
    // The same samples were sorted by the same mask: only rays along edges of two search trees differ.
    EXPECT_NEAR(uncovered, uncovered_by_path, 1e-4 * uncovered_by_path);
  }
}

/// A ball that a mask puts before everything, and of which the local scene hides the left half: a box, as the
/// sheets of a coarse map seal things in.
class HalfBehind {
 public:
  explicit HalfBehind(Light light) : light_(std::move(light)) {
    const Meshes world = {test::box({-4, -2, -6}, {4, 3, 3}, 0.5F),
                          test::box({-2, -2, -5}, {0, 2, -2}, 0.5F)};
    // Sky and sun come in through the room's whole ceiling where the light is not the photograph.
    mesh_ = build_depth_mesh(capture_depth(Geometry(world), 512, 0, 2), {.threads = 2});
    if (light_.environment == nullptr) open_ceiling();
    depth_ = std::make_shared<const Geometry>(mesh_, Rgb::Constant(0.5F));
    if (light_.environment != nullptr) light_.photographed = depth_;
    before_all_.mask = even_mask(16, 0.0F);
  }
  /// Mean radiance of the ball where the local scene lies before it, and where it does not.
  [[nodiscard]] std::pair<float, float> on_ball(bool fast) const {
    const Geometry objects(ball_);
    const PhotoScene scene{photograph_, camera_, *depth_, objects, light_, {.test = &before_all_}};
    const PassOptions pass{.spp = 64, .threads = 2};
    const StimulusSums sums =
        fast ? photo_by_fast(scene, {surface_of_depth(mesh_, 0.5), ball_}, {}, 0, pass).sums
             : photo_by_path(scene, {}, 0, pass).sums;
    const Image picture = compose(sums).picture;
    std::array<float, 2> sum{}, pixels{};
    for (int y = 0; y < camera_.height_px; ++y)
      for (int x = 0; x < camera_.width_px; ++x) {
        const Ray ray = centre_ray(camera_, x, y);
        const auto ball = objects.nearest(ray), scene_there = depth_->nearest(ray);
        if (!ball || ray.direction.dot(-ball->normal) < 0.3F) continue;
        const std::size_t half = scene_there && scene_there->distance_m < ball->distance_m ? 0 : 1;
        sum[half] += picture.rgb(x, y).mean(), ++pixels[half];
      }
    EXPECT_GT(std::min(pixels[0], pixels[1]), 30);
    return {sum[0] / pixels[0], sum[1] / pixels[1]};
  }

 private:
  void open_ceiling() {
    std::erase_if(mesh_.triangles, [&](const Triangle& triangle) {
      return std::all_of(triangle.begin(), triangle.end(),
                         [&](auto i) { return mesh_.vertices_m[static_cast<std::size_t>(i)].y() > 2.9F; });
    });
  }

  Camera camera_{.width_px = 48, .height_px = 32};
  Image photograph_{48, 32, 3, 2.0F};
  Light light_;
  OcclusionTest before_all_;
  DepthMesh mesh_;
  std::shared_ptr<const Geometry> depth_;
  Meshes ball_ = {test::sphere({0, 0, -3.2F}, 0.7F, 64, 0.6F, 1)};
};

TEST(PhotoMask, AnObjectBeforeAMaskButBehindTheLocalSceneIsNotSealedIn) {
  Light light;
  light.bounces = 2;
  light.environment_radiance = Rgb::Constant(1.0F);
  light.suns = {{Eigen::Vector3f(0.1F, 1, 0.4F).normalized(), Rgb::Constant(2.0F), 0.02F}};
  const HalfBehind world(light);
  const auto [behind, before] = world.on_ball(false);
  const auto [behind_by_fast, before_by_fast] = world.on_ball(true);
  EXPECT_GT(behind, 0.5F * before);
  EXPECT_LT(behind, 2.0F * before);
  EXPECT_NEAR(behind_by_fast, behind, 0.02F * behind);
  EXPECT_NEAR(before_by_fast, before, 0.02F * before);
}

TEST(PhotoMask, InARoomOfOneRadianceItSendsItsAlbedoThereToo) {
  Light light;
  light.bounces = 2;
  light.environment = std::make_shared<EnvironmentMap>(Image(64, 32, 3, 2.0F), 0.0F);
  const HalfBehind world(light);
  for (const bool fast : {false, true}) {
    const auto [behind, before] = world.on_ball(fast);
    EXPECT_NEAR(behind, 2 * 0.6F, 0.02F) << fast;
    EXPECT_NEAR(before, 2 * 0.6F, 0.02F) << fast;
  }
}

TEST(PhotoMask, EqualPicturesForAnyNumberOfThreads) {
  const MaskedWorld world(Seen::view, Lit::photographed);
  OcclusionTest test;
  test.mask = world.stripes(false, 1);
  const Mask matte = world.stripes(true, -2);
  const PhotoScene scene = world.scene(&test, &matte);
  const Image one = compose(world.fast(scene, 0.01, {.threads = 1}).sums, Compositing::ratio, 1).picture;
  for (const int threads : {2, 3})
    EXPECT_EQ(compose(world.fast(scene, 0.01, {.threads = threads}).sums, Compositing::ratio, threads)
                  .picture.values,
              one.values)
        << threads;
}

TEST(PhotoMask, ObjectsBeforeEverythingAreLeftToPath) {
  const MaskedWorld world(Seen::view, Lit::sun_and_sky);
  PhotoScene scene = world.scene(nullptr, nullptr);
  EXPECT_TRUE(fast_can_render(scene));
  scene.occlusion.nothing_hides = true;
  EXPECT_FALSE(fast_can_render(scene));
}

}  // namespace
}  // namespace seamline::renderer
