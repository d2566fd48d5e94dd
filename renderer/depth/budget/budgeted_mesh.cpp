#include "renderer/depth/budget/budgeted_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "renderer/depth/adaptive_mesh.h"
#include "renderer/depth/lattice/grid_triangle_cells.h"
#include "renderer/depth/lattice/refinement.h"
#include "support/arithmetic/grid_index.h"
#include "support/running/parallel.h"

namespace seamline::renderer {
namespace {

/// The columns of each row that lie in a triangle or on its edges: visit(row, first, last).
void for_each_row_inside(const GridTriangle& t, auto visit) {
  const auto [top, bottom] = std::minmax({t[0].row, t[1].row, t[2].row});
  for (int row = top; row <= bottom; ++row) {
    double left = std::numeric_limits<double>::infinity(), right = -left;
    for (std::size_t i = 0; i < 3; ++i) {
      const GridVertex &a = t[i], &b = t[(i + 1) % 3];
      if (std::min(a.row, b.row) > row || std::max(a.row, b.row) < row) continue;
      const double column =
          a.row == b.row
              ? a.column
              : a.column + static_cast<double>((b.column - a.column) * (row - a.row)) / (b.row - a.row);
      left = std::min({left, column, a.row == b.row ? static_cast<double>(b.column) : column});
      right = std::max({right, column, a.row == b.row ? static_cast<double>(b.column) : column});
    }
    constexpr double rounding = 1e-9;
    visit(row, static_cast<int>(std::ceil(left - rounding)), static_cast<int>(std::floor(right + rounding)));
  }
}

/// How wrong triangles of a dense sphere are, times how much that shows.
class Wrongness {
 public:
  Wrongness(const DenseSphere& sphere, const ShownWeights* weights, double yaw_turns)
      : sphere_(sphere), weights_(weights), squared_half_(weights != nullptr ? 1e-4 : 1e-2) {
    if (weights == nullptr) return;
    for (int column = 0; column < sphere.width; ++column) {
      const double turns = (column + 0.5) / sphere.width + yaw_turns;
      column_.push_back(
          std::min(weights->width_px - 1, static_cast<int>((turns - std::floor(turns)) * weights->width_px)));
    }
    for (int row = 0; row < sphere.height; ++row)
      row_.push_back(static_cast<int>(std::int64_t{row} * weights->height_px / sphere.height));
  }

  [[nodiscard]] double of(const GridTriangle& t) const {
    // Along a repeated row: split until nothing is left of it.
    if (twice_area(t) == 0) return std::numeric_limits<double>::infinity();
    Sums sums{};
    const Seen seen(sphere_, t);
    for_each_row_inside(t, [&](int row, int first, int last) {
      for_each_run(first, last, sphere_.width, [&](std::size_t start, int count) {
        for (int i = 0; i < count; ++i) add(seen, row, static_cast<int>(start) + i, sums);
      });
    });
    return shown(sums, uniform_width(t));
  }

 private:
  static constexpr std::size_t everywhere = depth_roles;
  using Sums = std::array<double, depth_roles + 1>;  ///< by role, and without weight

  /// The triangle's plane n.x = 1, or a hole.
  struct Seen {
    Eigen::Vector3d n = Eigen::Vector3d::Zero();
    bool is_hole = false;

    Seen(const DenseSphere& sphere, const GridTriangle& t) {
      std::array<Eigen::Vector3d, 3> p;
      for (std::size_t i = 0; i < 3; ++i) {
        const int column = t[i].column == sphere.width ? 0 : t[i].column;
        is_hole = is_hole || renderer::is_hole(sphere.at(t[i].row, column));
        p[i] = sphere.position_m(t[i].row, column).cast<double>();
      }
      if (is_hole) return;
      const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
      n = normal / normal.dot(p[0]);
      if (!n.allFinite()) n.setZero();  // met nowhere: wrong wherever there is something
    }
  };

  void add(const Seen& seen, int row, int column, Sums& sums) const {
    const float distance_m = sphere_.at(row, column);
    const bool nothing = is_hole(distance_m);
    if (seen.is_hole && nothing) return;
    double wrong = 1;
    if (!seen.is_hole && !nothing) {
      const double inverse_m = seen.n.dot(sphere_.direction(row, column));
      if (inverse_m > 0) {
        const double e = 1 / (inverse_m * static_cast<double>(distance_m)) - 1;
        wrong = e * e / (e * e + squared_half_);
      }
    }
    wrong *= sphere_.cos_elevation[row];
    sums[everywhere] += wrong;
    if (weights_ == nullptr) return;
    const auto& weight = weights_->texels[grid_index(row_[row], column_[column], weights_->width_px)];
    for (std::size_t role = 0; role < depth_roles; ++role)
      sums[role] += wrong * static_cast<double>(weight[role]);
  }

  [[nodiscard]] double shown(const Sums& sums, double width_px) const {
    if (weights_ == nullptr) return sums[everywhere];
    constexpr double leftover = 1e-3;
    double sum = leftover * sums[everywhere];
    for (std::size_t role = 0; role < depth_roles; ++role)
      sum += sums[role] * share_seen(static_cast<DepthRole>(role), width_px);
    return sum;
  }

  /// Of a map that has one sample for two triangles of this size.
  [[nodiscard]] double uniform_width(const GridTriangle& t) const {
    return sphere_.width / std::sqrt(twice_area(t));
  }
  static int twice_area(const GridTriangle& t) {
    return std::abs((t[1].column - t[0].column) * (t[2].row - t[0].row) -
                    (t[2].column - t[0].column) * (t[1].row - t[0].row));
  }

  const DenseSphere& sphere_;
  const ShownWeights* weights_;
  double squared_half_;
  std::vector<int> column_, row_;  ///< of the weights, for each of the sphere
};

/// Splits a lattice until its vertices are as many as the samples.
class Spending {
 public:
  Spending(const DenseSphere& sphere, Lattice& lattice, std::int64_t samples)
      : sphere_(sphere),
        lattice_(lattice),
        left_(samples),
        used_(static_cast<std::size_t>(sphere.width) * static_cast<std::size_t>(sphere.height)) {
    for (int root = 0; root < lattice.root_count(); ++root) {
      const LatticeTriangle t = lattice.root(root);
      for (const LatticePoint& p : {t.apex, t.left, t.right}) use(p);
    }
  }

  /// Splits every leaf, as long as no more than `most` samples are spent.
  void spend_evenly(std::int64_t most) {
    while (2 * spent_ <= most) {
      std::vector<LatticePoint> midpoints;
      for (int root = 0; root < lattice_.root_count(); ++root)
        lattice_.for_each_leaf(lattice_.root(root), [&](const LatticeTriangle& t) {
          if (!t.is_unit()) midpoints.push_back(t.midpoint());
        });
      if (midpoints.empty()) return;
      for (const LatticePoint& p : midpoints) {
        lattice_.split_at(p);
        use(p);
      }
    }
  }

  void spend_where_wrong(const Wrongness& wrongness, int threads) {
    std::vector<std::vector<Candidate>> of_root(static_cast<std::size_t>(lattice_.root_count()));
    run_parallel(lattice_.root_count(), threads, [&](int root) {
      lattice_.for_each_leaf(lattice_.root(root), [&](const LatticeTriangle& t) {
        if (!t.is_unit()) of_root[root].push_back({wrongness.of(grid_triangle(lattice_, t)), t});
      });
    });
    std::priority_queue<Candidate> queue;
    for (const std::vector<Candidate>& candidates : of_root)
      for (const Candidate& candidate : candidates) queue.push(candidate);
    std::vector<LatticePoint> splits;
    // What has no area costs no sample: it has the vertices of its apex.
    while (!queue.empty() && (left_ > 0 || std::isinf(queue.top().wrong))) {
      const LatticePoint p = queue.top().triangle.midpoint();
      queue.pop();
      splits.clear();
      lattice_.list_splits(p, splits);
      if (splits.empty() || count_new(splits) > left_) continue;
      lattice_.split_at(p);
      for (const LatticePoint& split : splits) use(split);
      for (const LatticePoint& split : splits)
        for (const LatticeTriangle& t : lattice_.triangles_of(split))
          for (const LatticeTriangle& half : {LatticeTriangle{t.midpoint(), t.apex, t.left},
                                              LatticeTriangle{t.midpoint(), t.right, t.apex}})
            if (!half.is_unit() && !lattice_.is_split_at(half.midpoint()))
              queue.push({wrongness.of(grid_triangle(lattice_, half)), half});
    }
  }

  void count(BudgetedMesh& made) const {
    for (std::size_t i = 0; i < used_.size(); ++i)
      if (used_[i] != 0) ++(is_hole(sphere_.distance_m[i]) ? made.holes : made.measured);
  }
  /// Mean of the samples of a row that measured something; a hole without any.
  [[nodiscard]] float mean_of_row_m(int row) const {
    double sum_m = 0;
    int count = 0;
    for (int column = 0; column < sphere_.width; ++column)
      if (used_[index({row, column})] != 0 && !is_hole(sphere_.at(row, column)))
        sum_m += static_cast<double>(sphere_.at(row, column)), ++count;
    return count > 0 ? static_cast<float>(sum_m / count) : std::numeric_limits<float>::infinity();
  }

 private:
  /// The most wrong first; of equal ones the upper left one.
  struct Candidate {
    double wrong = 0;
    LatticeTriangle triangle;

    bool operator<(const Candidate& other) const {
      const LatticePoint a = triangle.midpoint(), b = other.triangle.midpoint();
      return std::tuple(wrong, -a.y, -a.x, triangle.apex.y, triangle.apex.x) <
             std::tuple(other.wrong, -b.y, -b.x, other.triangle.apex.y, other.triangle.apex.x);
    }
  };

  [[nodiscard]] std::size_t index(const GridVertex& v) const {
    return grid_index(v.row, v.column == sphere_.width ? 0 : v.column, sphere_.width);
  }
  void use(const LatticePoint& p) {
    std::uint8_t& used = used_[index(lattice_.grid_vertex(p))];
    spent_ += used == 0 ? 1 : 0;
    left_ -= used == 0 ? 1 : 0;
    used = 1;
  }
  [[nodiscard]] std::int64_t count_new(const std::vector<LatticePoint>& points) const {
    return std::count_if(points.begin(), points.end(),
                         [&](const LatticePoint& p) { return used_[index(lattice_.grid_vertex(p))] == 0; });
  }

  const DenseSphere& sphere_;
  Lattice& lattice_;
  std::int64_t left_, spent_ = 0;
  std::vector<std::uint8_t> used_;  ///< 1: the vertex is a sample
};

}  // namespace

BudgetedMesh build_budgeted_mesh(DenseSphere& sphere, std::int64_t samples, const ShownWeights* weights,
                                 double yaw_turns, int threads) {
  Lattice lattice = sphere_lattice(sphere);
  Spending spending(sphere, lattice, samples);
  spending.spend_evenly(samples / 8);
  spending.spend_where_wrong(Wrongness(sphere, weights, yaw_turns), threads);
  sphere.zenith_m = spending.mean_of_row_m(0);
  sphere.nadir_m = spending.mean_of_row_m(sphere.height - 1);
  BudgetedMesh made{.mesh = mesh_of_leaves(sphere, lattice, threads)};
  spending.count(made);
  return made;
}

}  // namespace seamline::renderer
