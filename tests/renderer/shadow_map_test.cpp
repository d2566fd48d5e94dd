// Pictures of depth and shadow maps, against rays.
#include "renderer/realtime/shadow_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "raytracer/tracing/geometry.h"
#include "shapes.h"

namespace seamline::renderer {
namespace {

using Meshes = std::vector<std::shared_ptr<const SurfaceMesh>>;

std::vector<TriangleSpan> spans(const Meshes& meshes) {
  std::vector<TriangleSpan> out;
  for (const auto& mesh : meshes) out.push_back({mesh->positions_m, mesh->triangles});
  return out;
}

Meshes ball_on_floor() {
  return {test::sphere({0, -0.5F, -4}, 0.5F, 60, 0.5F), test::floor(-1, 4),
          test::box({-1.6F, -1, -4.4F}, {-1.2F, 0.4F, -4.1F}, 0.5F)};
}

/// Largest difference from rays through the pixels' centres, relative, and how many pixels only one has.
void expect_as_rays(const DrawView& view, int width_px, int height_px) {
  const Meshes meshes = ball_on_floor();
  const Geometry geometry(meshes);
  DepthPicture picture = empty_picture(width_px, height_px);
  draw_depth(view, spans(meshes), 2, picture);
  DepthPicture alone = empty_picture(width_px, height_px);
  draw_depth(view, spans(meshes), 1, alone);
  EXPECT_EQ(picture.depth_m, alone.depth_m) << "the same for any number of threads";
  int differ = 0;
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      const float u =
          view.corner[0] + (static_cast<float>(x) + 0.5F) / static_cast<float>(width_px) * view.size[0];
      const float v =
          view.corner[1] + (static_cast<float>(y) + 0.5F) / static_cast<float>(height_px) * view.size[1];
      const float before = view.from_point ? 0.0F : -20.0F;
      const Eigen::Vector3f origin =
          view.from_point ? view.eye_m
                          : Eigen::Vector3f(view.axes.transpose() * Eigen::Vector3f(u, v, before));
      const Eigen::Vector3f forward = view.axes.row(2).transpose();
      const Eigen::Vector3f direction =
          view.from_point ? Eigen::Vector3f((view.axes.transpose() * Eigen::Vector3f(u, v, 1)).normalized())
                          : forward;
      const auto hit = geometry.nearest({origin, direction});
      const float traced_m =
          hit ? before + hit->distance_m * direction.dot(forward) : std::numeric_limits<float>::infinity();
      const float drawn_m = picture.at(x, y);
      differ +=
          traced_m == drawn_m || std::abs(traced_m - drawn_m) < 2e-3F * (1 + std::abs(traced_m)) ? 0 : 1;
    }
  EXPECT_LE(differ, width_px * height_px / 1000) << "pixels whose centre an edge passes";
}

TEST(DepthPicture, ShowsWhatParallelRaysMeet) {
  DrawView view;
  view.axes = axes_along(Eigen::Vector3f(-0.4F, -0.9F, 0.3F).normalized());
  view.corner = {-3, -4};
  view.size = {5, 5};
  expect_as_rays(view, 200, 200);
}

TEST(DepthPicture, ShowsWhatRaysFromAPointMeetAlsoOfTrianglesThatReachBehindIt) {
  DrawView view;
  view.axes = axes_along(Eigen::Vector3f(0.1F, -0.3F, -1).normalized());
  view.from_point = true;
  view.eye_m = {0.2F, 0.3F, -1};
  view.corner = {-0.8F, -0.6F};
  view.size = {1.6F, 1.2F};
  expect_as_rays(view, 160, 120);
}

TEST(DepthPicture, HasNoHolesBetweenTriangles) {
  const Meshes wall = {test::sphere({0, 0, -3}, 20, 120, 0.5F)};
  DrawView view;
  view.from_point = true;
  view.axes = axes_along(-Eigen::Vector3f::UnitZ());
  DepthPicture picture = empty_picture(300, 300);
  draw_depth(view, spans(wall), 2, picture);
  for (const float depth_m : picture.depth_m) ASSERT_TRUE(std::isfinite(depth_m));
}

/// A floor under a sun, sampled where the ball's shadow falls.
struct FloorShadow {
  Meshes ball = {test::sphere({0, -0.5F, -4}, 0.5F, 96, 0.5F)};
  Sun sun{.to_sun = Eigen::Vector3f(0.5F, 0.8F, 0.25F).normalized(), .irradiance_w_m2 = Rgb::Ones()};

  /// Share of places that a map and rays disagree about.
  [[nodiscard]] double disagreement(const ShadowLookup& how, int width_px) const {
    const std::vector<Eigen::Vector3f> covered = {{-0.5F, -1, -4.5F}, {0.5F, 0, -3.5F},  {-0.5F, 0, -4.5F},
                                                  {0.5F, -1, -3.5F},  {-0.5F, 0, -3.5F}, {0.5F, 0, -4.5F}};
    const ShadowMap map = sun_shadow_map(sun, spans(ball), covered, width_px, 2);
    const Geometry geometry(ball);
    double sum = 0;
    constexpr int side = 400;
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) {
        const Eigen::Vector3f point(-1.6F + 2.4F * (static_cast<float>(i) + 0.5F) / side, -1,
                                    -5.0F + 2.0F * (static_cast<float>(j) + 0.5F) / side);
        const bool lit = !geometry.occluded({point, sun.to_sun});
        sum += std::abs((lit ? 1.0 : 0.0) -
                        static_cast<double>(arriving(map, how, point, Eigen::Vector3f::UnitY(), 0)));
      }
    return sum / (side * side);
  }
};

TEST(ShadowMap, ConvergesAtFirstOrderWithABiasOfTexels) {
  const FloorShadow scene;
  for (const ShadowFilter filter : {ShadowFilter::none, ShadowFilter::pcf}) {
    const ShadowLookup how{.filter = filter, .bias_texels = 1};
    const double coarse = scene.disagreement(how, 32), fine = scene.disagreement(how, 512);
    const double order = std::log2(coarse / fine) / 4;
    EXPECT_GT(order, 0.85) << word(filter) << " " << coarse << " " << fine;
    EXPECT_LT(order, 1.15) << word(filter) << " " << coarse << " " << fine;
    double before = coarse;
    for (const int width_px : {64, 128, 256}) {
      const double error = scene.disagreement(how, width_px);
      EXPECT_LT(error, 0.7 * before) << width_px;
      before = error;
    }
  }
}

TEST(ShadowMap, APlaneThatFacesItsLightAtAnyAngleDoesNotShadeItself) {
  const Meshes ground = {test::floor(-1, 4)};
  for (const float up : {2.0F, 0.7F, 0.3F}) {
    const Sun sun{.to_sun = Eigen::Vector3f(0.6F, up, 0.35F).normalized()};
    const std::vector<Eigen::Vector3f> covered = {{-1, -1, -5}, {1, -1, -3}, {-1, -1, -3}, {1, -1, -5}};
    const ShadowMap map = sun_shadow_map(sun, spans(ground), covered, 64, 2);
    for (const ShadowFilter filter : {ShadowFilter::none, ShadowFilter::pcf, ShadowFilter::pcss})
      for (float x = -1; x < 1; x += 0.013F)
        EXPECT_EQ(arriving(map, {.filter = filter}, {x, -1, -4 + 0.7F * x}, Eigen::Vector3f::UnitY(), 0.3F),
                  1)
            << up << " " << word(filter) << " " << x;
  }
}

TEST(ShadowMap, WithoutBiasAPlaneShadesItself) {
  const Meshes ground = {test::floor(-1, 4)};
  const Sun sun{.to_sun = Eigen::Vector3f(0.6F, 0.5F, 0.35F).normalized()};
  const std::vector<Eigen::Vector3f> covered = {{-1, -1, -5}, {1, -1, -3}, {-1, -1, -3}, {1, -1, -5}};
  const ShadowMap map = sun_shadow_map(sun, spans(ground), covered, 64, 2);
  int dark = 0;
  for (float x = -1; x < 1; x += 0.013F)
    dark += arriving(map, {.bias_texels = 0}, {x, -1, -4}, Eigen::Vector3f::UnitY(), 0) < 1 ? 1 : 0;
  EXPECT_GT(dark, 30) << "acne is what the bias is for";
}

TEST(ShadowMap, OfALampIsTracedShadowToo) {
  const Meshes ball = {test::sphere({0, -0.5F, -4}, 0.4F, 96, 0.5F)};
  const Lamp lamp{.position_m = {0.8F, 1.5F, -3.4F}, .intensity_w_sr = Rgb::Ones()};
  const std::vector<Eigen::Vector3f> covered = {
      {-0.4F, -0.9F, -4.4F}, {0.4F, -0.1F, -3.6F}, {-1.2F, -1, -5}, {0.4F, -1, -3.6F}};
  const ShadowMap map = lamp_shadow_map(lamp, spans(ball), covered, 512, 2);
  const Geometry geometry(ball);
  int differ = 0, dark = 0;
  for (int i = 0; i < 200; ++i)
    for (int j = 0; j < 200; ++j) {
      const Eigen::Vector3f point(-1.2F + 1.6F * static_cast<float>(i) / 200, -1,
                                  -5 + 1.4F * static_cast<float>(j) / 200);
      const Eigen::Vector3f way = lamp.position_m - point;
      const bool lit = !geometry.occluded({point, way.normalized(), way.norm()});
      dark += lit ? 0 : 1;
      differ += lit == (arriving(map, {}, point, Eigen::Vector3f::UnitY(), 0) > 0.5F) ? 0 : 1;
    }
  EXPECT_GT(dark, 3000);
  EXPECT_LT(differ, 400) << "of 40,000";
}

/// A sheet with an edge over a floor, a sun right above.
struct Penumbra {
  Meshes sheet = {
      test::part_of({{-6, 0, -8}, {0, 0, -8}, {0, 0, 0}, {-6, 0, 0}}, {{0, 2, 1}, {0, 3, 2}}, 0.5F, "sheet")};

  [[nodiscard]] ShadowMap map(float radius_rad, int width_px) const {
    const Sun sun{.to_sun = Eigen::Vector3f::UnitY(), .angular_radius_rad = radius_rad};
    const std::vector<Eigen::Vector3f> covered = {{-0.4F, -1, -4.4F}, {0.4F, -1, -3.6F}, {-0.4F, 0, -4.4F}};
    return sun_shadow_map(sun, spans(sheet), covered, width_px, 2);
  }
  /// From where a tenth of the sun arrives to where nine tenths do.
  template <class Light>
  [[nodiscard]] static double width_m(const Light& light) {
    double from = 0, to = 0;
    for (double x = -0.35; x < 0.35; x += 0.0005) {
      const double share = light(Eigen::Vector3f(static_cast<float>(x), -1, -4));
      if (share < 0.1) from = x;
      if (share < 0.9) to = x;
    }
    return to - from;
  }
};

TEST(SoftShadow, HasTheTracedPenumbrasWidthWithinATenth) {
  const Penumbra scene;
  const Geometry geometry(scene.sheet);
  for (const float radius_rad : {0.03F, 0.06F, 0.12F}) {
    const Sun sun{.to_sun = Eigen::Vector3f::UnitY(), .angular_radius_rad = radius_rad};
    const double traced = Penumbra::width_m([&](const Eigen::Vector3f& point) {
      int lit = 0;
      constexpr int side = 40;
      for (int i = 0; i < side * side; ++i) {
        const Eigen::Array2f on_disc((static_cast<float>(i % side) + 0.5F) / side,
                                     (static_cast<float>(i / side) + 0.5F) / side);
        lit += geometry.occluded({point, direction_to_sun(sun, on_disc)}) ? 0 : 1;
      }
      return lit / static_cast<double>(side * side);
    });
    const ShadowMap map = scene.map(radius_rad, 1024);
    const double mapped = Penumbra::width_m([&](const Eigen::Vector3f& point) {
      return static_cast<double>(
          arriving(map, {.filter = ShadowFilter::pcss, .taps = 512}, point, Eigen::Vector3f::UnitY(), 0));
    });
    EXPECT_GT(traced, 1.2 * static_cast<double>(radius_rad));
    EXPECT_NEAR(mapped, traced, 0.1 * traced) << radius_rad;
  }
}

TEST(SoftShadow, GoesToTheHardOneAsTheLightShrinks) {
  const Penumbra scene;
  const ShadowMap hard = scene.map(0, 512);
  double before = 1;
  for (const float radius_rad : {0.1F, 0.02F, 0.004F, 0.0F}) {
    const ShadowMap map = scene.map(radius_rad, 512);
    double difference = 0;
    int places = 0;
    for (float x = -0.3F; x < 0.3F; x += 0.0011F, ++places) {
      const Eigen::Vector3f point(x, -1, -4);
      difference += std::abs(static_cast<double>(arriving(map, {.filter = ShadowFilter::pcss}, point,
                                                          Eigen::Vector3f::UnitY(), 0)) -
                             static_cast<double>(arriving(hard, {}, point, Eigen::Vector3f::UnitY(), 0)));
    }
    difference /= places;
    EXPECT_LT(difference, before) << radius_rad;
    before = 0.5 * difference + 1e-9;
    if (radius_rad == 0.0F) {
      EXPECT_EQ(difference, 0);
    }
  }
}

}  // namespace
}  // namespace seamline::renderer
