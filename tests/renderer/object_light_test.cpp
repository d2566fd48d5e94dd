// Many points of the object asked together are lit as each of them alone.
#include "renderer/transport/object_light.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace seamline::renderer {
namespace {

using Parts = std::vector<std::shared_ptr<const SurfaceMesh>>;

Light sun_and_sky(int sky_rays) {
  return {.suns = {{.to_sun = Eigen::Vector3f(1, 2, 1).normalized(),
                    .irradiance_w_m2 = {8, 7, 6},
                    .angular_radius_rad = 0.1F}},
          .environment_radiance = {0.5F, 0.7F, 1.0F},
          .bounces = 0,
          .sky_rays = sky_rays};
}

TEST(DirectOnObject, IsThatOfEachPointAlone) {
  SurfaceMesh mirror = *test::sphere({1, 0, -4}, 0.8F, 24, 0.3F, 1);
  mirror.f0 = Rgb::Constant(0.7F);
  mirror.alpha = 0.1F;  // the sun is found by light samples and by paths
  const Geometry object(Parts{test::box({-1, -1, -4}, {0, 0.5F, -3}, 0.6F, 1),
                              std::make_shared<const SurfaceMesh>(std::move(mirror))});
  const Geometry real(
      Parts{test::box({-2, -1, -6}, {2, -0.9F, -1}, 0.5F), test::sphere({0.5F, 1.5F, -3}, 0.6F, 24, 0.5F)});
  // Seen from the centre; every third point asks the real world from the real surface in front of it.
  std::vector<SurfacePoint> points, starts;
  for (int i = 0; i < 400; ++i) {
    const Eigen::Vector3f direction = Eigen::Vector3f(-1.0F + 0.1F * static_cast<float>(i % 20),
                                                      -0.6F + 0.06F * static_cast<float>(i / 20), -2.5F)
                                          .normalized();
    if (const auto hit = object.nearest({{0, 0, 0}, direction})) {
      points.push_back(*hit);
      const auto before = real.nearest({{0, 0, 0}, direction});
      starts.push_back(i % 3 == 0 && before ? *before : *hit);
    }
  }
  ASSERT_GT(points.size(), 50U);
  for (const int sky_rays : {1, 2, 8}) {
    const Light light = sun_and_sky(sky_rays);
    std::vector<ObjectPoint> asked;
    for (std::size_t i = 0; i < points.size(); ++i)
      asked.push_back({&points[i], {&real, &starts[i]}, Sampler(5, static_cast<int>(i), 3, 2)});
    std::vector<Rgb> direct(points.size());
    LightRays rays;
    direct_on_object(asked, object, light, direct, rays);
    int dark = 0, lit = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Rgb alone = leaving_object({asked[i].lit_past, {nullptr, nullptr}, {nullptr, nullptr}}, object,
                                       points[i], light, asked[i].sampler)
                            .direct;
      ASSERT_LT((direct[i] - alone).abs().maxCoeff(), 1e-5F * (1 + alone.maxCoeff()))
          << i << " of " << sky_rays;
      (alone.isZero() ? dark : lit) += 1;
    }
    EXPECT_GT(dark, 0);
    EXPECT_GT(lit, 0);
  }
}

TEST(DirectOnObject, OfNothingIsNothing) {
  const Geometry object(Parts{test::sphere({1, 0, -4}, 0.8F, 24, 0.3F, 1)});
  LightRays rays;
  direct_on_object({}, object, sun_and_sky(2), {}, rays);
}

}  // namespace
}  // namespace seamline::renderer
