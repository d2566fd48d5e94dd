// Many points off the object asked together are lit as each of them alone.
#include "renderer/transport/uncovered_light.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace seamline::renderer {
namespace {

using Parts = std::vector<std::shared_ptr<const SurfaceMesh>>;

TEST(DirectOnUncovered, IsThatOfEachPointAlone) {
  const Geometry object(Parts{test::sphere({0, -0.2F, -4}, 0.8F, 24, 0.3F, 1)});
  const Geometry truth(Parts{test::floor(-1.0F, 6.0F)});
  // What answers whether the floor is lit lies elsewhere than the floor, and casts shadows of its own.
  const Geometry other(Parts{test::floor(-1.1F, 6.0F), test::box({-2, 0, -5}, {-1, 1, -4}, 0.5F)});
  std::vector<SurfacePoint> receivers, starts;
  for (int i = 0; i < 400; ++i) {
    const Ray ray{{0, 0, 0},
                  Eigen::Vector3f(-1.0F + 0.1F * static_cast<float>(i % 20),
                                  -0.2F - 0.04F * static_cast<float>(i / 20), -1.0F)
                      .normalized()};
    const auto receiver = truth.nearest(ray), start = other.nearest(ray);
    if (!receiver || !start) continue;
    receivers.push_back(*receiver);
    starts.push_back(*start);
  }
  ASSERT_GT(receivers.size(), 200U);
  const Light light{.suns = {{.to_sun = Eigen::Vector3f(-1, 2, 0.5F).normalized(),
                              .irradiance_w_m2 = {8, 7, 6},
                              .angular_radius_rad = 0.1F}},
                    .environment_radiance = {0.5F, 0.7F, 1.0F}};
  SurfacePoint shaded_as;
  shaded_as.albedo = {0.2F, 0.4F, 0.6F};
  std::vector<UncoveredPoint> asked;
  for (std::size_t i = 0; i < receivers.size(); ++i)
    asked.push_back({&receivers[i], {&other, &starts[i]}, &shaded_as, Sampler(5, static_cast<int>(i), 3, 2)});
  std::vector<RadiancePair> together(asked.size());
  LightRays rays;
  direct_on_uncovered(asked, object, light, together, rays);
  int without_sun = 0, in_objects_shadow = 0, sky_behind_object = 0;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const Sampler& sampler = asked[i].sampler;
    const auto arrives = [&](const Eigen::Vector3f& direction, bool with_object) {
      return above_horizon(starts[i], direction) &&
             !other.occluded({ray_start(starts[i], direction), direction}) &&
             !(with_object && object.occluded({ray_start(receivers[i], direction), direction}));
    };
    const Eigen::Vector3f to_sun = direction_to_sun(light.suns[0], sampler.point(dimension::sun(0)));
    const Eigen::Vector3f to_sky =
        cosine_weighted(receivers[i].normal, sampler.point(dimension::direction(0)));
    for (const bool with_object : {false, true}) {
      const Split& found = with_object ? together[i].with_object : together[i].without_object;
      const float cosine = receivers[i].normal.dot(to_sun);
      const float sun = arrives(to_sun, with_object) ? 0.2F * 8.0F * cosine / 3.14159265F : 0.0F;
      ASSERT_NEAR(found.direct[0], sun, 1e-5F) << i;
      ASSERT_NEAR(found.bounce[2], arrives(to_sky, with_object) ? 0.6F : 0.0F, 1e-6F) << i;
    }
    without_sun += together[i].without_object.direct.isZero() ? 1 : 0;
    in_objects_shadow += (together[i].without_object.direct != together[i].with_object.direct).any() ? 1 : 0;
    sky_behind_object += (together[i].without_object.bounce != together[i].with_object.bounce).any() ? 1 : 0;
  }
  EXPECT_GT(without_sun, 0);
  EXPECT_GT(in_objects_shadow, 0);
  EXPECT_GT(sky_behind_object, 0);
}

}  // namespace
}  // namespace seamline::renderer
