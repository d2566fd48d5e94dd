#pragma once
#include <Eigen/Core>
#include <vector>

#include "scenes/shapes/mesh.h"

namespace seamline::scenes {

/// An upright cuboid, each face flat-shaded with its own four vertices.
[[nodiscard]] TriangleMesh box(const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m);

/// A point (radius, height) of a profile that is turned about the y axis.
struct ProfilePoint {
  double radius_m = 0;
  double height_m = 0;
};

/// A closed solid of revolution: the profile runs from the lowest point up; ends are closed with discs.
/// Corners of the profile stay sharp, the way around is smooth (or flat for few `sides`, when `smooth` is
/// false).
[[nodiscard]] TriangleMesh turned(const std::vector<ProfilePoint>& profile, int sides, bool smooth = true);

/// A ring: a closed profile, counter-clockwise with the radius to the right and the height upwards, turned
/// about the y axis.
[[nodiscard]] TriangleMesh turned_ring(const std::vector<ProfilePoint>& profile, int sides);

/// A plate between two flat outlines: `outline` (x, y), counter-clockwise and convex or star-shaped about its
/// mean, extruded from z = low_m to z = high_m. Flat-shaded.
[[nodiscard]] TriangleMesh extruded(const std::vector<Eigen::Vector2d>& outline, double low_m, double high_m);

/// A flat-shaded beam of square section between two points.
[[nodiscard]] TriangleMesh beam(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m, double width_m,
                                double height_m);

/// A flat polygon fan (convex), counter-clockwise seen from its front.
[[nodiscard]] TriangleMesh polygon(const std::vector<Eigen::Vector3d>& corners_m);

}  // namespace seamline::scenes
