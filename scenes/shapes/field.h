#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <vector>

namespace seamline::scenes {

/// A signed distance in metres, or an estimate of it that is right near the surface: negative inside.
using Distance = std::function<double(const Eigen::Vector3d& point_m)>;

/// One piece of clay: its shape, and how it joins what was put before it.
struct Stroke {
  Distance distance;
  Eigen::AlignedBox3d bounds;  ///< holds the whole shape, the radius of its joint not included
  double blend_m = 0.0;        ///< width of the smooth joint; 0 is a crease
  bool carves = false;         ///< taken away instead of added
};

/// A sculpture is what its strokes, applied in order, make.
struct Sculpture {
  std::vector<Stroke> strokes;
  Distance relief;        ///< added to the distance everywhere: scales, fur, folds; may be empty
  double relief_m = 0.0;  ///< largest absolute value of `relief`
};

/// The field of those strokes only that can matter near some box; the strokes must outlive it.
struct LocalField {
  std::vector<const Stroke*> strokes;
  const Distance* relief = nullptr;

  [[nodiscard]] double operator()(const Eigen::Vector3d& point_m) const;
};

/// The strokes whose bounds, widened by their joint and by `margin_m`, meet the box. Near the surface and
/// inside the box the field of these is that of all: a smooth joint of width k has no effect where the two
/// distances differ by more than k.
[[nodiscard]] LocalField near_box(const Sculpture& sculpture, const Eigen::AlignedBox3d& box,
                                  double margin_m);

/// Polynomial smooth minimum: exactly min(a, b) where |a - b| >= blend_m.
[[nodiscard]] double smooth_min(double a, double b, double blend_m);

}  // namespace seamline::scenes
