#include "scenes/shapes/lattice.h"

#include <cmath>

#include "support/running/parallel.h"

namespace seamline::scenes {
namespace {

using Box = Eigen::AlignedBox3d;
using Vector3d = Eigen::Vector3d;

/// Fields are not exact distances away from the surface; a block is skipped only when it is this much farther
/// than it need be.
constexpr double distance_safety = 2.5;

void sample_block(const Sculpture& sculpture, FieldLattice& lattice, const Eigen::Array3i& first,
                  double ground_m) {
  const Eigen::Array3i end = (first + lattice_block).min(lattice.cubes);
  const Vector3d low = lattice.origin_m + lattice.cell_m * first.cast<double>().matrix();
  const Vector3d high = lattice.origin_m + lattice.cell_m * end.cast<double>().matrix();
  const LocalField field = near_box(sculpture, Box(low, high), lattice.cell_m);
  const double middle = field((low + high) / 2);
  const bool far = field.strokes.empty() ||
                   std::abs(middle) > distance_safety * (high - low).norm() / 2 + sculpture.relief_m;
  for (int z = first.z(); z < end.z(); ++z)
    for (int y = first.y(); y < end.y(); ++y)
      for (int x = first.x(); x < end.x(); ++x)
        for (const bool centre : {false, true}) {
          const std::uint64_t point = lattice.point({x, y, z}, centre);
          const Vector3d position = lattice.position_m(point);
          const double inside = far ? middle : field(position);
          lattice.values[point] = static_cast<float>(std::max(inside, ground_m - position.y()));
        }
}

}  // namespace

Vector3d FieldLattice::position_m(std::uint64_t point) const {
  const std::uint64_t cube = point / 2;
  const auto nx = static_cast<std::uint64_t>(cubes.x());
  const auto ny = static_cast<std::uint64_t>(cubes.y());
  const double half = point % 2 == 1 ? 0.5 : 0.0;
  return origin_m + cell_m * Vector3d(static_cast<double>(cube % nx) + half,
                                      static_cast<double>(cube / nx % ny) + half,
                                      static_cast<double>(cube / nx / ny) + half);
}

FieldLattice sample_field(const Sculpture& sculpture, double cell_m, double ground_m, int threads) {
  Box box;
  for (const Stroke& stroke : sculpture.strokes)
    if (!stroke.carves) box.extend(stroke.bounds);
  box.min().y() = std::max(box.min().y(), ground_m);
  const Vector3d margin = Vector3d::Constant(2.5 * cell_m + sculpture.relief_m + 0.05);
  FieldLattice lattice{.origin_m = box.min() - margin, .cell_m = cell_m, .cubes = {}, .values = {}};
  lattice.cubes = ((box.sizes() + 2 * margin) / cell_m).array().ceil().cast<int>();
  lattice.values.resize(2 * static_cast<std::size_t>(lattice.cubes.cast<std::int64_t>().prod()));
  const Eigen::Array3i blocks = (lattice.cubes + lattice_block - 1) / lattice_block;
  run_parallel(blocks.prod(), threads, [&](int block) {
    const Eigen::Array3i at(block % blocks.x(), block / blocks.x() % blocks.y(),
                            block / blocks.x() / blocks.y());
    sample_block(sculpture, lattice, at * lattice_block, ground_m);
  });
  return lattice;
}

LocalField field_near(const Sculpture& sculpture, const Vector3d& point_m, double reach_m) {
  const Vector3d reach = Vector3d::Constant(reach_m);
  return near_box(sculpture, Box(point_m - reach, point_m + reach), reach_m);
}

}  // namespace seamline::scenes
