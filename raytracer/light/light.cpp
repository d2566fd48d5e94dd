#include "raytracer/light/light.h"

#include <cmath>
#include <numbers>

namespace seamline::renderer {
namespace {

constexpr float two_pi = 2.0F * std::numbers::pi_v<float>;

}  // namespace

Eigen::Vector3f direction_to_sun(const Sun& sun, const Eigen::Array2f& point) {
  if (sun.angular_radius_rad <= 0.0F) return sun.to_sun;
  const float one_minus_cos = point[0] * 2.0F * std::pow(std::sin(0.5F * sun.angular_radius_rad), 2.0F);
  const float sine = std::sqrt(one_minus_cos * (2.0F - one_minus_cos));
  const float angle = two_pi * point[1];
  return local_axes(sun.to_sun) *
         Eigen::Vector3f(sine * std::cos(angle), sine * std::sin(angle), 1.0F - one_minus_cos);
}

float disc_density_sr(const Sun& sun) {
  const float sine = std::sin(0.5F * sun.angular_radius_rad);
  return 1.0F / (2.0F * two_pi * sine * sine);
}

Rgb disc_radiance(const Sun& sun, const Eigen::Vector3f& direction) {
  if (!(sun.angular_radius_rad > 0.0F)) return Rgb::Zero();
  // By the chord, because a cosine so near to 1 says nothing of a small disc.
  const float chord = 2.0F * std::sin(0.5F * sun.angular_radius_rad);
  if ((direction - sun.to_sun).squaredNorm() > chord * chord) return Rgb::Zero();
  return disc_density_sr(sun) * sun.irradiance_w_m2;
}

Eigen::Vector3f turned_direction(const Eigen::Vector3f& normal, const Eigen::Array2f& point, int number,
                                 int count) {
  const float turned = point[1] + static_cast<float>(number) / static_cast<float>(count);
  return cosine_weighted(normal, {point[0], turned < 1.0F ? turned : turned - 1.0F});
}

}  // namespace seamline::renderer
