#include "renderer/depth/sensor/pixel_mesh.h"

#include <algorithm>
#include <bit>

#include "renderer/depth/lattice/refinement.h"
#include "renderer/depth/sensor/pixel_bound.h"

namespace seamline::renderer {
namespace {

/// Takes triangles of a grid and numbers the vertices that they use, in the order of their first use.
class MeshWriter {
 public:
  explicit MeshWriter(const PixelGrid& grid) : grid_(grid), number_(grid.points_m.size(), unused) {}

  void add(const GridVertex& a, const GridVertex& b, const GridVertex& c) {
    const std::uint32_t first = number(a), second = number(b), third = number(c);
    mesh_.triangles.push_back({first, second, third});
  }
  [[nodiscard]] DepthMesh take() { return std::move(mesh_); }

 private:
  static constexpr std::uint32_t unused = 0xffffffff;

  std::uint32_t number(const GridVertex& v) {
    std::uint32_t& number = number_[grid_.index(v)];
    if (number == unused) {
      number = static_cast<std::uint32_t>(mesh_.vertices_m.size());
      mesh_.vertices_m.push_back(grid_.points_m[grid_.index(v)]);
    }
    return number;
  }

  const PixelGrid& grid_;
  std::vector<std::uint32_t> number_;
  DepthMesh mesh_;
};

/// Writes a triangle of one cell where all its corners were measured and nothing jumps.
class CellWriter {
 public:
  CellWriter(const PixelGrid& grid, const PixelMeshOptions& options, MeshWriter& out)
      : grid_(grid), options_(options), out_(out) {}

  void operator()(const GridVertex& a, const GridVertex& b, const GridVertex& c) const {
    if (!grid_.valid(a) || !grid_.valid(b) || !grid_.valid(c)) return;
    if (options_.only != nullptr && !is_among(a) && !is_among(b) && !is_among(c)) return;
    if (options_.cut_ratio &&
        is_jump(grid_.seen_m(a).norm(), grid_.seen_m(b).norm(), grid_.seen_m(c).norm(), *options_.cut_ratio))
      return;
    out_.add(a, b, c);
  }

 private:
  [[nodiscard]] bool is_among(const GridVertex& v) const { return (*options_.only)[grid_.index(v)] != 0; }

  const PixelGrid& grid_;
  const PixelMeshOptions& options_;
  MeshWriter& out_;
};

DepthMesh full_mesh(const PixelGrid& grid, const PixelMeshOptions& options) {
  MeshWriter out(grid);
  const CellWriter write(grid, options, out);
  for (int upper = 0; upper + 1 < grid.camera.height_px; ++upper)
    for (int left = 0; left + 1 < grid.camera.width_px; ++left) {
      const GridVertex nw{upper, left}, sw{upper + 1, left}, se{upper + 1, left + 1}, ne{upper, left + 1};
      write(nw, sw, se);
      write(nw, se, ne);
    }
  return out.take();
}

/// Of a plane any triangle is as good as many; a block is as large as the picture lets four of them be.
int largest_leg_px(const sensors::PinholeCamera& camera) {
  const int side_px = std::min(camera.width_px, camera.height_px) - 1;
  return static_cast<int>(std::bit_floor(static_cast<unsigned>(std::max(1, side_px / 2))));
}

DepthMesh adaptive_mesh(const PixelGrid& grid, const PixelMeshOptions& options) {
  Lattice lattice({.columns = grid.camera.width_px,
                   .rows = grid.camera.height_px,
                   .block = largest_leg_px(grid.camera),
                   .wraps = false});
  const PixelBound bound(grid, options.tolerance, options.cut_ratio);
  refine_all(lattice, bound, options.threads);
  MeshWriter out(grid);
  const CellWriter write(grid, options, out);
  const auto vertex = [&](const LatticePoint& p) { return lattice.grid_vertex(p); };
  for (int root = 0; root < lattice.root_count(); ++root)
    lattice.for_each_leaf(lattice.root(root), [&](const LatticeTriangle& t) {
      if (t.is_unit())
        write_unit(lattice, t, vertex, write);
      else if (grid.valid(vertex(t.apex)))  // else it lies in a hole as a whole
        out.add(vertex(t.apex), vertex(t.left), vertex(t.right));
    });
  DepthMesh mesh = out.take();
  mesh.max_relative_error = largest_error(lattice, bound, options.threads);
  return mesh;
}

}  // namespace

DepthMesh build_pixel_mesh(const PixelGrid& grid, const PixelMeshOptions& options) {
  switch (options.density) {
    case MeshDensity::adaptive:
      return adaptive_mesh(grid, options);
    case MeshDensity::full:
      return full_mesh(grid, options);
  }
  return {};
}

void append(DepthMesh& mesh, const DepthMesh& more) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices_m.size());
  mesh.vertices_m.insert(mesh.vertices_m.end(), more.vertices_m.begin(), more.vertices_m.end());
  for (const Triangle& t : more.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  mesh.max_relative_error = std::max(mesh.max_relative_error, more.max_relative_error);
}

}  // namespace seamline::renderer
