#pragma once
#include <atomic>
#include <vector>

#include "renderer/depth/adaptive_mesh_numbering.h"
#include "renderer/depth/dense_sphere.h"
#include "renderer/depth/depth_mesh.h"
#include "support/running/parallel.h"

namespace seamline::renderer {

/// Makes a mesh of the triangles that `for_each_triangle(part, out)` tells by out(a, b, c), each a
/// GridVertex, for every part in [0, parts). It is asked twice, for counting and for writing, so that the
/// mesh needs exactly the memory it keeps and the parts can be done in parallel; triangles are in order of
/// parts, vertices in order of the numbering, the poles last.
template <class ForEachTriangle>
DepthMesh assemble_mesh(const DenseSphere& sphere, int parts, int threads,
                        const ForEachTriangle& for_each_triangle) {
  VertexNumbering numbering(sphere.width, sphere.height);
  std::atomic<bool> uses_zenith = false, uses_nadir = false;
  std::vector<std::size_t> first_triangle(static_cast<std::size_t>(parts) + 1);
  run_parallel(parts, threads, [&](int part) {
    std::size_t count = 0;
    const auto mark = [&](const GridVertex& vertex) {
      if (vertex.row < 0)
        uses_zenith = true;
      else if (vertex.row == sphere.height)
        uses_nadir = true;
      else
        numbering.mark(vertex.row, vertex.column);
    };
    for_each_triangle(part, [&](const GridVertex& a, const GridVertex& b, const GridVertex& c) {
      mark(a), mark(b), mark(c);
      ++count;
    });
    first_triangle[part + 1] = count;
  });
  for (std::size_t i = 1; i < first_triangle.size(); ++i) first_triangle[i] += first_triangle[i - 1];

  DepthMesh mesh;
  const std::uint32_t zenith = numbering.number_marked();
  const std::uint32_t nadir = zenith + (uses_zenith ? 1 : 0);
  mesh.vertices_m.resize(nadir + (uses_nadir ? 1 : 0));
  numbering.write_positions(sphere, mesh.vertices_m.data(), threads);
  if (uses_zenith) mesh.vertices_m[zenith] = {0, sphere.zenith_m, 0};
  if (uses_nadir) mesh.vertices_m[nadir] = {0, -sphere.nadir_m, 0};

  mesh.triangles.resize(first_triangle.back());
  run_parallel(parts, threads, [&](int part) {
    auto* triangle = mesh.triangles.data() + first_triangle[part];
    const auto index = [&](const GridVertex& vertex) {
      if (vertex.row < 0) return zenith;
      return vertex.row == sphere.height ? nadir : numbering.number(vertex.row, vertex.column);
    };
    for_each_triangle(part, [&](const GridVertex& a, const GridVertex& b, const GridVertex& c) {
      *triangle++ = {index(a), index(b), index(c)};
    });
  });
  return mesh;
}

}  // namespace seamline::renderer
