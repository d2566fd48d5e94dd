#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "scenes/rooms/backgrounds.h"
#include "scenes/rooms/plans.h"
#include "scenes/shapes/solids.h"

namespace seamline::scenes {
namespace atrium_parts {
namespace {

using Vector3d = Eigen::Vector3d;
using std::numbers::pi;

constexpr int bays = 8;
constexpr double openwork_from_m = 0.3;  ///< the column's axis to the end of the rail

void add(SceneContents& court, const std::string& name, const TriangleMesh& mesh,
         const Vector3d& shift = Vector3d::Zero()) {
  court.parts.push_back({name, transformed(mesh, Eigen::Affine3d(Eigen::Translation3d(shift)))});
}

TriangleMesh make_column(double height_m, double radius_m) {
  const double r = radius_m;
  const double h = height_m;
  TriangleMesh mesh = box({-1.5 * r, 0, -1.5 * r}, {1.5 * r, 0.12, 1.5 * r});
  append(mesh, turned({{1.42 * r, 0.12},
                       {1.42 * r, 0.2},
                       {1.2 * r, 0.24},
                       {1.3 * r, 0.3},
                       {1.05 * r, 0.36},
                       {r, 0.42},
                       {0.88 * r, h - 0.42},
                       {1.02 * r, h - 0.4},
                       {1.02 * r, h - 0.36},
                       {0.9 * r, h - 0.33},
                       {1.0 * r, h - 0.22},
                       {1.45 * r, h - 0.1}},
                      32));
  append(mesh, box({-1.6 * r, h - 0.1, -1.6 * r}, {1.6 * r, h, 1.6 * r}));
  return mesh;
}

struct ArcadeBuilder : ArcadePlan {
  /// The wall over one bay: from the springing of the arch up to `top_m`, cut out by a half circle. In x
  /// 0..bay, z about 0.
  TriangleMesh make_arch(double springing_m, double top_m) const {
    constexpr int steps = 24;
    const double pier = 0.36;
    const double radius = bay_m / 2 - pier;
    TriangleMesh mesh;
    const auto slab = [&](const std::vector<Eigen::Vector2d>& outline) {
      append(mesh, extruded(outline, -thickness_m / 2, thickness_m / 2));
    };
    slab({{0, springing_m}, {pier, springing_m}, {pier, top_m}, {0, top_m}});
    slab({{bay_m - pier, springing_m}, {bay_m, springing_m}, {bay_m, top_m}, {bay_m - pier, top_m}});
    for (int i = 0; i < steps; ++i) {
      const auto on_arch = [&](int step) -> Eigen::Vector2d {
        const double angle = pi * (1 - static_cast<double>(step) / steps);
        return {bay_m / 2 + radius * std::cos(angle), springing_m + radius * std::sin(angle)};
      };
      const Eigen::Vector2d a = on_arch(i);
      const Eigen::Vector2d b = on_arch(i + 1);
      slab({a, b, {b.x(), top_m}, {a.x(), top_m}});
    }
    return mesh;
  }

  /// Mouldings on the arcade's face over one bay: a raised band along the arch, a keystone, and a roundel in
  /// the spandrel over the column.
  TriangleMesh make_ornament(double springing_m) const {
    constexpr int steps = 24;
    const double radius = bay_m / 2 - 0.36;
    const double face = thickness_m / 2;
    TriangleMesh mesh;
    const auto band = [&](double inner, double outer, double depth) {
      for (int i = 0; i < steps; ++i) {
        const auto at = [&](double r, int step) -> Eigen::Vector2d {
          const double angle = pi * (1 - static_cast<double>(step) / steps);
          return {bay_m / 2 + r * std::cos(angle), springing_m + r * std::sin(angle)};
        };
        append(mesh, extruded({at(inner, i), at(inner, i + 1), at(outer, i + 1), at(outer, i)}, face,
                              face + depth));
      }
    };
    band(radius, radius + 0.12, 0.06);
    band(radius + 0.12, radius + 0.17, 0.10);
    const double crown = springing_m + radius;
    append(mesh, extruded({{bay_m / 2 - 0.09, crown - 0.06},
                           {bay_m / 2 + 0.09, crown - 0.06},
                           {bay_m / 2 + 0.15, crown + 0.3},
                           {bay_m / 2 - 0.15, crown + 0.3}},
                          face, face + 0.16));
    TriangleMesh roundel =
        turned({{0.30, 0}, {0.30, 0.07}, {0.24, 0.07}, {0.22, 0.02}, {0.10, 0.05}, {0.04, 0.09}}, 32);
    const Eigen::Affine3d upright(Eigen::Translation3d(0, crown - 0.12, face) *
                                  Eigen::AngleAxisd(pi / 2, Vector3d::UnitX()));
    append(mesh, transformed(roundel, upright));
    return mesh;
  }

  /// Along one bay of the aisle's wall: a flat pilaster and a blind panel.
  TriangleMesh make_wall_bay() const {
    TriangleMesh mesh = box({-0.25, 0, 0}, {0.25, storey_m - 0.2, 0.12});
    append(mesh, box({-0.32, storey_m - 0.75, 0}, {0.32, storey_m - 0.55, 0.2}));
    append(mesh, box({0.7, 1.2, 0}, {bay_m - 0.7, 1.3, 0.08}));
    append(mesh, box({0.7, 3.0, 0}, {bay_m - 0.7, 3.1, 0.08}));
    append(mesh, box({0.7, 1.3, 0}, {0.8, 3.0, 0.08}));
    append(mesh, box({bay_m - 0.8, 1.3, 0}, {bay_m - 0.7, 3.0, 0.08}));
    return mesh;
  }

  TriangleMesh make_balustrade() const {
    TriangleMesh mesh = box({0, 0, -0.14}, {bay_m, 0.1, 0.14});
    append(mesh, box({0, 0.8, -0.16}, {bay_m, 0.92, 0.16}));
    for (int i = 0; i < 9; ++i) {
      const TriangleMesh baluster = turned(
          {{0.06, 0.1}, {0.06, 0.16}, {0.035, 0.2}, {0.085, 0.36}, {0.035, 0.62}, {0.06, 0.7}, {0.06, 0.8}},
          12);
      append(mesh, transformed(baluster, Eigen::Affine3d(Eigen::Translation3d((i + 0.5) * bay_m / 9, 0, 0))));
    }
    return mesh;
  }

  /// A turned baluster of beads and a vase, 1.4 m tall, its foot at the origin.
  TriangleMesh make_slender_baluster(int baluster_beads) const {
    std::vector<ProfilePoint> profile = {{0.085, 0}, {0.085, 0.06}, {0.045, 0.09}};
    const double step = 1.22 / baluster_beads;
    for (int i = 0; i < baluster_beads; ++i) {
      const double low = 0.09 + i * step;
      for (int k = 1; k <= 8; ++k) {
        const double t = k / 8.0;
        profile.push_back({0.032 + 0.055 * std::sin(pi * t) * std::sin(pi * t), low + t * step});
      }
    }
    profile.push_back({0.045, 1.31});
    profile.push_back({0.085, 1.34});
    profile.push_back({0.085, 1.4});
    return turned(profile, 20);
  }

  /// Where a baluster stands in its bay.
  double baluster_x_m(int number) const {
    return openwork_from_m + (number + 0.5) * (bay_m - 2 * openwork_from_m) / balusters;
  }

  /// An openwork screen between two columns, before things that stand in the aisle: a sill, balusters, a
  /// rail.
  TriangleMesh make_openwork(int baluster_beads) const {
    TriangleMesh mesh = box({0.36, 0, -0.16}, {bay_m - 0.36, 0.5, 0.16});
    append(mesh, box({0.3, 0.42, -0.2}, {bay_m - 0.3, 0.5, 0.2}));
    append(mesh, box({0.3, rail_m - 0.05, -0.13}, {bay_m - 0.3, rail_m + 0.05, 0.13}));
    for (int i = 0; i < balusters; ++i)
      append(mesh, transformed(make_slender_baluster(baluster_beads),
                               Eigen::Affine3d(Eigen::Translation3d(
                                   0.3 + (i + 0.5) * (bay_m - 0.6) / balusters, 0.5, 0))));
    return mesh;
  }

  /// Backing behind a column or baluster (paper section 4.1.1): an upright sheet from its axis to the aisle's
  /// wall along the line of sight, so that the eye never sees it. The sheets of a depth mesh stop the light
  /// that would pass behind it; this stops it here too. One in the middle rather than one on each side: those
  /// would seal what lies between them, and leave it black where a coarse depth map lets it show over the
  /// column.
  TriangleMesh make_screen(const Vector3d& eye_m, const Vector3d& axis, double low_m, double high_m) const {
    const Vector3d sight = (axis - Vector3d(eye_m.x(), 0, eye_m.z())).normalized();
    const Vector3d end = axis + sight * ((arcade_z_m - aisle_m - axis.z()) / sight.z());
    const Vector3d middle(0, (low_m + high_m) / 2, 0);
    return beam(axis + middle, end + middle, 0.03, high_m - low_m);
  }

  /// The same behind the rail of the openwork of the bay that begins at `axis`: a lying sheet.
  TriangleMesh make_rail_screen(const Vector3d& eye_m, const Vector3d& axis) const {
    const auto behind = [&](const Vector3d& front) -> Vector3d {
      const Vector3d sight = front - eye_m;
      return eye_m + sight * ((arcade_z_m - aisle_m - eye_m.z()) / sight.z());
    };
    const Vector3d left = axis + Vector3d(openwork_from_m, rail_m, 0);
    const Vector3d right = axis + Vector3d(bay_m - openwork_from_m, rail_m, 0);
    const Vector3d up(0, 0.01, 0);
    TriangleMesh mesh = polygon({left + up, right + up, behind(right) + up, behind(left) + up});
    append(mesh, polygon({left - up, behind(left) - up, behind(right) - up, right - up}));
    return mesh;
  }

  /// A long bench along the aisle, on which things stand behind the columns.
  TriangleMesh make_plinths() const {
    const double z = arcade_z_m - 1.35;
    TriangleMesh mesh = box({first_x_m, 0, z - 0.75}, {first_x_m + bays * bay_m, 0.12, z + 0.75});
    append(mesh, box({first_x_m, 0.12, z - 0.68}, {first_x_m + bays * bay_m, 0.62, z + 0.68}));
    append(mesh, box({first_x_m, 0.62, z - 0.74}, {first_x_m + bays * bay_m, 0.72, z + 0.74}));
    return mesh;
  }

  void add_arcade(SceneContents& court) const {
    const Vector3d& eye_m = camera.position_m;
    TriangleMesh columns, arches, upper, balustrade, screens, ornament, panels, openwork;
    for (int i = 0; i <= bays; ++i) {
      const Vector3d axis(first_x_m + i * bay_m, 0, arcade_z_m);
      const Eigen::Affine3d there{Eigen::Translation3d(axis)};
      append(columns, transformed(make_column(spring_m, shaft_m), there));
      const Eigen::Affine3d above{Eigen::Translation3d(axis + Vector3d(0, storey_m, 0))};
      append(upper, transformed(make_column(2.3, 0.2), above));
      append(screens, make_screen(eye_m, axis, 0, spring_m));
      if (i == bays) continue;
      append(screens, make_rail_screen(eye_m, axis));
      for (int k = 0; k < balusters; ++k)
        append(screens, make_screen(eye_m, axis + Vector3d(baluster_x_m(k), 0, 0), 0.5, rail_m));
      append(openwork, transformed(make_openwork(beads + i % 3), there));
      append(arches, transformed(make_arch(spring_m, storey_m - 0.2), there));
      append(upper, transformed(make_arch(2.3, 3.8), above));
      append(ornament, transformed(make_ornament(spring_m), there));
      append(ornament, transformed(make_ornament(2.3), above));
      append(panels, transformed(make_wall_bay(),
                                 Eigen::Affine3d(Eigen::Translation3d(axis.x(), 0, arcade_z_m - aisle_m))));
      append(balustrade, transformed(make_balustrade(), above));
    }
    add(court, "plinths", make_plinths());
    add(court, "columns", columns);
    add(court, "openwork", openwork);
    add(court, "arches", arches);
    add(court, "gallery_arcade", upper);
    add(court, "balustrade", balustrade);
    add(court, "mouldings", ornament);
    add(court, "wall_panels", panels);
    add(court, "screens", screens);
  }

  SceneContents court() const {
    SceneContents court;
    const double low_x = first_x_m - 0.5;
    const double high_x = first_x_m + bays * bay_m + 0.5;
    const double wall_z = arcade_z_m - aisle_m;
    add(court, "floor", box({low_x, -0.1, wall_z}, {high_x, 0, 5}));
    add(court, "wall_back", box({low_x, 0, wall_z - 0.2}, {high_x, 9, wall_z}));
    add(court, "wall_left", box({low_x - 0.2, 0, wall_z}, {low_x, 9, 5}));
    add(court, "wall_right", box({high_x, 0, wall_z}, {high_x + 0.2, 9, 5}));
    add(court, "wall_front", box({low_x, 0, 5}, {high_x, 9, 5.2}));
    add(court, "gallery_floor", box({low_x, storey_m - 0.2, wall_z}, {high_x, storey_m, arcade_z_m + 0.3}));
    TriangleMesh cornice =
        box({low_x, storey_m - 0.22, arcade_z_m + 0.3}, {high_x, storey_m - 0.12, arcade_z_m + 0.42});
    append(cornice, box({low_x, storey_m - 0.12, arcade_z_m + 0.3}, {high_x, storey_m, arcade_z_m + 0.52}));
    append(cornice,
           box({low_x, storey_m + 3.7, arcade_z_m + 0.3}, {high_x, storey_m + 3.9, arcade_z_m + 0.6}));
    for (int i = 0; i < bays * 10; ++i) {  // dentils
      const double x = first_x_m + bay_m * (i + 0.25) / 10;
      append(cornice,
             box({x, storey_m - 0.32, arcade_z_m + 0.3}, {x + 0.15, storey_m - 0.22, arcade_z_m + 0.4}));
    }
    add(court, "cornice", cornice);
    add_arcade(court);
    court.camera = camera;
    return court;
  }
};

}  // namespace
}  // namespace atrium_parts

SceneContents make_arcade(const ArcadePlan& plan) {
  return atrium_parts::ArcadeBuilder{plan}.court();
}

}  // namespace seamline::scenes
