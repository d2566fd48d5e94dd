#include "composites/measured_places.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace seamline::renderer {
namespace {

double rounded(double value, double steps) {
  return std::round(value * steps) / steps;
}

sensors::KnownPoint in_panorama(const Eigen::Vector3d& direction, const Photograph& photograph) {
  constexpr double pi = std::numbers::pi;
  return {
      .x_px = (std::atan2(direction.x(), -direction.z()) / (2 * pi) + 0.5) * photograph.width_px,
      .y_px = (0.5 - std::asin(std::clamp(direction.y(), -1.0, 1.0)) / pi) * photograph.height_px,
  };
}

}  // namespace

std::vector<sensors::KnownPoint> known_points(std::span<const MeasuredPlace> places, const SeenPhoto& seen,
                                              const PhotoDepthRequest& request) {
  const bool is_panorama = seen.photograph.projection == Projection::panorama;
  const bool is_fisheye = seen.lens && std::holds_alternative<sensors::FisheyeCamera>(seen.lens->camera);
  const sensors::DepthConvention usual =
      is_panorama || is_fisheye ? sensors::DepthConvention::radial : sensors::DepthConvention::planar;
  const bool planar = request.convention.value_or(usual) == sensors::DepthConvention::planar;
  std::vector<sensors::KnownPoint> points;
  for (const MeasuredPlace& place : places) {
    const Eigen::Vector3d direction = seen.camera
                                          .direction(static_cast<float>(place.across * seen.camera.width_px),
                                                     static_cast<float>(place.down * seen.camera.height_px))
                                          .cast<double>();
    sensors::KnownPoint point{.x_px = place.across * seen.photograph.width_px,
                              .y_px = place.down * seen.photograph.height_px};
    if (is_panorama) point = in_panorama(direction, seen.photograph);
    const double along = planar ? -direction.dot(seen.camera.axes.col(2).cast<double>()) : 1;
    points.push_back({.x_px = rounded(point.x_px, 10),
                      .y_px = rounded(point.y_px, 10),
                      .depth_m = rounded(place.distance_m * along, 1e4)});
  }
  return points;
}

std::string point_options(std::span<const sensors::KnownPoint> points) {
  std::string options;
  for (const sensors::KnownPoint& point : points)
    options += fmt::format(" --depth-point {},{},{}", point.x_px, point.y_px, point.depth_m);
  return options;
}

}  // namespace seamline::renderer
