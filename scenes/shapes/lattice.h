#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "scenes/shapes/field.h"

namespace seamline::scenes {

/// A body-centred cubic lattice of field values: the corners and the centres of cubes. Points are numbered
/// 2 * cube for a cube's lowest corner, 2 * cube + 1 for its centre.
struct FieldLattice {
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
  double cell_m = 0.0;
  Eigen::Array3i cubes = Eigen::Array3i::Zero();
  std::vector<float> values;  ///< two a cube; positive outside

  [[nodiscard]] std::uint64_t point(const Eigen::Array3i& cube, bool centre) const {
    const auto index = static_cast<std::uint64_t>(
        (static_cast<std::int64_t>(cube.z()) * cubes.y() + cube.y()) * cubes.x() + cube.x());
    return 2 * index + (centre ? 1 : 0);
  }
  [[nodiscard]] Eigen::Vector3d position_m(std::uint64_t point) const;
};

/// Cubes along an edge of the blocks in which strokes are looked up.
inline constexpr int lattice_block = 8;

/// The lattice around a sculpture with every value set. Blocks far from the surface hold a value of the right
/// sign only.
[[nodiscard]] FieldLattice sample_field(const Sculpture& sculpture, double cell_m, double ground_m,
                                        int threads);

/// The field near a point of the lattice: of the block that holds it, cut off below `ground_m`.
[[nodiscard]] LocalField field_near(const Sculpture& sculpture, const Eigen::Vector3d& point_m,
                                    double reach_m);

}  // namespace seamline::scenes
