// A white surface in even light is as bright as the light, however its smooth normals lean.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "raytracer/light/light_sample.h"
#include "raytracer/material/reflectance_table.h"

namespace seamline::renderer {
namespace {

/// A white metal whose smooth normal leans by `lean_deg` from that of its triangle, seen along the lean under
/// `view_deg`.
SurfacePoint leaning_metal(float alpha, double lean_deg, double view_deg) {
  const auto direction = [](double from_z_deg) {
    const double angle = from_z_deg * std::numbers::pi / 180;
    return Eigen::Vector3d(std::sin(angle), 0, std::cos(angle)).cast<float>().eval();
  };
  SurfacePoint point;
  point.position_m = Eigen::Vector3f::Zero();
  point.geometric_normal = Eigen::Vector3f::UnitZ();
  point.normal = direction(lean_deg);
  point.to_viewer = direction(view_deg);
  point.albedo = Rgb::Zero();
  point.f0 = Rgb::Ones();
  point.alpha = alpha;
  return point;
}

TEST(WhiteFurnace, LightOfEveryDirectionAboveATriangleAddsUpToOne) {
  for (const auto& [lean_deg, view_deg] :
       {std::pair{0.0, 50.0}, {30.0, -40.0}, {-35.0, 45.0}, {40.0, -45.0}}) {
    const SurfacePoint point = leaning_metal(0.2F, lean_deg, view_deg);
    double share = 0, density = 0;
    constexpr int rings = 400, turns = 800;
    for (int r = 0; r < rings; ++r)
      for (int t = 0; t < turns; ++t) {
        const double z = (r + 0.5) / rings, angle = 2 * std::numbers::pi * (t + 0.5) / turns;
        const double sine = std::sqrt(1 - z * z);
        const Eigen::Vector3f direction =
            Eigen::Vector3d(sine * std::cos(angle), sine * std::sin(angle), z).cast<float>();
        const double solid_angle_sr = 2 * std::numbers::pi / (rings * turns);
        share += solid_angle_sr * double{scattered_share_above(point, direction)[0]};
        density += solid_angle_sr * double{scatter_density_sr(Light{}, point, direction)};
      }
    EXPECT_NEAR(share, 1, 0.01) << lean_deg << " " << view_deg;
    EXPECT_LE(density, 1.001);
  }
}

TEST(WhiteFurnace, NoSampleOfAMirrorIsLostBelowItsTriangle) {
  for (const double view_deg : {-60.0, -40.0, 0.0, 40.0})
    for (const double lean_deg : {-25.0, 10.0, 29.0}) {
      const SurfacePoint point = leaning_metal(least_alpha, lean_deg, view_deg);
      const auto next = scatter(Light{}, point, {0.3F, 0.7F});
      ASSERT_TRUE(next) << view_deg << " " << lean_deg;
      EXPECT_GT(next->direction.z(), 0);
      EXPECT_NEAR(next->weight[0], 1, 1e-3);
    }
}

}  // namespace
}  // namespace seamline::renderer
