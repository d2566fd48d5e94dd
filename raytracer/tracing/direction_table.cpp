#include "raytracer/tracing/direction_table.h"

#include <xmmintrin.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>

#include "raytracer/tracing/cube_cells.h"

namespace seamline::renderer {
namespace {

constexpr std::uint32_t nothing = DirectionTable::nothing;

/// Where many thin triangles meet (sheets over depth jumps) walks are long; on the built-in scenes one in
/// 10,000 is longer than this.
constexpr int most_steps = 48;
/// The triangles around the last ray's are in the nearest cache; a few of them are sooner looked at than the
/// table.
constexpr int steps_from_guess = 8;

using Corners = std::array<Eigen::Vector3d, 3>;

Corners corners_of(const Triangle& t, std::span<const Eigen::Vector3f> vertices_m) {
  return {vertices_m[t[0]].cast<double>(), vertices_m[t[1]].cast<double>(), vertices_m[t[2]].cast<double>()};
}

/// Normals of the planes through the centre and the edges, pointing inwards.
Corners inward_of(const Corners& p) {
  return {p[1].cross(p[0]), p[2].cross(p[1]), p[0].cross(p[2])};
}

CentreTriangle seen_from_centre(const Corners& p, const std::array<std::uint32_t, 3>& neighbours) {
  const Corners inward = inward_of(p);
  CentreTriangle seen{};
  for (std::size_t lane = 0; lane < 3; ++lane) {
    const Eigen::Vector3f of_lane = inward[lane].normalized().cast<float>();
    seen.x[lane] = of_lane.x(), seen.y[lane] = of_lane.y(), seen.z[lane] = of_lane.z();
    seen.set_neighbour(static_cast<int>(lane), neighbours[lane]);
  }
  const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
  seen.plane_per_m = (normal / normal.dot(p[0])).cast<float>();
  seen.plane_distance_m = static_cast<float>(std::abs(normal.dot(p[0])) / normal.norm());
  return seen;
}

bool share_a_corner(const Triangle& a, const Triangle& b) {
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

/// The table while it is filled.
struct Cells {
  std::vector<std::uint32_t> triangle_of_cell = std::vector<std::uint32_t>(cube::cell_count, nothing);
  std::vector<bool> centre_taken = std::vector<bool>(cube::cell_count);
};

/// Writes a triangle into the cells it touches. False when another triangle is there already.
bool enter(std::uint32_t index, const Corners& inward, const Corners& p, std::span<const Triangle> triangles,
           Cells& cells) {
  for (int f = 0; f < 6; ++f) {
    const cube::Face face = cube::face(f);
    if (!cube::may_reach(face, p)) continue;
    const cube::CellRange range = cube::range_of(face, p);
    for (int row = range.first.y(); row <= range.last.y(); ++row)
      for (int column = range.first.x(); column <= range.last.x(); ++column) {
        const cube::Cover cover = cube::cover(face, inward, row, column);
        if (cover == cube::Cover::none) continue;
        const std::size_t cell = cube::cell_index(f, row, column);
        std::uint32_t& entry = cells.triangle_of_cell[cell];
        if (cover == cube::Cover::centre) {
          // A centre on an edge belongs to both sides.
          if (cells.centre_taken[cell] && !share_a_corner(triangles[index], triangles[entry])) return false;
          cells.centre_taken[cell] = true;
          entry = index;
        } else if (entry == nothing) {
          entry = index;
        }
      }
  }
  return true;
}

/// Which triangle each cell's centre lies in, or else one that touches the cell. Empty when triangles turn
/// their back or overlap.
std::vector<std::uint32_t> triangles_of_cells(std::span<const Eigen::Vector3f> vertices_m,
                                              std::span<const Triangle> triangles) {
  Cells cells;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const Corners p = corners_of(triangles[i], vertices_m);
    const Corners inward = inward_of(p);
    if (!(inward[0].dot(p[2]) > 0) || !enter(i, inward, p, triangles, cells)) return {};
  }
  return std::move(cells.triangle_of_cell);
}

/// The edge that a direction is farthest beyond, of those whose bit is set.
int farthest_outside(__m128 product, int edges) {
  if ((edges & (edges - 1)) == 0) return std::countr_zero(static_cast<unsigned>(edges));
  alignas(16) std::array<float, 4> value;
  _mm_store_ps(value.data(), product);
  return static_cast<int>(std::min_element(value.begin(), value.begin() + 3) - value.begin());
}

/// From a triangle over edges to the one that the direction lies in. `not_found` at a hole, or after so many
/// triangles. Within every ray from the centre: a call would cost as much as a step.
[[gnu::always_inline]] inline std::uint32_t walk(const std::vector<CentreTriangle>& triangles,
                                                 std::uint32_t index, const Eigen::Vector3f& direction,
                                                 int most) {
  const __m128 x = _mm_set1_ps(direction.x()), y = _mm_set1_ps(direction.y()), z = _mm_set1_ps(direction.z());
  for (int step = 0; step < most && index != nothing; ++step) {
    const CentreTriangle& t = triangles[index];
    const __m128 product =
        _mm_add_ps(_mm_add_ps(_mm_mul_ps(_mm_load_ps(t.x.data()), x), _mm_mul_ps(_mm_load_ps(t.y.data()), y)),
                   _mm_mul_ps(_mm_load_ps(t.z.data()), z));
    // A bit for each edge that the direction is beyond.
    const int beyond = _mm_movemask_ps(_mm_cmplt_ps(product, _mm_setzero_ps())) & 7;
    if (beyond == 0) return index;
    index = t.neighbour(farthest_outside(product, beyond));
  }
  return DirectionTable::not_found;
}

}  // namespace

std::optional<DirectionTable> make_direction_table(std::span<const Eigen::Vector3f> vertices_m,
                                                   std::span<const Triangle> triangles,
                                                   std::span<const std::array<std::uint32_t, 3>> neighbours) {
  DirectionTable table{triangles_of_cells(vertices_m, triangles), {}};
  if (table.triangle_of_cell.empty()) return std::nullopt;
  table.triangles.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    table.triangles.push_back(seen_from_centre(corners_of(triangles[i], vertices_m), neighbours[i]));
  return table;
}

std::uint32_t find_triangle(const DirectionTable& table, const Eigen::Vector3f& direction,
                            std::uint32_t guess) {
  if (guess != nothing) {
    const std::uint32_t near = walk(table.triangles, guess, direction, steps_from_guess);
    if (near != DirectionTable::not_found) return near;
  }
  const std::uint32_t start = table.triangle_of_cell[cube::cell_of(direction)];
  if (start == nothing) return nothing;
  return walk(table.triangles, start, direction, most_steps);
}

}  // namespace seamline::renderer
