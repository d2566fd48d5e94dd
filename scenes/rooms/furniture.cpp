#include "scenes/rooms/furniture.h"

#include <cmath>
#include <numbers>

#include "scenes/shapes/solids.h"

namespace seamline::scenes {
namespace {

using Vector3d = Eigen::Vector3d;
using std::numbers::pi;

/// A cuboid by its footprint's centre, where it stands, and its size.
TriangleMesh piece(double x_m, double z_m, double bottom_m, const Vector3d& size_m) {
  const Vector3d half(size_m.x() / 2, 0, size_m.z() / 2);
  const Vector3d base(x_m, bottom_m, z_m);
  return box(base - half, base + half + Vector3d(0, size_m.y(), 0));
}

TriangleMesh moved(const TriangleMesh& mesh, const Vector3d& by_m) {
  return transformed(mesh, Eigen::Affine3d(Eigen::Translation3d(by_m)));
}

TriangleMesh turned_leg(double height_m, double radius_m) {
  const double r = radius_m, h = height_m;
  return turned(
      {{0.6 * r, 0}, {r, 0.15 * h}, {0.7 * r, 0.2 * h}, {r, 0.6 * h}, {0.7 * r, 0.8 * h}, {1.1 * r, h}}, 16);
}

/// Four legs at the corners of a rectangle.
void add_legs(TriangleMesh& mesh, double length_m, double depth_m, double height_m, double radius_m) {
  for (const double x : {-0.5, 0.5})
    for (const double z : {-0.5, 0.5})
      append(mesh, moved(turned_leg(height_m, radius_m), {x * length_m, 0, z * depth_m}));
}

/// A cuboid with a bulging top, for cushions.
TriangleMesh cushion(double x_m, double bottom_m, double z_m, const Vector3d& size_m) {
  std::vector<Eigen::Vector2d> outline = {{size_m.x() / 2, 0}};
  constexpr int steps = 12;
  for (int i = 0; i <= steps; ++i) {
    const double angle = pi * i / steps;
    outline.emplace_back(size_m.x() / 2 * std::cos(angle), size_m.y() * (0.7 + 0.3 * std::sin(angle)));
  }
  outline.emplace_back(-size_m.x() / 2, 0);
  return moved(extruded(outline, -size_m.z() / 2, size_m.z() / 2), {x_m, bottom_m, z_m});
}

TriangleMesh shade(double radius_m, double height_m) {
  const double r = radius_m, h = height_m;
  return turned_ring({{r, 0}, {0.65 * r, h}, {0.65 * r - 0.008, h}, {r - 0.008, 0}}, 32);
}

}  // namespace

TriangleMesh make_chair() {
  TriangleMesh mesh = piece(0, 0, 0.43, {0.44, 0.04, 0.42});
  add_legs(mesh, 0.38, 0.36, 0.43, 0.024);
  for (const double x : {-0.19, 0.19})
    append(mesh, beam({x, 0.47, -0.18}, {x * 1.05, 0.98, -0.26}, 0.035, 0.035));
  append(mesh, beam({-0.21, 0.95, -0.255}, {0.21, 0.95, -0.255}, 0.03, 0.09));
  for (int i = -2; i <= 2; ++i)
    append(mesh, beam({0.07 * i, 0.47, -0.185}, {0.072 * i, 0.92, -0.25}, 0.022, 0.012));
  return mesh;
}

TriangleMesh make_stool() {
  TriangleMesh mesh =
      moved(turned({{0.16, 0}, {0.17, 0.015}, {0.17, 0.035}, {0.15, 0.045}}, 32), {0, 0.45, 0});
  add_legs(mesh, 0.2, 0.2, 0.45, 0.02);
  return mesh;
}

TriangleMesh make_table(double length_m, double depth_m, double height_m) {
  TriangleMesh mesh = piece(0, 0, height_m - 0.04, {length_m, 0.04, depth_m});
  append(mesh, piece(0, 0, height_m - 0.12, {length_m - 0.16, 0.08, depth_m - 0.16}));
  add_legs(mesh, length_m - 0.14, depth_m - 0.14, height_m - 0.04, 0.035);
  return mesh;
}

TriangleMesh make_sofa(int seats) {
  const double width = 0.62 * seats + 0.36;
  TriangleMesh mesh = piece(0, 0, 0.1, {width, 0.2, 0.85});
  add_legs(mesh, width - 0.16, 0.7, 0.1, 0.03);
  append(mesh, piece(0, -0.35, 0.3, {width, 0.5, 0.16}));
  for (const double side : {-0.5, 0.5})
    append(mesh, moved(cushion(0, 0, 0, {0.17, 0.34, 0.85}), {side * (width - 0.18), 0.3, 0}));
  for (int i = 0; i < seats; ++i) {
    const double x = 0.62 * (i - (seats - 1) / 2.0);
    append(mesh, cushion(x, 0.3, 0.07, {0.6, 0.16, 0.66}));
    append(mesh, cushion(x, 0.46, -0.2, {0.58, 0.4, 0.13}));
  }
  return mesh;
}

TriangleMesh make_bookcase(double width_m, double height_m, int boards) {
  TriangleMesh mesh = piece(0, -0.14, 0, {width_m, height_m, 0.02});
  for (const double side : {-0.5, 0.5})
    append(mesh, piece(side * (width_m - 0.03), 0, 0, {0.03, height_m, 0.3}));
  for (int i = 0; i < boards; ++i)
    append(mesh, piece(0, 0, (height_m - 0.03) * i / (boards - 1), {width_m - 0.06, 0.03, 0.27}));
  return mesh;
}

TriangleMesh make_books(double length_m, Random& random) {
  TriangleMesh mesh;
  for (double x = -length_m / 2;;) {
    const double thickness = 0.02 + 0.03 * random.uniform(), height = 0.19 + 0.09 * random.uniform();
    const double depth = 0.14 + 0.07 * random.uniform(), gap = random.uniform() < 0.12 ? 0.07 : 0.002;
    if (x + thickness > length_m / 2) return mesh;
    TriangleMesh book = piece(0, 0, 0, {thickness, height, depth});
    if (gap > 0.01)  // leans against the one before
      book = transformed(book, Eigen::Affine3d(Eigen::AngleAxisd(0.12, Vector3d::UnitZ())));
    append(mesh, moved(book, {x + thickness / 2 + (gap > 0.01 ? 0.03 : 0.0), 0, 0.13 - depth / 2}));
    x += thickness + gap;
  }
}

TriangleMesh make_sideboard(double width_m, int doors) {
  TriangleMesh mesh = piece(0, 0, 0.12, {width_m, 0.6, 0.42});
  append(mesh, piece(0, 0, 0.72, {width_m + 0.04, 0.03, 0.46}));
  add_legs(mesh, width_m - 0.1, 0.34, 0.12, 0.025);
  const double step = width_m / doors;
  for (int i = 0; i < doors; ++i) {
    const double x = -width_m / 2 + (i + 0.5) * step;
    append(mesh, piece(x, 0.215, 0.15, {step - 0.03, 0.54, 0.02}));
    append(mesh, piece(x + step * 0.36, 0.235, 0.4, {0.015, 0.1, 0.025}));
  }
  return mesh;
}

TriangleMesh make_lamp(double height_m, double shade_radius_m) {
  const double r = shade_radius_m;
  TriangleMesh mesh = turned({{0.6 * r, 0}, {0.6 * r, 0.02}, {0.015, 0.05}, {0.012, height_m - 0.1}}, 24);
  append(mesh, moved(shade(r, 1.2 * r), {0, height_m - 1.2 * r, 0}));
  return mesh;
}

TriangleMesh make_hanging_lamp(double drop_m) {
  TriangleMesh mesh = turned({{0.006, -drop_m + 0.1}, {0.006, -0.02}, {0.05, -0.02}, {0.05, 0}}, 16);
  append(mesh, moved(shade(0.19, 0.16), {0, -drop_m, 0}));
  append(mesh,
         moved(turned({{0, 0}, {0.035, 0.02}, {0.04, 0.06}, {0.015, 0.1}}, 20), {0, -drop_m + 0.03, 0}));
  return mesh;
}

TriangleMesh make_vase(double height_m) {
  const double h = height_m;
  std::vector<ProfilePoint> profile;
  constexpr int steps = 24;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    profile.push_back({h * (0.12 + 0.13 * std::sin(pi * std::pow(t, 0.7)) + 0.05 * t * t), h * t});
  }
  return turned(profile, 32);
}

TriangleMesh make_plant(double height_m, Random& random) {
  TriangleMesh mesh =
      turned({{0.11, 0}, {0.16, 0.26}, {0.17, 0.26}, {0.17, 0.3}, {0.15, 0.3}, {0.14, 0.27}}, 28);
  for (int leaf = 0; leaf < 26; ++leaf) {
    const double azimuth = 2 * pi * random.uniform(), reach = height_m * (0.25 + 0.35 * random.uniform());
    const double rise = (height_m - 0.3) * (0.5 + 0.5 * random.uniform()),
                 width = 0.02 + 0.02 * random.uniform();
    constexpr int joints = 6;
    const auto at = [&](int joint) {
      const double t = static_cast<double>(joint) / joints;
      const double out = 0.04 + reach * t * t;
      return Vector3d(out * std::sin(azimuth), 0.27 + rise * std::sin(t * 0.62 * pi),
                      out * std::cos(azimuth));
    };
    for (int joint = 0; joint < joints; ++joint)
      append(mesh,
             beam(at(joint), at(joint + 1), width * (1.1 - static_cast<double>(joint) / joints), 0.004));
  }
  return mesh;
}

TriangleMesh make_picture(double width_m, double height_m) {
  TriangleMesh mesh = box({-width_m / 2, -height_m / 2, 0}, {width_m / 2, height_m / 2, 0.012});
  constexpr double bar = 0.04, out = 0.03;
  append(mesh, box({-width_m / 2 - bar, -height_m / 2 - bar, 0}, {width_m / 2 + bar, -height_m / 2, out}));
  append(mesh, box({-width_m / 2 - bar, height_m / 2, 0}, {width_m / 2 + bar, height_m / 2 + bar, out}));
  append(mesh, box({-width_m / 2 - bar, -height_m / 2, 0}, {-width_m / 2, height_m / 2, out}));
  append(mesh, box({width_m / 2, -height_m / 2, 0}, {width_m / 2 + bar, height_m / 2, out}));
  return mesh;
}

TriangleMesh make_dish(double radius_m, double height_m) {
  const double r = radius_m, h = height_m;
  return turned(
      {{0.5 * r, 0}, {0.8 * r, 0.35 * h}, {r, h}, {0.96 * r, h}, {0.7 * r, 0.45 * h}, {0.4 * r, 0.2 * h}},
      32);
}

TriangleMesh make_curtain(double width_m, double height_m) {
  constexpr int steps = 96;
  constexpr double folds = 9, depth_m = 0.05, thickness_m = 0.006;
  std::vector<Vector3d> path;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    path.emplace_back((t - 0.5) * width_m, 0, depth_m * std::sin(2 * pi * folds * t));
  }
  TriangleMesh mesh;
  const Vector3d up(0, height_m, 0), back(0, 0, -thickness_m);
  for (int i = 0; i < steps; ++i) {
    const Vector3d &a = path[static_cast<std::size_t>(i)], &b = path[static_cast<std::size_t>(i) + 1];
    append(mesh, polygon({a, b, b + up, a + up}));
    append(mesh, polygon({b + back, a + back, a + back + up, b + back + up}));
  }
  return mesh;
}

}  // namespace seamline::scenes
