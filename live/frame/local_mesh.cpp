#include "live/frame/local_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "support/running/parallel.h"

namespace seamline::live {
namespace {

constexpr float no_depth_m = std::numeric_limits<float>::infinity();

/// `count` pixels from the first to the last of `size`.
std::vector<int> spread(int size, int count) {
  std::vector<int> places;
  for (int i = 0; i < count; ++i)
    places.push_back(static_cast<int>(std::lround(static_cast<double>(i) * (size - 1) / (count - 1))));
  return places;
}

/// The fewest pixels from corner to corner that leave so many triangles.
int step_px(int width_px, int height_px, int most_triangles) {
  const auto triangles = [&](int step) { return 2.0 * ((width_px - 1) / step) * ((height_px - 1) / step); };
  int step = 1;
  while (most_triangles > 0 && triangles(step) > most_triangles) ++step;
  return std::min(step, std::min(width_px, height_px) - 1);
}

}  // namespace

CornerGrid corner_grid(const DepthPoints& points, int most_triangles) {
  const int step = step_px(points.width_px(), points.height_px(), most_triangles);
  return {.columns = spread(points.width_px(), (points.width_px() - 1) / step + 1),
          .rows = spread(points.height_px(), (points.height_px() - 1) / step + 1)};
}

LocalMesh::LocalMesh(const DepthPoints& points, const LocalMeshOptions& options)
    : cut_ratio_(options.cut_ratio), grid_(corner_grid(points, options.most_triangles)) {
  depth_m_.resize(grid_.columns.size() * grid_.rows.size());
  mesh_.vertices_m.resize(depth_m_.size());
  mesh_.triangles.reserve(2 * depth_m_.size());
}

void LocalMesh::build(const DepthPoints& points, const std::vector<float>& depth_m,
                      const Eigen::Isometry3d& world_from_colour, int threads) {
  const std::size_t width = grid_.columns.size();
  run_parallel(rows(), threads, [&](int row) {
    for (std::size_t column = 0; column < width; ++column) {
      const std::size_t pixel = grid_.pixel(column, row, points.width_px());
      const std::size_t corner = row * width + column;
      const bool is_there = depth_m[pixel] != no_depth_m && points.has_ray(pixel);
      depth_m_[corner] = is_there ? depth_m[pixel] : no_depth_m;
      mesh_.vertices_m[corner] =
          is_there
              ? Eigen::Vector3f((world_from_colour * points.point_m(pixel, depth_m[pixel])).cast<float>())
              : Eigen::Vector3f(Eigen::Vector3f::Zero());
    }
  });
  mesh_.triangles.clear();
  for (std::size_t row = 0; row + 1 < grid_.rows.size(); ++row)
    for (std::size_t column = 0; column + 1 < width; ++column)
      add_square(static_cast<std::uint32_t>(row * width + column));
}

void LocalMesh::add_square(std::uint32_t upper_left) {
  const auto width = static_cast<std::uint32_t>(grid_.columns.size());
  const std::array<std::uint32_t, 4> corners = {upper_left, upper_left + 1, upper_left + 1 + width,
                                                upper_left + width};
  int holes = 0;
  std::size_t hole = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (depth_m_[corners[i]] == no_depth_m) ++holes, hole = i;
  if (holes > 1) return;
  if (holes == 1) {
    add_triangle(corners[(hole + 1) % 4], corners[(hole + 2) % 4], corners[(hole + 3) % 4]);
    return;
  }
  const float falling = std::abs(depth_m_[corners[0]] - depth_m_[corners[2]]);
  const float rising = std::abs(depth_m_[corners[1]] - depth_m_[corners[3]]);
  const std::size_t start = falling <= rising ? 0 : 1;
  add_triangle(corners[start], corners[start + 1], corners[start + 2]);
  add_triangle(corners[start], corners[start + 2], corners[(start + 3) % 4]);
}

void LocalMesh::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (cut_ratio_) {
    const auto [nearest, farthest] = std::minmax({depth_m_[a], depth_m_[b], depth_m_[c]});
    if (farthest > *cut_ratio_ * nearest) return;
  }
  mesh_.triangles.push_back({a, b, c});
}

}  // namespace seamline::live
