#include "renderer/depth/adaptive_mesh_bound.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "renderer/depth/lattice/grid_triangle_cells.h"

namespace seamline::renderer {

struct TriangleBound::Spread {
  double smallest = 1, largest = 1;
  void add(double q) {
    smallest = q < smallest ? q : smallest;
    largest = q > largest ? q : largest;
  }
};

/// n of the plane n.x = 1; along the ray of (row, column) n.d = sine * sin(azimuth) + cosine * cos(azimuth) +
/// constant.
struct TriangleBound::Plane {
  Eigen::Vector3d n;

  Plane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    n = normal / normal.dot(a);
  }
  [[nodiscard]] bool exists() const { return n.allFinite(); }

  struct InRow {
    double sine, cosine, constant;
  };
  [[nodiscard]] InRow in_row(const DenseSphere& sphere, int row) const { return in_row(n, sphere, row); }
  static InRow in_row(const Eigen::Vector3d& n, const DenseSphere& sphere, int row) {
    const double cos_elevation = sphere.cos_elevation[row];
    return {n.x() * cos_elevation, -n.z() * cos_elevation, n.y() * sphere.sin_elevation[row]};
  }
};

/// The great circles of the edges and the box of the grid that holds everything between them.
struct TriangleBound::Outline {
  std::array<Eigen::Vector3d, 3> inward;  ///< unit normals: inside where all products are positive
  double margin = 0;                      ///< one cell's diagonal, so that cells covered in part are inside
  int first_column = 0, last_column = 0;
};

namespace {

constexpr int lanes = 4;

struct GridBox {
  int top, bottom, left, right;
};

GridBox box_of(const GridTriangle& t) {
  const auto [top, bottom] = std::minmax({t[0].row, t[1].row, t[2].row});
  const auto [left, right] = std::minmax({t[0].column, t[1].column, t[2].column});
  return {top, bottom, left, right};
}

/// How far, in cells, the straight edges stray from the lines of the grid: to second order n^2 h / 8 (2 cot
/// theta + 1/2) for n cells of h radians at theta from the pole.
double straying_cells(const GridBox& box, const DenseSphere& sphere) {
  const bool zenith_is_nearer = box.top < sphere.height - 1 - box.bottom;
  const auto row = static_cast<std::size_t>(zenith_is_nearer ? box.top : box.bottom);
  const double cot_from_pole = std::abs(sphere.sin_elevation[row]) / sphere.cos_elevation[row];
  const double n = std::max(box.bottom - box.top, box.right - box.left);
  return n * n * std::numbers::pi / sphere.height / 8 * (2 * cot_from_pole + 0.5);
}

/// Rows that the edges may rise above a row at `from_pole` rows (counted from the pole, at half integers)
/// towards the pole.
int bulge_rows(double from_pole, int columns, int height) {
  const double cell_rad = std::numbers::pi / height, half_span_rad = columns * cell_rad / 2;
  const double from_pole_rad = from_pole * cell_rad;
  if (from_pole_rad >= std::numbers::pi / 2) return 0;
  return static_cast<int>((from_pole_rad - std::atan(std::tan(from_pole_rad) * std::cos(half_span_rad))) /
                          cell_rad);
}

/// Not inlined: GCC 12 vectorises double -> float -> double into nothing, and the bound would be judged by
/// corners that the mesh does not have.
[[gnu::noinline]] Eigen::Vector3f rounded_position_m(const DenseSphere& sphere, int row, int column) {
  return sphere.position_m(row, column);
}

}  // namespace

TriangleBound::TriangleBound(const DenseSphere& sphere, double tolerance) : sphere_(sphere) {
  const double e = std::max(0.0, tolerance) * (1 - 1e-9);  // the rounding of q stays under the bound
  smallest_q_ = 1 / (1 + e);
  largest_q_ =
      e < 1 ? 1 / (1 - e) : std::numeric_limits<double>::max();  // infinity is a hole and must not pass
}

bool TriangleBound::within(const Spread& spread) const {
  return spread.smallest >= smallest_q_ && spread.largest <= largest_q_;
}

Eigen::Vector3d TriangleBound::corner_m(const GridVertex& v) const {
  return rounded_position_m(sphere_, v.row, v.column == sphere_.width ? 0 : v.column).cast<double>();
}

bool TriangleBound::holds(const GridTriangle& t) const {
  // Repeated columns or rows can leave a triangle without area; it must be split until nothing is left of it.
  const int area = (t[1].column - t[0].column) * (t[2].row - t[0].row) -
                   (t[2].column - t[0].column) * (t[1].row - t[0].row);
  if (area == 0) return false;
  int holes = 0;
  for (const GridVertex& v : t)
    holes += is_hole(sphere_.at(v.row, v.column == sphere_.width ? 0 : v.column)) ? 1 : 0;
  if (holes > 0) return holes == 3 && is_one_hole(t);
  return within(spread_under(t));
}

double TriangleBound::largest_error(const GridTriangle& t) const {
  if (is_hole(sphere_.at(t[0].row, t[0].column == sphere_.width ? 0 : t[0].column))) return 0;
  const Spread spread = spread_under(t);
  return std::max(1 / spread.smallest - 1, 1 - 1 / spread.largest);
}

bool TriangleBound::is_one_hole(const GridTriangle& t) const {
  const GridBox box = box_of(t);
  bool all = true;
  for (int row = box.top; row <= box.bottom && all; ++row)
    for_each_run(box.left, box.right, sphere_.width, [&](std::size_t start, int count) {
      const float* r =
          &sphere_.distance_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(sphere_.width)] +
          start;
      for (int i = 0; i < count; ++i) all = all && is_hole(r[i]);
    });
  return all;
}

/// The spread of q under the triangle; where it leaves the bound, the rest is not looked at.
TriangleBound::Spread TriangleBound::spread_under(const GridTriangle& t) const {
  Spread spread;
  const std::array<Eigen::Vector3d, 3> p = {corner_m(t[0]), corner_m(t[1]), corner_m(t[2])};
  const Plane plane(p[0], p[1], p[2]);
  if (!plane.exists()) return {.smallest = 0};

  // Most triangles that fail, fail at the midpoint of the longest edge.
  const GridVertex middle{(t[1].row + t[2].row) / 2, (t[1].column + t[2].column) / 2};
  scan(plane, middle.row, middle.column, middle.column, spread);
  if (!within(spread)) return spread;

  const GridBox box = box_of(t);
  if (straying_cells(box, sphere_) < 0.5) {
    for_each_row(t, [&](int row, int first, int last) {
      scan(plane, row, first, last, spread);
      return within(spread);
    });
  } else {
    Outline outline{.inward = {},
                    .margin = std::numbers::sqrt2 * std::numbers::pi / sphere_.height,
                    .first_column = box.left,
                    .last_column = box.right};
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d inward = p[i].cross(p[(i + 1) % 3]).normalized();
      outline.inward[i] = inward.dot(p[(i + 2) % 3]) < 0 ? Eigen::Vector3d(-inward) : inward;
    }
    const int above = bulge_rows(box.top + 0.5, box.right - box.left, sphere_.height);
    const int below = bulge_rows(sphere_.height - 0.5 - box.bottom, box.right - box.left, sphere_.height);
    const int first = std::max(0, box.top - above), last = std::min(sphere_.height - 1, box.bottom + below);
    for (int row = first; row <= last && within(spread); ++row) scan_inside(plane, outline, row, spread);
  }
  if (box.top == 0 && !is_hole(sphere_.zenith_m)) scan_pole(t, 0, sphere_.zenith_m, spread);
  if (box.bottom == sphere_.height - 1 && !is_hole(sphere_.nadir_m))
    scan_pole(t, box.bottom, -static_cast<double>(sphere_.nadir_m), spread);
  return spread;
}

/// When the triangle has an edge along the row next to a pole, the pole's fan is as coarse as this edge: it
/// is tested like the triangle.
void TriangleBound::scan_pole(const GridTriangle& t, int row, double pole_y_m, Spread& spread) const {
  if (!within(spread)) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const GridVertex &a = t[i], &b = t[(i + 1) % 3];
    if (a.row != row || b.row != row) continue;
    const Plane plane({0, pole_y_m, 0}, corner_m(a), corner_m(b));
    if (!plane.exists())
      spread.smallest = 0;
    else
      scan(plane, row, std::min(a.column, b.column), std::max(a.column, b.column), spread);
  }
}

void TriangleBound::scan(const Plane& plane, int row, int first, int last, Spread& spread) const {
  const Plane::InRow k = plane.in_row(sphere_, row);
  const float* row_m =
      sphere_.distance_m.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(sphere_.width);
  for_each_run(first, last, sphere_.width, [&](std::size_t start, int count) {
    const float* r = row_m + start;
    const double *sine = sphere_.sin_azimuth.data() + start, *cosine = sphere_.cos_azimuth.data() + start;
    const auto q = [&](int i) {
      return static_cast<double>(r[i]) * (k.sine * sine[i] + k.cosine * cosine[i] + k.constant);
    };
    int i = 0;
    if (count >= 2 * lanes) {
      double smallest[lanes], largest[lanes];
      for (int l = 0; l < lanes; ++l) smallest[l] = largest[l] = 1;
      for (; i + lanes <= count; i += lanes)
        for (int l = 0; l < lanes; ++l) {
          const double value = q(i + l);
          smallest[l] = value < smallest[l] ? value : smallest[l];
          largest[l] = value > largest[l] ? value : largest[l];
        }
      for (int l = 0; l < lanes; ++l) spread.add(smallest[l]), spread.add(largest[l]);
    }
    for (; i < count; ++i) spread.add(q(i));
  });
}

void TriangleBound::scan_inside(const Plane& plane, const Outline& outline, int row, Spread& spread) const {
  const Plane::InRow k = plane.in_row(sphere_, row);
  const Plane::InRow e0 = Plane::in_row(outline.inward[0], sphere_, row);
  const Plane::InRow e1 = Plane::in_row(outline.inward[1], sphere_, row);
  const Plane::InRow e2 = Plane::in_row(outline.inward[2], sphere_, row);
  const double outside = -outline.margin;
  const float* row_m =
      sphere_.distance_m.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(sphere_.width);
  for_each_run(outline.first_column, outline.last_column, sphere_.width, [&](std::size_t start, int count) {
    const float* r = row_m + start;
    const double *sine = sphere_.sin_azimuth.data() + start, *cosine = sphere_.cos_azimuth.data() + start;
    const auto product = [&](const Plane::InRow& v, int i) {
      return v.sine * sine[i] + v.cosine * cosine[i] + v.constant;
    };
    const auto q = [&](int i) {
      const double a = product(e0, i), b = product(e1, i), c = product(e2, i);
      const double ab = a < b ? a : b, abc = ab < c ? ab : c;
      const double value = static_cast<double>(r[i]) * product(k, i);
      return abc < outside ? 1.0 : value;
    };
    double smallest[lanes], largest[lanes];
    for (int l = 0; l < lanes; ++l) smallest[l] = largest[l] = 1;
    int i = 0;
    for (; i + lanes <= count; i += lanes)
      for (int l = 0; l < lanes; ++l) {
        const double value = q(i + l);
        smallest[l] = value < smallest[l] ? value : smallest[l];
        largest[l] = value > largest[l] ? value : largest[l];
      }
    for (int l = 0; l < lanes; ++l) spread.add(smallest[l]), spread.add(largest[l]);
    for (; i < count; ++i) spread.add(q(i));
  });
}

}  // namespace seamline::renderer
