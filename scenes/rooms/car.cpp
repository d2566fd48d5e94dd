#include "scenes/rooms/car.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "scenes/shapes/hull.h"
#include "scenes/shapes/solids.h"

namespace seamline::scenes {
namespace car_parts {
namespace {

using Vector3d = Eigen::Vector3d;
using std::numbers::pi;

constexpr double wheel_radius_m = 0.29, arch_radius_m = 0.36, axle_m = 1.1, track_m = 0.64;

/// Body below the windows. Its lower edge rises over the wheels.
TriangleMesh lower_body() {
  std::vector<HullSection> sections = smooth_sections({{-1.78, 0.46, 0.36, 0.56},
                                                       {-1.70, 0.60, 0.29, 0.70},
                                                       {-1.45, 0.70, 0.24, 0.82},
                                                       {-1.00, 0.745, 0.21, 0.90},
                                                       {-0.40, 0.765, 0.20, 0.93},
                                                       {0.20, 0.765, 0.20, 0.93},
                                                       {0.75, 0.745, 0.20, 0.90},
                                                       {1.20, 0.71, 0.22, 0.83},
                                                       {1.55, 0.62, 0.26, 0.71},
                                                       {1.72, 0.50, 0.31, 0.60},
                                                       {1.79, 0.38, 0.37, 0.52}},
                                                      14);
  for (HullSection& section : sections)
    for (const double axle : {-axle_m, axle_m}) {
      const double away_m = section.x_m - axle;
      if (std::abs(away_m) < arch_radius_m)
        section.low_m = std::max(section.low_m,
                                 wheel_radius_m + std::sqrt(arch_radius_m * arch_radius_m - away_m * away_m));
    }
  return hull(sections);
}

/// Glass of the cabin: windscreen, rear window, and two windows a side between posts.
bool is_glass(double x_m, double around_rad) {
  constexpr double roof_rad = 26 * pi / 180, post_rad = 6 * pi / 180;
  if (around_rad < -post_rad) return false;
  if (around_rad > roof_rad + post_rad) return x_m > 0.27 || x_m < -0.98;
  if (around_rad > roof_rad) return false;
  const bool post = std::abs(x_m + 0.30) < 0.035 || x_m > 0.52 || x_m < -0.98;
  return !post;
}

/// Glass, and paint.
std::pair<TriangleMesh, TriangleMesh> cabin() {
  return parted_hull(smooth_sections({{-1.28, 0.50, 0.72, 0.86},
                                      {-1.05, 0.56, 0.72, 1.10},
                                      {-0.70, 0.585, 0.72, 1.31},
                                      {-0.25, 0.59, 0.72, 1.38},
                                      {0.15, 0.58, 0.72, 1.36},
                                      {0.48, 0.57, 0.72, 1.21},
                                      {0.88, 0.55, 0.72, 0.88}},
                                     20),
                     is_glass);
}

/// A solid of revolution about y, laid down so that its axis is z and its top looks outwards.
TriangleMesh on_axle(const TriangleMesh& turned_mesh, const Vector3d& at_m, double side) {
  return transformed(turned_mesh,
                     Eigen::Translation3d(at_m) * Eigen::AngleAxisd(side * pi / 2, Vector3d::UnitX()));
}

template <class Add>
void at_each_wheel(const Add& add) {
  for (const double x_m : {-axle_m, axle_m})
    for (const double side : {-1.0, 1.0}) add(Vector3d(x_m, wheel_radius_m, side * (track_m - 0.07)), side);
}

TriangleMesh tyres() {
  constexpr double r = wheel_radius_m;
  TriangleMesh mesh;
  at_each_wheel([&](const Vector3d& at_m, double side) {
    append(mesh, on_axle(turned({{0.16, 0},
                                 {r - 0.03, 0},
                                 {r, 0.03},
                                 {r, 0.12},
                                 {r - 0.03, 0.15},
                                 {0.17, 0.155},
                                 {0.16, 0.135}},
                                40),
                         at_m, side));
  });
  return mesh;
}

TriangleMesh chrome() {
  TriangleMesh mesh;
  at_each_wheel([&](const Vector3d& at_m, double side) {
    append(mesh, on_axle(turned({{0.16, 0.13}, {0.13, 0.145}, {0.09, 0.15}, {0.06, 0.17}, {0.02, 0.18}}, 32),
                         at_m, side));
  });
  for (const double end : {-1.0, 1.0}) {
    constexpr double y_m = 0.40;
    append(mesh, beam({end * 1.83, y_m, -0.5}, {end * 1.83, y_m, 0.5}, 0.04, 0.09));
    for (const double side : {-1.0, 1.0})
      append(mesh, beam({end * 1.83, y_m, side * 0.5}, {end * 1.62, y_m, side * 0.68}, 0.04, 0.09));
  }
  for (const double side : {-1.0, 1.0}) {
    append(mesh, beam({-0.12, 0.80, side * 0.762}, {0.02, 0.80, side * 0.766}, 0.02, 0.02));
    append(mesh, beam({-1.3, 0.70, side * 0.73}, {1.25, 0.66, side * 0.71}, 0.012, 0.012));
  }
  return mesh;
}

/// Round headlights, turned towards +X.
TriangleMesh headlights() {
  TriangleMesh mesh;
  const TriangleMesh glass =
      turned({{0.10, -0.06}, {0.105, 0.0}, {0.095, 0.02}, {0.06, 0.04}, {0.02, 0.047}}, 32);
  for (const double side : {-1.0, 1.0})
    append(mesh, transformed(glass, Eigen::Translation3d(Vector3d(1.63, 0.61, side * 0.43)) *
                                        Eigen::AngleAxisd(-pi / 2, Vector3d::UnitZ())));
  return mesh;
}

}  // namespace
}  // namespace car_parts

std::vector<ScenePart> make_car() {
  using namespace car_parts;
  const auto [glass, painted] = cabin();
  TriangleMesh paint = lower_body();
  append(paint, painted);
  std::vector<ScenePart> parts;
  parts.push_back({"car_paint", paint, {0.42, 0.035, 0.03}, {.roughness = 0.22}});
  parts.push_back({"car_glass", glass, {0.02, 0.025, 0.03}, {.roughness = 0.08}});
  parts.push_back({"car_tyres", tyres(), {0.03, 0.03, 0.03}, {.roughness = 0.8}});
  parts.push_back({"car_chrome", chrome(), {0.75, 0.75, 0.74}, {.roughness = 0.15, .metallic = 1}});
  parts.push_back({"car_lights", headlights(), {0.8, 0.8, 0.75}, {.roughness = 0.1}});
  parts.push_back({"car_inside", box({-1.5, 0.24, -0.35}, {1.4, 0.36, 0.35}), {0.03, 0.03, 0.03}});
  return parts;
}

}  // namespace seamline::scenes
