#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "renderer/depth/dense_sphere.h"
#include "renderer/depth/depth_mesh.h"

/// What the tests of depth meshes share: maps to make them from, and laws that are checked without the code
/// under test.
namespace seamline::test {
using namespace renderer;

inline constexpr float hole = std::numeric_limits<float>::infinity();

inline DepthMap make_map(int width, const std::function<double(int column, int row)>& distance_m) {
  DepthMap map{.width_px = width, .height_px = width / 2, .distance_m = {}, .cleaned_texels = 0};
  for (int row = 0; row < map.height_px; ++row)
    for (int column = 0; column < width; ++column)
      map.distance_m.push_back(static_cast<float>(distance_m(column, row)));
  return map;
}

/// A room of 5 x 3 x 6 m seen from off its middle.
inline DepthMap room_map(int width) {
  return make_map(width, [&](int column, int row) {
    const Eigen::Vector3d d = panorama_direction(column + 0.5, row + 0.5, width, width / 2);
    double t = 1e9;
    const Eigen::Vector3d low(-2.2, -1.5, -3.5), high(2.8, 1.5, 2.5);
    for (int k = 0; k < 3; ++k)
      if (d[k] != 0) t = std::min(t, (d[k] > 0 ? high[k] : low[k]) / d[k]);
    return t;
  });
}

/// Smooth walls, boxes at any distance down to 1e-3 and up to 1e6, holes large and single, all by chance.
inline DepthMap random_map(int width, std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto below = [&](int n) { return static_cast<int>(uniform(0, n)); };
  DepthMap map = uniform(0, 1) < 0.5 ? room_map(width) : make_map(width, [](int, int) { return 2.0; });
  const double bump = uniform(0, 1) < 0.5 ? 0 : std::pow(10, uniform(-5, -1)), waves = uniform(1, 8);
  for (int row = 0; row < map.height_px; ++row)
    for (int column = 0; column < width; ++column)
      map.distance_m[static_cast<std::size_t>(row * width + column)] *=
          static_cast<float>(1 + bump * std::sin(waves * row) * std::cos(waves * column));
  for (int patch = below(5); patch > 0; --patch) {
    const bool is_hole_patch = uniform(0, 1) < 0.4;
    const double factor = std::pow(10, uniform(0, 1) < 0.3 ? uniform(-3.3, 5.5) : uniform(-0.3, 0.3));
    const int left = below(width), top = below(map.height_px), across = 1 + below(width / 2),
              down = 1 + below(map.height_px / 2);
    for (int row = top; row < std::min(map.height_px, top + down); ++row)
      for (int column = left; column < left + across; ++column) {
        float& distance_m = map.distance_m[static_cast<std::size_t>(row * width + column % width)];
        distance_m =
            is_hole_patch
                ? hole
                : static_cast<float>(std::clamp(static_cast<double>(distance_m) * factor, 1e-3, 1e6));
      }
  }
  return map;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// The directed edges that no triangle has the other way round. -1 for an edge that is there twice in one
/// direction.
struct EdgeCount {
  std::vector<Edge> boundary;
  std::size_t edges = 0;  ///< undirected
  bool repeated = false;
};

inline EdgeCount count_edges(const DepthMesh& mesh) {
  std::vector<Edge> directed;
  directed.reserve(mesh.triangles.size() * 3);
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) directed.emplace_back(t[i], t[(i + 1) % 3]);
  std::sort(directed.begin(), directed.end());
  EdgeCount count;
  count.repeated = std::adjacent_find(directed.begin(), directed.end()) != directed.end();
  for (const Edge& edge : directed)
    if (!std::binary_search(directed.begin(), directed.end(), Edge{edge.second, edge.first}))
      count.boundary.push_back(edge);
  count.edges = (directed.size() + count.boundary.size()) / 2;
  return count;
}

/// What rays from the centre through all dense vertices find on a mesh, by brute force in double precision.
struct RayCheck {
  double largest_error =
      0;  ///< |t - r| / r over every triangle a ray touches and of which its vertex is no corner
  int rays_without_hit = 0;  ///< through valid vertices
  int holes_covered = 0;
  int wrong_side = 0;  ///< triangles that do not face the centre
};

inline RayCheck check_rays(const DepthMesh& mesh, const DenseSphere& sphere) {
  struct Prepared {
    std::array<Eigen::Vector3d, 3> inward, corners;
    Eigen::Vector3d normal;
    double offset;
  };
  RayCheck check;
  std::vector<Prepared> prepared;
  for (const auto& t : mesh.triangles) {
    Prepared p;
    for (std::size_t i = 0; i < 3; ++i) p.corners[i] = mesh.vertices_m[t[i]].cast<double>();
    p.normal = (p.corners[1] - p.corners[0]).cross(p.corners[2] - p.corners[0]);
    p.offset = p.normal.dot(p.corners[0]);
    for (std::size_t i = 0; i < 3; ++i)
      p.inward[i] = -p.corners[i].normalized().cross(p.corners[(i + 1) % 3].normalized()).normalized();
    // Anticlockwise from the centre: the centre is on the side the normal points to, and the third corner
    // inside each edge.
    for (std::size_t i = 0; i < 3; ++i)
      if (p.inward[i].dot(p.corners[(i + 2) % 3]) < 0) {
        ++check.wrong_side;
        break;
      }
    prepared.push_back(p);
  }
  constexpr double touching = -1e-7, containing = -1e-6;
  for (int row = 0; row < sphere.height; ++row)
    for (int column = 0; column < sphere.width; ++column) {
      const Eigen::Vector3d d = sphere.direction(row, column);
      const double r = static_cast<double>(sphere.at(row, column));
      bool hit = false;
      for (const Prepared& p : prepared) {
        const double a = p.inward[0].dot(d);
        if (a < containing) continue;
        const double b = p.inward[1].dot(d);
        if (b < containing) continue;
        const double inside = std::min({a, b, p.inward[2].dot(d)});
        if (inside < containing) continue;
        hit = true;
        if (inside < touching) continue;
        if (is_hole(sphere.at(row, column))) {
          ++check.holes_covered;
          continue;
        }
        const bool is_corner =
            std::any_of(p.corners.begin(), p.corners.end(), [&](const Eigen::Vector3d& corner) {
              return corner.normalized().dot(d) > 0 && corner.normalized().cross(d).norm() < 1e-6;
            });
        if (is_corner) continue;
        check.largest_error = std::max(check.largest_error, std::abs(p.offset / p.normal.dot(d) - r) / r);
      }
      if (!hit && !is_hole(sphere.at(row, column))) ++check.rays_without_hit;
    }
  return check;
}

/// Where a ray from the centre hits the mesh, by brute force in double precision; infinity when it does not.
inline double hit_distance_m(const DepthMesh& mesh, const Eigen::Vector3d& direction) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices_m[t[0]].cast<double>(), b = mesh.vertices_m[t[1]].cast<double>(),
                          c = mesh.vertices_m[t[2]].cast<double>();
    if (b.cross(a).dot(direction) < 0 || c.cross(b).dot(direction) < 0 || a.cross(c).dot(direction) < 0)
      continue;
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    nearest_m = std::min(nearest_m, normal.dot(a) / normal.dot(direction));
  }
  return nearest_m;
}

}  // namespace seamline::test
