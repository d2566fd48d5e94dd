#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "scenes/shapes/field.h"

namespace seamline::scenes {

/// A point on the spine of a limb, and the limb's radius there.
struct Knot {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  double radius_m = 0.0;
};

/// A limb: round cones along the Catmull-Rom curve through the knots, `steps` between two of them.
[[nodiscard]] Stroke limb(const std::vector<Knot>& knots, double blend_m, int steps = 6);

/// A limb swollen into `rings` overlapping segments, `depth_m` deep at the creases: armoured tails, belly
/// plates.
[[nodiscard]] Stroke ringed_limb(const std::vector<Knot>& knots, int rings, double depth_m, double blend_m);

/// A limb pressed flat: thinner by `flatness` (over 1) along the direction `across`; for feathers, fins,
/// ears, petals.
[[nodiscard]] Stroke blade(const std::vector<Knot>& knots, const Eigen::Vector3d& across, double flatness,
                           double blend_m);

/// A straight spike from a base radius to a point.
[[nodiscard]] Stroke spike(const Eigen::Vector3d& base_m, const Eigen::Vector3d& tip_m, double radius_m,
                           double blend_m);

/// An ellipsoid with the given half axes, turned by `turn`.
[[nodiscard]] Stroke lump(const Eigen::Vector3d& centre_m, const Eigen::Vector3d& half_axes_m, double blend_m,
                          const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity());

/// An upright cylinder with rounded edges.
[[nodiscard]] Stroke drum(const Eigen::Vector3d& base_m, double radius_m, double height_m, double edge_m,
                          double blend_m);

/// A cuboid with rounded edges, turned by `turn` about its centre.
[[nodiscard]] Stroke block(const Eigen::Vector3d& centre_m, const Eigen::Vector3d& half_size_m, double edge_m,
                           double blend_m, const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity());

/// A thin skin over the triangle of three points, e.g. between the fingers of a wing.
[[nodiscard]] Stroke skin(const Eigen::Vector3d& a_m, const Eigen::Vector3d& b_m, const Eigen::Vector3d& c_m,
                          double half_thickness_m, double blend_m);

/// The same stroke, taken away.
[[nodiscard]] Stroke carved(Stroke stroke);

/// The stroke seen in a mirror whose normal is `axis` (0 x, 1 y, 2 z) through the origin.
[[nodiscard]] Stroke mirrored(const Stroke& stroke, int axis);

/// Adds a stroke and its mirror image.
void add_pair(Sculpture& sculpture, const Stroke& stroke, int axis);

/// Leathery relief for a sculpture: rounded scales of `size_m` in a slanted, slightly uneven net; 0 on a
/// scale, `depth_m` between.
[[nodiscard]] double scales(const Eigen::Vector3d& point_m, double size_m, double depth_m);

/// The rotation that takes +Y to `direction`.
[[nodiscard]] Eigen::Quaterniond upright_to(const Eigen::Vector3d& direction);

/// Spikes along a smooth curve, standing on it: from knots[i] towards knots[i] + rise[i], base radius
/// knots[i].radius_m.
struct Crest {
  std::vector<Knot> knots;
  std::vector<Eigen::Vector3d> rise_m;  ///< one a knot
  int count = 10;                       ///< spikes from the first knot to the last
  double blend_m = 0.01;
};
void add_crest(Sculpture& sculpture, const Crest& crest);

/// Points and radii on the Catmull-Rom curve through `knots`, `steps` a span, ends included.
[[nodiscard]] std::vector<Knot> smooth_curve(const std::vector<Knot>& knots, int steps);

}  // namespace seamline::scenes
