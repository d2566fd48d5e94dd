#include <Eigen/Geometry>
#include <array>
#include <numbers>

#include "scenes/rooms/backgrounds.h"
#include "scenes/rooms/plans.h"
#include "scenes/shapes/solids.h"

namespace seamline::scenes {
namespace gazebo_parts {
namespace {

using Vector3d = Eigen::Vector3d;
using std::numbers::pi;

void add(SceneContents& garden, const std::string& name, const TriangleMesh& mesh) {
  garden.parts.push_back({name, mesh});
}

struct PavilionBuilder : PavilionPlan {
  /// The plan's corner number `i` (0 to 7, counter-clockwise from above, from the front's right end), shrunk
  /// by `inset_m`.
  Vector3d corner(int i, double inset_m, double height_m) const {
    const double x = half_width_m - inset_m;
    const double z = half_depth_m - inset_m;
    const double cut = cut_m - 0.4 * inset_m;
    const std::array<Vector3d, 8> corners = {Vector3d(x - cut, 0, z),  Vector3d(x, 0, z - cut),
                                             Vector3d(x, 0, cut - z),  Vector3d(x - cut, 0, -z),
                                             Vector3d(cut - x, 0, -z), Vector3d(-x, 0, cut - z),
                                             Vector3d(-x, 0, z - cut), Vector3d(cut - x, 0, z)};
    return corners[static_cast<std::size_t>(i % 8)] + Vector3d(0, height_m, 0);
  }

  /// A ring of wall between two outlines of the plan; the smaller `inset` is the outer one.
  void add_band(TriangleMesh& mesh, double inset_low_m, double low_m, double inset_high_m,
                double high_m) const {
    for (int i = 0; i < 8; ++i)
      append(mesh, polygon({corner(i, inset_low_m, low_m), corner(i + 1, inset_low_m, low_m),
                            corner(i + 1, inset_high_m, high_m), corner(i, inset_high_m, high_m)}));
  }

  void add_lid(TriangleMesh& mesh, double inset_m, double height_m) const {
    std::vector<Vector3d> corners;
    for (int i = 0; i < 8; ++i) corners.push_back(corner(i, inset_m, height_m));
    append(mesh, polygon(corners));
  }

  TriangleMesh make_steps() const {
    TriangleMesh mesh;
    for (int step = 0; step < 3; ++step) {
      add_band(mesh, 0.1 + 0.4 * step, 0.15 * step, 0.1 + 0.4 * step, 0.15 * (step + 1));
      add_lid(mesh, 0.1 + 0.4 * step, 0.15 * (step + 1));
    }
    return mesh;
  }

  /// Places for posts: the corners, and thirds of the long sides.
  std::vector<Vector3d> post_feet() const {
    std::vector<Vector3d> feet;
    for (int i = 0; i < 8; ++i) {
      feet.push_back(corner(i, 1.1, deck_height_m));
      if (i != 3 && i != 7) continue;
      for (const double t : {1.0 / 3, 2.0 / 3})
        feet.push_back((1 - t) * corner(i, 1.1, deck_height_m) + t * corner(i + 1, 1.1, deck_height_m));
    }
    return feet;
  }

  TriangleMesh make_posts() const {
    TriangleMesh mesh;
    const Vector3d up(0, eaves_m - deck_height_m, 0);
    for (const Vector3d& foot : post_feet()) {
      append(mesh, beam(foot, foot + up, 0.22, 0.22));
      append(mesh, beam(foot, foot + Vector3d(0, 0.25, 0), 0.34, 0.34));
      append(mesh, beam(foot + up - Vector3d(0, 0.2, 0), foot + up, 0.36, 0.36));
      for (const double side : {-1.0, 1.0})  // brackets
        append(mesh, beam(foot + up - Vector3d(0, 0.75, 0), foot + up + Vector3d(0.55 * side, -0.12, 0), 0.08,
                          0.1));
    }
    return mesh;
  }

  TriangleMesh make_railing() const {
    TriangleMesh mesh;
    const std::vector<Vector3d> feet = post_feet();
    for (std::size_t side = 0; side < feet.size(); ++side) {
      const Vector3d& a = feet[side];
      const Vector3d& b = feet[(side + 1) % feet.size()];
      if (side == 10) continue;  // the way in, in the middle of the front
      const auto at = [&](double t, double height) -> Vector3d {
        return (1 - t) * a + t * b + Vector3d(0, height, 0);
      };
      append(mesh, beam(at(0, 1.0), at(1, 1.0), 0.1, 0.08));
      append(mesh, beam(at(0, 0.15), at(1, 0.15), 0.08, 0.06));
      const int bars = static_cast<int>((b - a).norm() / 0.24);
      for (int bar = 1; bar < bars; ++bar) {
        const double t = static_cast<double>(bar) / bars;
        append(mesh, beam(at(t, 0.15), at(t, 1.0), 0.05, 0.05));
      }
    }
    return mesh;
  }

  TriangleMesh make_roof() const {
    TriangleMesh mesh;
    TriangleMesh soffit;
    add_lid(soffit, 0, 0);
    append(mesh, transformed(soffit,
                             Eigen::Translation3d(0, eaves_m, 0) * Eigen::AngleAxisd(pi, Vector3d::UnitZ())));
    add_band(mesh, 0, eaves_m, 0, eaves_m + 0.14);
    add_lid(mesh, 0, eaves_m + 0.14);
    return mesh;
  }

  /// An openwork crest along the front of the eaves, the sky behind it: pickets between a rail and a frieze.
  TriangleMesh make_crest() const {
    TriangleMesh mesh;
    const double low_m = eaves_m + 0.14;
    for (const int i : {6, 7, 0}) {
      const Vector3d a = corner(i, 0.15, low_m);
      const Vector3d b = corner(i + 1, 0.15, low_m);
      const auto at = [&](double t, double height) -> Vector3d {
        return (1 - t) * a + t * b + Vector3d(0, height, 0);
      };
      append(mesh, beam(at(0, crest_m), at(1, crest_m), 0.12, 0.42));
      append(mesh, beam(at(0, 0.06), at(1, 0.06), 0.14, 0.12));
      const int bars = static_cast<int>((b - a).norm() / picket_pitch_m);
      for (int bar = 0; bar < bars; ++bar) {
        const double t = (bar + 0.5) / bars;
        append(mesh, beam(at(t, 0), at(t, crest_m + 0.33), picket_m, 0.08));
      }
    }
    return mesh;
  }

  SceneContents garden() const {
    SceneContents garden;
    const Eigen::Affine3d lawn_centre(Eigen::Translation3d(0, 0, -8));
    add(garden, "ground", transformed(turned({{40, -0.2}, {40, 0}}, 96), lawn_centre));
    const TriangleMesh wall = turned_ring(
        {{23.3, 0}, {23.8, 0}, {23.8, 0.9}, {23.9, 0.9}, {23.9, 1.0}, {23.2, 1.0}, {23.2, 0.9}, {23.3, 0.9}},
        96);
    add(garden, "garden_wall", transformed(wall, lawn_centre));
    // The pavilion's parts are built around the origin.
    const auto add_placed = [&](const std::string& name, const TriangleMesh& mesh) {
      add(garden, name,
          transformed(mesh, Eigen::Translation3d(centre_m) * Eigen::AngleAxisd(yaw_rad, Vector3d::UnitY())));
    };
    add_placed("steps", make_steps());
    add_placed("posts", make_posts());
    add_placed("railing", make_railing());
    add_placed("roof", make_roof());
    add_placed("crest", make_crest());
    garden.camera = camera;
    garden.sun = sun;
    return garden;
  }
};

}  // namespace
}  // namespace gazebo_parts

SceneContents make_pavilion(const PavilionPlan& plan) {
  return gazebo_parts::PavilionBuilder{plan}.garden();
}

}  // namespace seamline::scenes
