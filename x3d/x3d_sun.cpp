#include <algorithm>
#include <cmath>
#include <numbers>

#include "x3d/x3d_page.h"

namespace seamline::renderer {
namespace {

constexpr int map_px = 1024;
constexpr float least_sky_share = 0.1F;  ///< of the sun: bounce light is not known

/// Irradiance of a surface under an unblocked environment: its mean radiance times pi.
Rgb open_sky_w_m2(const Light& light) {
  constexpr int directions = 512;
  Rgb sum = Rgb::Zero();
  for (int i = 0; i < directions; ++i) {  // Fibonacci's points: even over the sphere
    const float y = 1.0F - 2.0F * (static_cast<float>(i) + 0.5F) / directions;
    const float turn = static_cast<float>(i) * std::numbers::pi_v<float> * (3.0F - std::sqrt(5.0F));
    const float r = std::sqrt(1.0F - y * y);
    sum += light.sky({r * std::cos(turn), y, r * std::sin(turn)});
  }
  return sum / directions * std::numbers::pi_v<float>;
}

}  // namespace

const Sun* brightest_sun(const Light& light) {
  const auto brightest = std::max_element(
      light.suns.begin(), light.suns.end(),
      [](const Sun& a, const Sun& b) { return a.irradiance_w_m2.sum() < b.irradiance_w_m2.sum(); });
  return brightest != light.suns.end() && brightest->irradiance_w_m2.sum() > 0.0F ? &*brightest : nullptr;
}

Eigen::Vector3d sky_of(const X3dPage& page) {
  return page.sun != nullptr ? page.sun->sky_w_m2
                             : Eigen::Vector3d(open_sky_w_m2(page.subject.light).matrix().cast<double>());
}

std::optional<X3dSun> x3d_sun(const X3dSubject& subject, const X3dFrame& frame, int threads) {
  const Sun* brightest = brightest_sun(subject.light);
  if (brightest == nullptr) return std::nullopt;
  const Eigen::Matrix3f x3d_from_world = subject.camera.axes.transpose();
  Sun sun = *brightest;
  sun.to_sun = (x3d_from_world * sun.to_sun).normalized();
  sun.angular_radius_rad = 0;  // a hard edge: 3 x 3 texels soften it

  std::vector<Eigen::Vector3f> object_m;
  std::vector<Triangle> triangles;
  for (const auto& mesh : subject.objects) {
    const auto first = static_cast<std::uint32_t>(object_m.size());
    for (const Eigen::Vector3f& place_m : mesh->positions_m) object_m.push_back(x3d_from_world * place_m);
    for (const Triangle& corners : mesh->triangles)
      triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
  }
  const TriangleSpan object{object_m, triangles}, real{frame.blockers.vertices_m, frame.blockers.triangles};
  const Rgb sky = open_sky_w_m2(subject.light).max(least_sky_share * sun.irradiance_w_m2);
  return X3dSun{.to_sun = sun.to_sun.cast<double>(),
                .sun_w_m2 = sun.irradiance_w_m2.matrix().cast<double>(),
                .sky_w_m2 = sky.matrix().cast<double>(),
                .object = sun_shadow_map(sun, {&object, 1}, object_m, map_px, threads),
                .real = sun_shadow_map(sun, {&real, 1}, frame.blockers.vertices_m, map_px, threads)};
}

}  // namespace seamline::renderer
