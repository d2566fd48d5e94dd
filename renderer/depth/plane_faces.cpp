#include "renderer/depth/plane_faces.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "renderer/depth/dense_sphere.h"
#include "support/arithmetic/grid_index.h"
#include "support/arithmetic/random.h"

namespace seamline::renderer {
namespace {

constexpr int widest_thin_px = 512;
constexpr int unassigned = -1, given_up = -2;

/// Error of a distance, as a share of the plane's.
double relative_error(const Eigen::Vector3d& inverse, const Eigen::Vector3d& direction, double distance_m) {
  return distance_m * inverse.dot(direction) - 1;  // infinite or negative behind: no support either
}

/// Sums of a least-squares fit of a plane; one step of Gauss and Newton.
class PlaneSums {
 public:
  /// `inverse` is the plane so far.
  void add(const Eigen::Vector3d& inverse, const Eigen::Vector3d& direction, double error) {
    const Eigen::Vector3d slope = direction / inverse.dot(direction);
    squares_ += slope * slope.transpose();
    products_ += slope * error;
    error_squares_ += error * error;
    ++count_;
  }
  [[nodiscard]] std::int64_t count() const { return count_; }
  [[nodiscard]] double rms() const {
    return count_ > 0 ? std::sqrt(error_squares_ / static_cast<double>(count_)) : 0;
  }
  /// Nothing where the texels lie in one line.
  [[nodiscard]] std::optional<Eigen::Vector3d> better(const Eigen::Vector3d& inverse) const {
    if (count_ < 3) return std::nullopt;
    const Eigen::Vector3d change = squares_.ldlt().solve(products_);
    if (!change.allFinite() || change.norm() > inverse.norm()) return std::nullopt;
    return inverse - change;
  }

 private:
  Eigen::Matrix3d squares_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d products_ = Eigen::Vector3d::Zero();
  double error_squares_ = 0;
  std::int64_t count_ = 0;
};

DepthMap thinned(const DepthMap& map) {
  const int step = (map.width_px + widest_thin_px - 1) / widest_thin_px;
  DepthMap thin{.width_px = map.width_px / step, .height_px = map.height_px / step, .distance_m = {}};
  for (int row = 0; row < thin.height_px; ++row)
    for (int column = 0; column < thin.width_px; ++column)
      thin.distance_m.push_back(map.at(column * step + step / 2, row * step + step / 2));
  return thin;
}

class Search {
 public:
  Search(const DepthMap& map, double yaw_texels, const PlaneSearch& how)
      : map_(map),
        yaw_texels_(yaw_texels),
        how_(how),
        step_((map.width_px + widest_thin_px - 1) / widest_thin_px),
        random_(how.seed) {
    out_.thin = thinned(map);
    const DepthMap& thin = out_.thin;
    for (int row = 0; row < thin.height_px; ++row)
      for (int column = 0; column < thin.width_px; ++column) {
        out_.directions.push_back(direction_in_map(column * step_ + step_ / 2, row * step_ + step_ / 2));
        weights_.push_back(texel_solid_angle_sr(row, thin.width_px, thin.height_px) / (4 * std::numbers::pi));
      }
    out_.face_of_texel.assign(thin.distance_m.size(), unassigned);
    for (std::size_t i = 0; i < thin.distance_m.size(); ++i)
      if (is_hole(thin.distance_m[i])) out_.face_of_texel[i] = given_up;
  }

  PlaneFaces run() {
    while (static_cast<int>(out_.faces.size()) < how_.most_faces) {
      const std::optional<Eigen::Vector3d> plane = best_plane();
      if (!plane) break;
      take_faces(*plane);
    }
    fit_to_whole_map();
    for (int& face : out_.face_of_texel) face = std::max(face, -1);
    return std::move(out_);
  }

 private:
  [[nodiscard]] Eigen::Vector3d direction_in_map(int column, int row) const {
    return panorama_direction(column + yaw_texels_ + 0.5, row + 0.5, map_.width_px, map_.height_px);
  }
  [[nodiscard]] double distance_m(std::size_t i) const {
    return static_cast<double>(out_.thin.distance_m[i]);
  }
  [[nodiscard]] bool supports(std::size_t i, const Eigen::Vector3d& inverse, double tolerance) const {
    return std::abs(relative_error(inverse, out_.directions[i], distance_m(i))) <= tolerance;
  }

  /// Three free texels near one another, as a plane.
  [[nodiscard]] std::optional<Eigen::Vector3d> drawn_plane(const std::vector<std::size_t>& free) {
    const DepthMap& thin = out_.thin;
    const std::size_t first = free[static_cast<std::size_t>(random_.below(free.size()))];
    const int row = static_cast<int>(first) / thin.width_px, column = static_cast<int>(first) % thin.width_px;
    const int reach = 4 << static_cast<int>(random_.below(4));
    const double across =
        1 / std::max(0.05, std::cos((0.5 - (row + 0.5) / thin.height_px) * std::numbers::pi));
    Eigen::Matrix3d points;
    points.row(0) = out_.directions[first] * distance_m(first);
    for (int k = 1; k < 3; ++k) {
      const int down = static_cast<int>(random_.below(static_cast<std::uint64_t>(2 * reach + 1))) - reach;
      const int aside = static_cast<int>(std::lround(across * (random_.uniform() * 2 - 1) * reach));
      const int y = std::clamp(row + down, 0, thin.height_px - 1),
                x = (((column + aside) % thin.width_px) + thin.width_px) % thin.width_px;
      const std::size_t at = grid_index(y, x, thin.width_px);
      if (out_.face_of_texel[at] != unassigned) return std::nullopt;
      points.row(k) = out_.directions[at] * distance_m(at);
    }
    const double volume = points.determinant();
    if (std::abs(volume) < 1e-9 * points.row(0).norm() * points.row(1).norm() * points.row(2).norm())
      return std::nullopt;
    const Eigen::Vector3d inverse = points.inverse() * Eigen::Vector3d::Ones();
    return inverse.allFinite() ? std::optional(inverse) : std::nullopt;
  }

  [[nodiscard]] double support(const std::vector<std::size_t>& some, const Eigen::Vector3d& inverse) const {
    double sum = 0;
    for (const std::size_t i : some)
      if (supports(i, inverse, how_.tolerance)) sum += weights_[i];
    return sum;
  }

  /// Fitted to its support among some texels.
  [[nodiscard]] Eigen::Vector3d refitted(const std::vector<std::size_t>& some,
                                         Eigen::Vector3d inverse) const {
    PlaneSums sums;
    for (const std::size_t i : some)
      if (supports(i, inverse, how_.tolerance))
        sums.add(inverse, out_.directions[i], relative_error(inverse, out_.directions[i], distance_m(i)));
    return sums.better(inverse).value_or(inverse);
  }

  /// The plane with the largest support among the free texels; nothing where it is too small.
  [[nodiscard]] std::optional<Eigen::Vector3d> best_plane() {
    std::vector<std::size_t> free, some;
    constexpr std::size_t every = 5;
    for (std::size_t i = 0; i < out_.face_of_texel.size(); ++i)
      if (out_.face_of_texel[i] == unassigned) free.push_back(i);
    for (std::size_t i = 0; i < free.size(); i += every) some.push_back(free[i]);
    if (free.size() < 3) return std::nullopt;
    Eigen::Vector3d best = Eigen::Vector3d::Zero();
    double most = 0;
    for (int draw = 0; draw < how_.draws; ++draw) {
      const auto drawn = drawn_plane(free);
      if (!drawn) continue;
      Eigen::Vector3d plane = *drawn;
      double found = support(some, plane);
      if (found <= 0.5 * most) continue;
      for (int round = 0; round < 3; ++round) {
        const Eigen::Vector3d better = refitted(some, plane);
        const double now = support(some, better);
        if (now <= found) break;
        found = now, plane = better;
      }
      if (found > most) most = found, best = plane;
    }
    if (most * static_cast<double>(every) < how_.least_share) return std::nullopt;
    return refitted(free, refitted(free, best));
  }

  /// Parts the plane's support into connected faces; what is too small is given up.
  void take_faces(const Eigen::Vector3d& inverse) {
    std::vector<char> supporting(out_.face_of_texel.size(), 0);
    for (std::size_t i = 0; i < supporting.size(); ++i)
      supporting[i] = out_.face_of_texel[i] == unassigned && supports(i, inverse, how_.tolerance) ? 1 : 0;
    for (std::size_t i = 0; i < supporting.size(); ++i) {
      if (supporting[i] == 0) continue;
      const std::vector<std::size_t> part = connected(supporting, i);
      double share = 0;
      for (const std::size_t t : part) share += weights_[t];
      const bool is_face = share >= how_.least_share && static_cast<int>(out_.faces.size()) < how_.most_faces;
      for (const std::size_t t : part)
        out_.face_of_texel[t] = is_face ? static_cast<int>(out_.faces.size()) : given_up;
      if (is_face) out_.faces.push_back({.inverse = inverse, .share = share});
    }
  }

  /// The texels connected with one, which are taken out.
  [[nodiscard]] std::vector<std::size_t> connected(std::vector<char>& supporting, std::size_t first) const {
    const int width = out_.thin.width_px, height = out_.thin.height_px;
    std::vector<std::size_t> part = {first};
    supporting[first] = 0;
    for (std::size_t next = 0; next < part.size(); ++next) {
      const int row = static_cast<int>(part[next]) / width, column = static_cast<int>(part[next]) % width;
      for (const auto& [down, right] : {std::pair{0, 1}, {0, -1}, {1, 0}, {-1, 0}}) {
        const int y = row + down, x = (column + right + width) % width;
        if (y < 0 || y >= height) continue;
        const std::size_t at = grid_index(y, x, width);
        if (supporting[at] == 0) continue;
        supporting[at] = 0;
        part.push_back(at);
      }
    }
    return part;
  }

  /// Fits every face to the whole map's texels under its own, with a tolerance that shrinks to three standard
  /// deviations of what is left.
  void fit_to_whole_map() {
    constexpr int rounds = 6;
    constexpr double least_tolerance = 1e-6;
    std::vector<double> tolerance(out_.faces.size(), how_.tolerance);
    const std::vector<int> fitted_face = faces_of_inner_texels();
    for (int round = 0; round < rounds; ++round) {
      const std::vector<PlaneSums> sums = sums_of_whole_map(fitted_face, tolerance);
      for (std::size_t k = 0; k < out_.faces.size(); ++k) {
        PlaneFace& face = out_.faces[k];
        face.fitted_texels = sums[k].count();
        face.inverse = sums[k].better(face.inverse).value_or(face.inverse);
        // After the first round most of what is beyond is another surface.
        tolerance[k] = std::min(how_.tolerance, std::max(least_tolerance, 3 * sums[k].rms()));
      }
    }
  }

  /// The faces of texels that no other face's are near to: at an edge some support both planes. Of a face
  /// that is all edge, all texels.
  [[nodiscard]] std::vector<int> faces_of_inner_texels() const {
    constexpr int near = 2;
    constexpr std::int64_t enough = 50;
    const int width = out_.thin.width_px, height = out_.thin.height_px;
    const auto at = [&](int y, int x) { return grid_index(y, (x + width) % width, width); };
    std::vector<int> inner = out_.face_of_texel;
    std::vector<std::int64_t> count(out_.faces.size(), 0);
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column) {
        const int face = out_.face_of_texel[at(row, column)];
        if (face < 0) continue;
        bool alone = true;
        for (int y = std::max(0, row - near); y <= std::min(height - 1, row + near); ++y)
          for (int x = column - near; x <= column + near; ++x)
            alone = alone && out_.face_of_texel[at(y, x)] == face;
        if (alone)
          ++count[face];
        else
          inner[at(row, column)] = -1;
      }
    for (std::size_t i = 0; i < inner.size(); ++i) {
      const int face = out_.face_of_texel[i];
      if (face >= 0 && count[face] < enough) inner[i] = face;
    }
    return inner;
  }

  [[nodiscard]] std::vector<PlaneSums> sums_of_whole_map(const std::vector<int>& face_of_thin,
                                                         const std::vector<double>& tolerance) const {
    std::vector<PlaneSums> sums(out_.faces.size());
    for (int row = 0; row < out_.thin.height_px * step_; ++row)
      for (int column = 0; column < out_.thin.width_px * step_; ++column) {
        const int face = face_of_thin[grid_index(row / step_, column / step_, out_.thin.width_px)];
        if (face < 0) continue;
        const Eigen::Vector3d direction = direction_in_map(column, row);
        const Eigen::Vector3d& inverse = out_.faces[face].inverse;
        const double error = relative_error(inverse, direction, static_cast<double>(map_.at(column, row)));
        if (std::abs(error) <= tolerance[face]) sums[face].add(inverse, direction, error);
      }
    return sums;
  }

  const DepthMap& map_;
  const double yaw_texels_;
  const PlaneSearch how_;
  const int step_;
  Random random_;
  std::vector<double> weights_;  ///< of the thin map's texels: shares of all directions
  PlaneFaces out_;
};

}  // namespace

PlaneFaces find_plane_faces(const DepthMap& map, double yaw_texels, const PlaneSearch& search) {
  return Search(map, yaw_texels, search).run();
}

}  // namespace seamline::renderer
