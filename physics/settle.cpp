#include "physics/settle.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "support/running/interrupt.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

constexpr double longest_s = 20, looks_per_s = 2;
constexpr double still_m = 2e-4, still_deg = 0.1;
constexpr double deepest_m = 0.01, deepest_share = 0.1;
constexpr double lost_m = 1;  ///< below the ground's lowest point

double smallest_side_m(const BodyShape& shape) {
  if (const auto* ball = std::get_if<BallShape>(&shape)) return 2 * ball->radius_m;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point_m : std::get<HullShape>(shape).points_m) box.extend(point_m);
  return box.sizes().minCoeff();
}

/// The distance along a ray to a triangle, if it meets it.
double distance_to(const Eigen::Vector3d& origin_m, const Eigen::Vector3d& direction,
                   const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const Eigen::Vector3d ab = b - a, ac = c - a, p = direction.cross(ac);
  const double det = ab.dot(p);
  if (det == 0) return none;
  const Eigen::Vector3d from_a = origin_m - a, q = from_a.cross(ab);
  const double u = from_a.dot(p) / det, v = direction.dot(q) / det, t = ac.dot(q) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : none;
}

/// Whether the first surface in a direction shows its back.
bool shows_back(const Ground& ground, const Eigen::Vector3d& origin_m, const Eigen::Vector3d& direction) {
  double nearest_m = std::numeric_limits<double>::infinity();
  bool back = false;
  for (const auto& corners : ground.triangles) {
    const Eigen::Vector3d &a = ground.vertices_m[corners[0]], &b = ground.vertices_m[corners[1]],
                          &c = ground.vertices_m[corners[2]];
    const double distance_m = distance_to(origin_m, direction, a, b, c);
    if (!(distance_m < nearest_m)) continue;
    nearest_m = distance_m;
    back = (b - a).cross(c - a).dot(direction) > 0;
  }
  return back;
}

bool is_inside(const Ground& ground, const Eigen::Vector3d& place_m) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0})
      if (!shows_back(ground, place_m, sign * Eigen::Vector3d::Unit(axis))) return false;
  return true;
}

double turned_deg(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  const Eigen::Quaterniond one(from.linear()), other(to.linear());
  return one.angularDistance(other) * 180 / std::numbers::pi;
}

}  // namespace

double lowest_m(const Ground& ground) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& vertex_m : ground.vertices_m) lowest = std::min(lowest, vertex_m.y());
  return lowest;
}

void require_free_start(const RigidWorld& world, const Ground& ground, const BodyShape& shape,
                        const std::string& what) {
  const Overlap overlap = world.deepest_overlap();
  const double allowed_m = std::min(deepest_m, deepest_share * smallest_side_m(shape));
  if (overlap.depth_m > allowed_m)
    throw input_error(
        {.field = what,
         .wanted = "a place above the surface that it is let down on",
         .found = fmt::format(
             "one where its convex hull reaches {:.3g} m into the surface at {:.2f} {:.2f} {:.2f}: "
             "let go of it higher, or farther from there",
             overlap.depth_m, overlap.where_m.x(), overlap.where_m.y(), overlap.where_m.z())});
  const Eigen::Vector3d middle_m = world.body().middle_m;
  if (is_inside(ground, middle_m))
    throw input_error({.field = what,
                       .wanted = "a place above the surface that it is let down on",
                       .found = "one inside a wall or a thing: all around it are backs of surfaces"});
}

Settled settle(const Ground& ground, const BodyShape& shape, const Eigen::Isometry3d& world_from_body,
               const PhysicsSettings& settings, const std::string& what) {
  RigidWorld world(ground, shape, world_from_body, settings);
  require_free_start(world, ground, shape, what);
  const double bottom_m = lowest_m(ground) - lost_m;
  const BodyState start = world.body();
  BodyState before = start;
  const int steps_a_look = std::max(1, static_cast<int>(settings.steps_per_s / looks_per_s));
  for (int look = 1; look <= static_cast<int>(longest_s * looks_per_s); ++look) {
    for (int i = 0; i < steps_a_look; ++i) {
      stop_if_interrupted();
      world.step();
    }
    const BodyState now = world.body();
    if (!(now.middle_m.y() > bottom_m))
      throw input_error(
          {.field = what,
           .wanted = "a surface below it that holds it",
           .found = fmt::format("none: it falls out of the scene, past its lowest point at {:.3g} m",
                                bottom_m + lost_m)});
    if ((now.middle_m - before.middle_m).norm() < still_m &&
        turned_deg(before.world_from_body, now.world_from_body) < still_deg)
      return {.world_from_body = now.world_from_body,
              .seconds = look / looks_per_s,
              .moved_m = (now.middle_m - start.middle_m).norm(),
              .turned_deg = turned_deg(start.world_from_body, now.world_from_body)};
    before = now;
  }
  throw input_error({.field = what,
                     .wanted = "a place from which it comes to rest",
                     .found = fmt::format("that it still moves after {:g} s, at {:.2g} m/s", longest_s,
                                          world.body().speed_m_s)});
}

}  // namespace seamline::renderer
