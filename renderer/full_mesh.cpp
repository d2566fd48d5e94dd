#include "renderer/full_mesh.h"

#include "renderer/adaptive_mesh_numbering.h"
#include "renderer/adaptive_mesh_workers.h"

namespace seamline {
namespace {

/// A vertex of the dense sphere; row -1 is the zenith, row `height` the nadir, where the column means
/// nothing.
struct GridVertex {
  int row = 0, column = 0;
};

/// Calls out(a, b, c) for each triangle between row `band - 1` and row `band`, band in [0, height]: the two
/// at the ends are the fans.
void for_each_triangle(const DenseSphere& sphere, int band, auto out) {
  const int upper = band - 1, lower = band;
  const auto valid = [&](int row, int column) {
    if (row < 0) return !is_hole(sphere.zenith_m);
    if (row == sphere.height) return !is_hole(sphere.nadir_m);
    return !is_hole(sphere.at(row, column));
  };
  for (int left = 0; left < sphere.width; ++left) {
    const int right = left + 1 == sphere.width ? 0 : left + 1;
    if (!valid(upper, left) || !valid(lower, right)) continue;  // both triangles of the cell need these
    if (lower < sphere.height && valid(lower, left))
      out(GridVertex{upper, left}, GridVertex{lower, left}, GridVertex{lower, right});
    if (upper >= 0 && valid(upper, right))
      out(GridVertex{upper, left}, GridVertex{lower, right}, GridVertex{upper, right});
  }
}

}  // namespace

DepthMesh build_full_mesh(const DenseSphere& sphere, int threads) {
  const int bands = sphere.height + 1;
  VertexNumbering numbering(sphere.width, sphere.height);
  std::vector<std::size_t> first_triangle(static_cast<std::size_t>(bands) + 1);
  for_each_in_parallel(bands, threads, [&](int band) {
    std::size_t count = 0;
    const auto mark = [&](const GridVertex& vertex) {
      if (vertex.row >= 0 && vertex.row < sphere.height) numbering.mark(vertex.row, vertex.column);
    };
    for_each_triangle(sphere, band, [&](const GridVertex& a, const GridVertex& b, const GridVertex& c) {
      mark(a), mark(b), mark(c);
      ++count;
    });
    first_triangle[static_cast<std::size_t>(band) + 1] = count;
  });
  const bool has_zenith = first_triangle[1] > 0, has_nadir = first_triangle.back() > 0;
  for (std::size_t i = 1; i < first_triangle.size(); ++i) first_triangle[i] += first_triangle[i - 1];

  DepthMesh mesh;
  const std::uint32_t zenith = numbering.number_marked();
  const std::uint32_t nadir = zenith + (has_zenith ? 1 : 0);
  mesh.vertices_m.resize(nadir + (has_nadir ? 1 : 0));
  numbering.write_positions(sphere, mesh.vertices_m.data(), threads);
  if (has_zenith) mesh.vertices_m[zenith] = {0, sphere.zenith_m, 0};
  if (has_nadir) mesh.vertices_m[nadir] = {0, -sphere.nadir_m, 0};

  mesh.triangles.resize(first_triangle.back());
  for_each_in_parallel(bands, threads, [&](int band) {
    auto* triangle = mesh.triangles.data() + first_triangle[static_cast<std::size_t>(band)];
    const auto index = [&](const GridVertex& vertex) {
      if (vertex.row < 0) return zenith;
      return vertex.row == sphere.height ? nadir : numbering.number(vertex.row, vertex.column);
    };
    for_each_triangle(sphere, band, [&](const GridVertex& a, const GridVertex& b, const GridVertex& c) {
      *triangle++ = {index(a), index(b), index(c)};
    });
  });
  return mesh;
}

}  // namespace seamline
