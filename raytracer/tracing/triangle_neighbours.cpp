#include "raytracer/tracing/triangle_neighbours.h"

namespace seamline::renderer {

std::vector<std::array<std::uint32_t, 3>> triangle_neighbours(std::size_t vertex_count,
                                                              std::span<const Triangle> triangles) {
  struct Edge {
    std::uint32_t to, triangle;
  };
  // Edges in the order of the vertices they start from.
  std::vector<std::uint32_t> first(vertex_count + 1);
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t) ++first[v + 1];
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  std::vector<Edge> edges(triangles.size() * 3);
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) edges[next[triangles[i][k]]++] = {triangles[i][(k + 1) % 3], i};

  std::vector<std::array<std::uint32_t, 3>> neighbours(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t to = triangles[i][k], from = triangles[i][(k + 1) % 3];
      neighbours[i][k] = no_neighbour;
      for (std::uint32_t e = first[from]; e < first[from + 1]; ++e)
        if (edges[e].to == to) neighbours[i][k] = edges[e].triangle;
    }
  return neighbours;
}

}  // namespace seamline::renderer
