#include "scenes/shapes/polygonise.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "scenes/shapes/decimate.h"
#include "scenes/shapes/lattice.h"
#include "support/running/parallel.h"

namespace seamline::scenes {
namespace {

using Array3i = Eigen::Array3i;
using Vector3d = Eigen::Vector3d;

/// A lattice edge that the surface crosses, by its inside and outside points.
struct Crossing {
  std::uint64_t inside = 0;
  std::uint64_t outside = 0;
  bool operator==(const Crossing&) const = default;
};
struct CrossingHash {
  std::size_t operator()(const Crossing& c) const { return c.inside * 0x9E3779B97F4A7C15ULL ^ c.outside; }
};
using CrossedTriangle = std::array<Crossing, 3>;

Vector3d midpoint(const FieldLattice& lattice, const Crossing& c) {
  return (lattice.position_m(c.inside) + lattice.position_m(c.outside)) / 2;
}

/// Turned so that the triangle faces from the inside points to the outside points of its tetrahedron.
void emit(const FieldLattice& lattice, CrossedTriangle triangle, std::vector<CrossedTriangle>& out) {
  const Vector3d a = midpoint(lattice, triangle[0]);
  const Vector3d normal = (midpoint(lattice, triangle[1]) - a).cross(midpoint(lattice, triangle[2]) - a);
  Vector3d outwards = Vector3d::Zero();
  for (const Crossing& c : triangle) outwards += lattice.position_m(c.outside) - lattice.position_m(c.inside);
  if (normal.dot(outwards) < 0) std::swap(triangle[1], triangle[2]);
  out.push_back(triangle);
}

void march(const FieldLattice& lattice, const std::array<std::uint64_t, 4>& corners,
           std::vector<CrossedTriangle>& out) {
  std::array<std::uint64_t, 4> in{};
  std::array<std::uint64_t, 4> ex{};
  std::size_t ins = 0;
  std::size_t exs = 0;
  for (const std::uint64_t corner : corners) {
    if (lattice.values[corner] < 0.0F)
      in[ins++] = corner;
    else
      ex[exs++] = corner;
  }
  if (ins == 1) emit(lattice, {{{in[0], ex[0]}, {in[0], ex[1]}, {in[0], ex[2]}}}, out);
  if (ins == 3) emit(lattice, {{{in[0], ex[0]}, {in[1], ex[0]}, {in[2], ex[0]}}}, out);
  if (ins == 2) {
    emit(lattice, {{{in[0], ex[0]}, {in[0], ex[1]}, {in[1], ex[1]}}}, out);
    emit(lattice, {{{in[0], ex[0]}, {in[1], ex[1]}, {in[1], ex[0]}}}, out);
  }
}

/// The twelve tetrahedra between a cube's centre and those of its three next neighbours, through their shared
/// faces' edges.
void march_cube(const FieldLattice& lattice, const Array3i& cube, std::vector<CrossedTriangle>& out) {
  const std::uint64_t centre = lattice.point(cube, true);
  for (int axis = 0; axis < 3; ++axis) {
    Array3i next = cube;
    next[axis] += 1;
    std::array<std::uint64_t, 4> ring{};
    for (std::size_t i = 0; i < 4; ++i) {
      Array3i corner = next;
      corner[(axis + 1) % 3] += i == 1 || i == 2 ? 1 : 0;
      corner[(axis + 2) % 3] += i >= 2 ? 1 : 0;
      ring[i] = lattice.point(corner, false);
    }
    const std::uint64_t other = lattice.point(next, true);
    for (std::size_t i = 0; i < 4; ++i) march(lattice, {centre, other, ring[i], ring[(i + 1) % 4]}, out);
  }
}

std::vector<CrossedTriangle> march_all(const FieldLattice& lattice, int threads) {
  const int layers = lattice.cubes.z() - 2;
  std::vector<std::vector<CrossedTriangle>> by_layer(static_cast<std::size_t>(std::max(layers, 0)));
  run_parallel(layers, threads, [&](int z) {
    for (int y = 0; y + 2 < lattice.cubes.y(); ++y)
      for (int x = 0; x + 2 < lattice.cubes.x(); ++x)
        march_cube(lattice, {x, y, z}, by_layer[static_cast<std::size_t>(z)]);
  });
  std::vector<CrossedTriangle> all;
  for (const auto& layer : by_layer) all.insert(all.end(), layer.begin(), layer.end());
  return all;
}

Vector3d gradient_at(const LocalField& field, const Vector3d& point, double step) {
  Vector3d gradient;
  for (int axis = 0; axis < 3; ++axis) {
    Vector3d shift = Vector3d::Zero();
    shift[axis] = step;
    gradient[axis] = (field(point + shift) - field(point - shift)) / (2 * step);
  }
  return gradient;
}

/// Newton steps onto the surface, together no longer than a third of a cell, so that triangles do not fold.
void settle(const Sculpture& sculpture, const PolygoniseOptions& options, Vector3d& position,
            Vector3d& normal) {
  const LocalField field = field_near(sculpture, position, options.cell_m);
  const double reach = options.cell_m / 3;
  const Vector3d start = position;
  if (position.y() > options.ground_m + 0.02 * options.cell_m)
    for (int step = 0; step < 3; ++step) {
      const Vector3d gradient = gradient_at(field, position, 0.05 * options.cell_m);
      const double steepness2 = std::max(gradient.squaredNorm(), 1e-3);
      Vector3d moved = position - field(position) / steepness2 * gradient - start;
      if (moved.norm() > reach) moved *= reach / moved.norm();
      position = start + moved;
    }
  position.y() = std::max(position.y(), options.ground_m);
  const bool on_sole = field(position) < -0.05 * options.cell_m;
  normal = on_sole ? Vector3d(-Vector3d::UnitY()) : gradient_at(field, position, 0.25 * options.cell_m);
  normal = normal.norm() > 1e-9 ? Vector3d(normal.normalized()) : Vector3d::UnitY();
}

/// The crossed edges' points, one vertex each, at the linear estimate of the surface.
TriangleMesh march_and_weld(const Sculpture& sculpture, const PolygoniseOptions& options) {
  const FieldLattice lattice = sample_field(sculpture, options.cell_m, options.ground_m, options.threads);
  TriangleMesh mesh;
  std::unordered_map<Crossing, std::uint32_t, CrossingHash> numbers;
  for (const CrossedTriangle& crossed : march_all(lattice, options.threads)) {
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [entry, is_new] =
          numbers.try_emplace(crossed[i], static_cast<std::uint32_t>(mesh.positions_m.size()));
      triangle[i] = entry->second;
      if (!is_new) continue;
      const double in = lattice.values[crossed[i].inside];
      const double ex = lattice.values[crossed[i].outside];
      const double t = std::clamp(in / (in - ex), 0.05, 0.95);
      mesh.positions_m.push_back((1 - t) * lattice.position_m(crossed[i].inside) +
                                 t * lattice.position_m(crossed[i].outside));
    }
    mesh.triangles.push_back(triangle);
  }
  mesh.normals.resize(mesh.positions_m.size(), Vector3d::UnitY());
  return largest_piece(mesh);
}

void settle_all(TriangleMesh& mesh, const Sculpture& sculpture, const PolygoniseOptions& options) {
  constexpr int batch = 512;
  const auto count = static_cast<int>(mesh.positions_m.size());
  run_parallel((count + batch - 1) / batch, options.threads, [&](int part) {
    for (int i = part * batch; i < std::min(count, (part + 1) * batch); ++i) {
      const auto vertex = static_cast<std::size_t>(i);
      settle(sculpture, options, mesh.positions_m[vertex], mesh.normals[vertex]);
    }
  });
}

}  // namespace

TriangleMesh polygonise(const Sculpture& sculpture, const PolygoniseOptions& options) {
  TriangleMesh mesh = march_and_weld(sculpture, options);
  if (options.triangles > 0 && mesh.triangles.size() > options.triangles)
    mesh = decimated(mesh, options.triangles);
  settle_all(mesh, sculpture, options);
  return mesh;
}

}  // namespace seamline::scenes
