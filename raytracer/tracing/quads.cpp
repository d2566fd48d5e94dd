#include "raytracer/tracing/quads.h"

#include <algorithm>

#include "raytracer/tracing/triangle_neighbours.h"

namespace seamline::renderer {
namespace {

/// Pairs triangles over edges, until no two that are left share one.
class Pairing {
 public:
  Pairing(std::span<const Eigen::Vector3f> vertices_m, std::span<const Triangle> triangles,
          std::span<const std::array<std::uint32_t, 3>> neighbours)
      : vertices_m_(vertices_m),
        triangles_(triangles),
        neighbours_(neighbours),
        is_paired_(triangles.size()) {
    quads_.reserve(triangles.size());
  }

  std::vector<Quad> make() {
    for (std::size_t longest = 1; longest <= 3; ++longest)
      for (std::uint32_t i = 0; i < triangles_.size(); ++i)
        if (!is_paired_[i]) pair(i, longest);
    for (std::uint32_t i = 0; i < triangles_.size(); ++i)
      if (const Triangle& t = triangles_[i]; !is_paired_[i]) quads_.push_back({t[0], t[1], t[2], t[2]});
    quads_.shrink_to_fit();
    return std::move(quads_);
  }

 private:
  /// Over the longest edge that has a free triangle beyond it, of so many longest edges.
  void pair(std::uint32_t index, std::size_t longest) {
    const Triangle& t = triangles_[index];
    const std::array<std::size_t, 3> edges = longest_first(t);
    for (std::size_t n = 0; n < longest; ++n) {
      const std::size_t edge = edges[n];
      const std::uint32_t other = neighbours_[index][edge];
      if (other == no_neighbour || other == index || is_paired_[other]) continue;
      const std::uint32_t from = t[edge], to = t[(edge + 1) % 3];
      quads_.push_back({t[(edge + 2) % 3], from, opposite(triangles_[other], to), to});
      is_paired_[index] = is_paired_[other] = true;
      return;
    }
  }

  /// Edge k goes from corner k to the next.
  [[nodiscard]] std::array<std::size_t, 3> longest_first(const Triangle& t) const {
    std::array<float, 3> length2;
    for (std::size_t k = 0; k < 3; ++k)
      length2[k] = (vertices_m_[t[(k + 1) % 3]] - vertices_m_[t[k]]).squaredNorm();
    std::array<std::size_t, 3> edges = {0, 1, 2};
    std::sort(edges.begin(), edges.end(), [&](std::size_t a, std::size_t b) {
      return length2[a] != length2[b] ? length2[a] > length2[b] : a < b;
    });
    return edges;
  }

  /// The corner that faces the edge which starts from this one.
  static std::uint32_t opposite(const Triangle& t, std::uint32_t edge_start) {
    const auto k = static_cast<std::size_t>(std::find(t.begin(), t.end(), edge_start) - t.begin());
    return t[(k + 2) % 3];
  }

  std::span<const Eigen::Vector3f> vertices_m_;
  std::span<const Triangle> triangles_;
  std::span<const std::array<std::uint32_t, 3>> neighbours_;
  std::vector<bool> is_paired_;
  std::vector<Quad> quads_;
};

}  // namespace

std::vector<Quad> pair_into_quads(std::span<const Eigen::Vector3f> vertices_m,
                                  std::span<const Triangle> triangles,
                                  std::span<const std::array<std::uint32_t, 3>> neighbours) {
  return Pairing(vertices_m, triangles, neighbours).make();
}

}  // namespace seamline::renderer
