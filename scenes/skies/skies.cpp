#include "scenes/skies/skies.h"

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace seamline::scenes {
namespace {

using Eigen::Vector3d;
using Colour = Eigen::Array3d;

constexpr int width_px = 512, height_px = width_px / 2;

Colour clear_sky(const Vector3d& direction) {
  const Vector3d to_sun = Vector3d(0.5, std::numbers::sqrt2 / 2, -0.5).normalized();
  constexpr double sun_radius_rad = 2.5 * std::numbers::pi / 180;
  const double from_sun_rad = std::acos(std::clamp(direction.dot(to_sun), -1.0, 1.0));
  if (from_sun_rad < sun_radius_rad) return Colour(560, 520, 460);
  if (direction.y() < 0) return Colour(0.16, 0.13, 0.10);
  const double paler = std::exp(-3.0 * direction.y());
  const Colour sky = (1 - paler) * Colour(0.16, 0.30, 0.68) + paler * Colour(0.72, 0.78, 0.85);
  const double glow = 1.2 * std::exp(-from_sun_rad / 0.18);
  return sky + glow * Colour(1.0, 0.92, 0.75);
}

/// How far it is to a wall between `least` and `most` along one axis, from the origin inside.
double wall_at(double direction, double least, double most) {
  if (direction == 0) return 1e30;
  return (direction > 0 ? most : least) / direction;
}

bool within(double value, double centre, double half) {
  return std::abs(value - centre) < half;
}

Colour window_room(const Vector3d& direction) {
  const Vector3d least(-3, -1.4, -2.5), most(3, 1.6, 2.5);
  const Vector3d to(wall_at(direction.x(), least.x(), most.x()), wall_at(direction.y(), least.y(), most.y()),
                    wall_at(direction.z(), least.z(), most.z()));
  int axis = 0;
  const double distance = to.minCoeff(&axis);
  const Vector3d place = distance * direction;
  if (axis == 1 && direction.y() > 0)
    return within(place.x(), 0.8, 0.3) && within(place.z(), 0, 0.3) ? Colour(30, 26, 20)
                                                                    : Colour(0.36, 0.35, 0.33);
  if (axis == 1) return {0.15, 0.11, 0.08};
  if (axis == 0 && direction.x() < 0 && within(place.y(), 0.3, 0.7) &&
      (within(place.z(), -1.1, 0.6) || within(place.z(), 1.1, 0.6)))
    return {5.0, 6.0, 7.5};
  return axis == 0 ? Colour(0.30, 0.28, 0.24) : Colour(0.22, 0.24, 0.22);
}

}  // namespace

Image builtin_sky(std::string_view name) {
  if (name != "clear_sky" && name != "window_room") throw std::logic_error("no such sky");
  constexpr int places = 4;  // a side of a texel
  Image sky(width_px, height_px, 3);
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      Colour sum = Colour::Zero();
      for (int i = 0; i < places * places; ++i) {
        const double column = x + (i % places + 0.5) / places;
        const double row = y + (i / places + 0.5) / places;  // NOLINT(bugprone-integer-division)
        const double azimuth = (column / width_px - 0.5) * 2 * std::numbers::pi;
        const double elevation = (0.5 - row / height_px) * std::numbers::pi;
        const Vector3d direction(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                                 -std::cos(azimuth) * std::cos(elevation));
        sum += name == "clear_sky" ? clear_sky(direction) : window_room(direction);
      }
      sky.set_rgb(x, y, (sum / (places * places)).cast<float>());
    }
  return sky;
}

}  // namespace seamline::scenes
