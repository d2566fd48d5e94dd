#include "live/physics/depth_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace seamline::live {
namespace {

constexpr float no_depth = std::numeric_limits<float>::infinity();

bool is_measured(float depth_m) {
  return depth_m != no_depth;
}

/// A line of a grid: a value each `step` from the first on.
struct GridLine {
  float* first;
  std::size_t count, step;

  [[nodiscard]] float& at(std::size_t i) const { return first[i * step]; }
};

/// Between two measured values, of which the second may be missing: then the first goes on, and vice versa.
void bridge(const GridLine& line, std::size_t from, std::size_t to) {
  const bool has_from = from < line.count, has_to = to < line.count;
  const float near = 1 / line.at(has_from ? from : to), far = 1 / line.at(has_to ? to : from);
  const std::size_t begin = has_from ? from + 1 : 0, end = has_to ? to : line.count;
  for (std::size_t i = begin; i < end; ++i) {
    const float share = has_from && has_to ? static_cast<float>(i - from) / static_cast<float>(to - from) : 0;
    line.at(i) = 1 / (near + share * (far - near));
  }
}

/// False where nothing of the line was measured.
bool bridge_line(const GridLine& line) {
  const std::size_t none = line.count;
  std::size_t last = none;
  for (std::size_t i = 0; i < line.count; ++i) {
    if (!is_measured(line.at(i))) continue;
    if (last == none ? i > 0 : i > last + 1) bridge(line, last, i);
    last = i;
  }
  if (last == none) return false;
  if (last + 1 < line.count) bridge(line, last, none);
  return true;
}

/// Twice the area of a triangle seen from above; its sign says which way around.
double turn_from_above(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return (b.z() - a.z()) * (c.x() - a.x()) - (b.x() - a.x()) * (c.z() - a.z());
}

bool is_below(const Eigen::Vector3d& place_m, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
              const Eigen::Vector3d& c) {
  if (std::min({a.x(), b.x(), c.x()}) > place_m.x() || std::max({a.x(), b.x(), c.x()}) < place_m.x() ||
      std::min({a.z(), b.z(), c.z()}) > place_m.z() || std::max({a.z(), b.z(), c.z()}) < place_m.z())
    return false;
  const double whole = turn_from_above(a, b, c);
  if (whole == 0) return false;
  const double of_a = turn_from_above(place_m, b, c) / whole, of_b = turn_from_above(a, place_m, c) / whole,
               of_c = 1 - of_a - of_b;
  constexpr double on_edge = -1e-9;
  return of_a >= on_edge && of_b >= on_edge && of_c >= on_edge &&
         of_a * a.y() + of_b * b.y() + of_c * c.y() < place_m.y();
}

}  // namespace

float quiet_depth_m(const std::vector<float>& depth_m, int width_px, int x, int y) {
  constexpr int reach_px = 2;
  constexpr float same = 0.1F;
  const auto width = static_cast<std::ptrdiff_t>(width_px);
  const std::ptrdiff_t pixel = y * width + x, height = std::ssize(depth_m) / width;
  const float* const here = &depth_m[pixel];
  const float least = *here * (1 - same), most = *here * (1 + same);
  if (!is_measured(*here)) return no_depth;
  const auto right = std::min<std::ptrdiff_t>({reach_px, x, width - 1 - x});
  const auto down = std::min<std::ptrdiff_t>({reach_px, y, height - 1 - y});
  float sum = 1 / *here, count = 1;
  for (std::ptrdiff_t dy = 0; dy <= down; ++dy)
    for (std::ptrdiff_t dx = dy == 0 ? 1 : -right; dx <= right; ++dx) {
      const float one = here[dy * width + dx], other = here[-dy * width - dx];
      if (!(one > least && one < most && other > least && other < most)) continue;
      sum += 1 / one + 1 / other;
      count += 2;
    }
  const bool has_pairs = right > 0 || down > 0;  // all but the picture's four corners
  return count > 1 || !has_pairs ? count / sum : no_depth;
}

bool bridge_holes(std::size_t width, std::vector<float>& depth_m) {
  const std::size_t height = depth_m.size() / width;
  bool has_any = false, lacks_rows = false;
  for (std::size_t row = 0; row < height; ++row) {
    const bool found = bridge_line({&depth_m[row * width], width, 1});
    has_any = has_any || found;
    lacks_rows = lacks_rows || !found;
  }
  if (has_any && lacks_rows)
    for (std::size_t column = 0; column < width; ++column)
      (void)bridge_line({&depth_m[column], height, width});
  return has_any;
}

bool has_surface_below(const renderer::Ground& ground, const Eigen::Vector3d& place_m) {
  return std::any_of(ground.triangles.begin(), ground.triangles.end(), [&](const auto& corners) {
    return is_below(place_m, ground.vertices_m[corners[0]], ground.vertices_m[corners[1]],
                    ground.vertices_m[corners[2]]);
  });
}

DepthGround::DepthGround(const DepthPoints& points, const LocalMeshOptions& options)
    : cut_ratio_(options.cut_ratio), grid_(corner_grid(points, options.most_triangles)) {
  depth_m_.resize(grid_.columns.size() * grid_.rows.size());
  for (std::size_t row = 0; row < grid_.rows.size(); ++row)
    for (std::size_t column = 0; column < grid_.columns.size(); ++column)
      has_ray_.push_back(points.has_ray(grid_.pixel(column, row, points.width_px())) ? 1 : 0);
}

bool DepthGround::read_corners(const DepthPoints& points, const std::vector<float>& depth_m) {
  const std::size_t width = grid_.columns.size();
  for (std::size_t i = 0; i < depth_m_.size(); ++i)
    depth_m_[i] = has_ray_[i] != 0 ? quiet_depth_m(depth_m, points.width_px(), grid_.columns[i % width],
                                                   grid_.rows[i / width])
                                   : no_depth;
  return bridge_holes(width, depth_m_);
}

DepthGround::Change DepthGround::take(const DepthPoints& points, const std::vector<float>& depth_m,
                                      const Eigen::Isometry3d& world_from_colour) {
  if (!read_corners(points, depth_m)) return Change::none;
  const std::size_t width = grid_.columns.size();
  Change change = Change::none;
  ground_.vertices_m.resize(depth_m_.size(), world_from_colour.translation());
  for (std::size_t i = 0; i < depth_m_.size(); ++i) {
    if (has_ray_[i] == 0) continue;
    const std::size_t pixel = grid_.pixel(i % width, i / width, points.width_px());
    const Eigen::Vector3d place_m = world_from_colour * points.point_m(pixel, depth_m_[i]);
    if (place_m != ground_.vertices_m[i]) change = Change::moved;
    ground_.vertices_m[i] = place_m;
  }
  if (!cut_ratio_ && !ground_.triangles.empty()) return change;
  auto triangles = joined();
  if (triangles == ground_.triangles) return change;
  ground_.triangles = std::move(triangles);
  return Change::triangles;
}

std::vector<std::array<std::uint32_t, 3>> DepthGround::joined() const {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(2 * depth_m_.size());
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    if (has_ray_[a] == 0 || has_ray_[b] == 0 || has_ray_[c] == 0) return;
    const auto [nearest, farthest] = std::minmax({depth_m_[a], depth_m_[b], depth_m_[c]});
    if (cut_ratio_ && farthest > *cut_ratio_ * nearest) return;
    triangles.push_back(
        {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
  };
  const std::size_t width = grid_.columns.size();
  for (std::size_t row = 0; row + 1 < grid_.rows.size(); ++row)
    for (std::size_t column = 0; column + 1 < width; ++column) {
      const std::size_t corner = row * width + column;
      add(corner, corner + width, corner + width + 1);
      add(corner, corner + width + 1, corner + 1);
    }
  return triangles;
}

}  // namespace seamline::live
