#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "scenes/backgrounds.h"
#include "scenes/solids.h"

namespace seamline {
namespace {

using Vector3d = Eigen::Vector3d;
using std::numbers::pi;

constexpr int sides = 8;
constexpr double post_circle_m = 4.2;
constexpr double roof_circle_m = 5.2;
constexpr double deck_height_m = 0.45;
constexpr double eaves_m = 3.4;
const Vector3d centre_m(-1.6, 0, -14.0);

void add(SceneContents& garden, const std::string& name, const TriangleMesh& mesh, const Vector3d& shift = Vector3d::Zero()) {
  garden.parts.push_back({name, transformed(mesh, Eigen::Affine3d(Eigen::Translation3d(shift)))});
}

Vector3d on_ring(double radius_m, double index, double height_m) {
  const double angle = 2 * pi * (index + 0.5) / sides;
  return {radius_m * std::sin(angle), height_m, radius_m * std::cos(angle)};
}

TriangleMesh octagon(double radius_m, double bottom_m, double top_m) {
  const TriangleMesh mesh = turned({{radius_m, bottom_m}, {radius_m, top_m}}, sides, false);
  return transformed(mesh, Eigen::Affine3d(Eigen::AngleAxisd(pi / sides, Vector3d::UnitY())));
}

TriangleMesh make_railing() {
  TriangleMesh mesh;
  for (int side = 0; side < sides; ++side) {
    if (side == 7) continue;  // the way in, at the front
    const auto at = [side](double t, double height) -> Vector3d {
      return (1 - t) * on_ring(post_circle_m, side, height) + t * on_ring(post_circle_m, side + 1, height);
    };
    append(mesh, beam(at(0, deck_height_m + 1.0), at(1, deck_height_m + 1.0), 0.1, 0.08));
    append(mesh, beam(at(0, deck_height_m + 0.15), at(1, deck_height_m + 0.15), 0.08, 0.06));
    for (int bar = 1; bar < 14; ++bar)
      append(mesh, beam(at(bar / 14.0, deck_height_m + 0.15), at(bar / 14.0, deck_height_m + 1.0), 0.05, 0.05));
  }
  return mesh;
}

TriangleMesh make_roof() {
  TriangleMesh mesh;
  const TriangleMesh cone = turned({{roof_circle_m, eaves_m}, {roof_circle_m, eaves_m + 0.12}, {1.1, eaves_m + 1.7}, {1.1, eaves_m + 2.2},
                                    {1.4, eaves_m + 2.2}, {1.4, eaves_m + 2.28}, {0.12, eaves_m + 3.0}, {0.05, eaves_m + 3.5}},
                                   sides, false);
  append(mesh, transformed(cone, Eigen::Affine3d(Eigen::AngleAxisd(pi / sides, Vector3d::UnitY()))));
  return mesh;
}

}  // namespace

SceneContents make_gazebo() {
  SceneContents garden;
  add(garden, "ground", turned({{40, -0.2}, {40, 0}}, 96), {0, 0, -8});
  TriangleMesh steps = octagon(5.4, 0, 0.15);
  append(steps, octagon(5.0, 0.15, 0.3));
  append(steps, octagon(4.6, 0.3, deck_height_m));
  add(garden, "steps", steps, centre_m);
  TriangleMesh posts;
  for (int i = 0; i < sides; ++i) {
    const Vector3d foot = on_ring(post_circle_m, i, deck_height_m);
    append(posts, beam(foot, foot + Vector3d(0, eaves_m - deck_height_m, 0), 0.22, 0.22));
    append(posts, beam(foot, foot + Vector3d(0, 0.25, 0), 0.34, 0.34));
  }
  add(garden, "posts", posts, centre_m);
  add(garden, "railing", make_railing(), centre_m);
  add(garden, "roof", make_roof(), centre_m);
  garden.camera = SceneCamera{.position_m = {0, 2.6, 2.0}, .look_at_m = {0, 0.9, -7}, .vertical_fov_rad = 0.55};
  garden.sun = SceneSun{.to_sun = Vector3d(-0.55, 0.65, -0.45).normalized(), .irradiance_w_m2 = 3.0};
  return garden;
}

}  // namespace seamline
