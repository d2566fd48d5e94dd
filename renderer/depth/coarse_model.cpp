#include "renderer/depth/coarse_model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "renderer/depth/dense_sphere.h"
#include "support/arithmetic/grid_index.h"
#include "support/running/parallel.h"

namespace seamline::renderer {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();
constexpr int cells_across = 64;             ///< of a rectangle
constexpr double margin_texels = 1.5;        ///< that a rectangle is larger than what is seen of it
constexpr double right_angle = 0.1;          ///< largest cosine of what counts as one
constexpr double most_looked_through = 0.1;  ///< of what a box explains

double rectangle_m(const ModelRectangle& rectangle, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d normal = rectangle.u_m.cross(rectangle.v_m);
  const double distance_m = normal.dot(rectangle.corner_m) / normal.dot(direction);
  if (!(distance_m > 0) || !std::isfinite(distance_m)) return nowhere;
  const Eigen::Vector3d at = distance_m * direction - rectangle.corner_m;
  const double column = at.dot(rectangle.u_m) / rectangle.u_m.squaredNorm(),
               row = at.dot(rectangle.v_m) / rectangle.v_m.squaredNorm();
  if (!(column >= 0 && column < rectangle.columns && row >= 0 && row < rectangle.rows)) return nowhere;
  return rectangle.is_solid(static_cast<int>(column), static_cast<int>(row)) ? distance_m : nowhere;
}

/// Slab by slab; the centre is outside of every box.
double box_m(const ModelBox& box, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d d = box.axes.transpose() * direction;
  double enters = 0, leaves = nowhere;
  for (int k = 0; k < 3; ++k) {
    if (d[k] == 0) {
      if (box.least_m[k] > 0 || box.most_m[k] < 0) return nowhere;
      continue;
    }
    const auto [first, last] = std::minmax({box.least_m[k] / d[k], box.most_m[k] / d[k]});
    enters = std::max(enters, first), leaves = std::min(leaves, last);
  }
  return enters > 0 && enters <= leaves ? enters : nowhere;
}

/// Builds the model from faces.
class Fit {
 public:
  Fit(const DepthMap& map, double yaw_texels, const PlaneSearch& search)
      : map_(map),
        yaw_texels_(yaw_texels),
        tolerance_(search.tolerance),
        found_(find_plane_faces(map, yaw_texels, search)) {
    texels_of_face_.resize(found_.faces.size());
    for (std::size_t i = 0; i < found_.face_of_texel.size(); ++i)
      if (found_.face_of_texel[i] >= 0)
        texels_of_face_[static_cast<std::size_t>(found_.face_of_texel[i])].push_back(i);
  }

  CoarseModel run() {
    CoarseModel model{.rectangles = {}, .boxes = {}, .tolerance = tolerance_};
    std::vector<char> in_box(found_.faces.size(), 0);
    for (const std::vector<std::size_t>& group : convex_groups())
      if (const auto box = box_of(group)) {
        model.boxes.push_back(*box);
        for (const std::size_t face : group) in_box[face] = 1;
      }
    for (std::size_t face = 0; face < found_.faces.size(); ++face)
      if (in_box[face] == 0) model.rectangles.push_back(rectangle_of(face));
    return model;
  }

 private:
  [[nodiscard]] double texel_rad() const { return std::numbers::pi / found_.thin.height_px; }
  /// The point of a face in a texel's direction.
  [[nodiscard]] Eigen::Vector3d point_m(std::size_t face, std::size_t texel) const {
    const Eigen::Vector3d& direction = found_.directions[texel];
    return found_.faces[face].distance_m(direction) * direction;
  }
  /// How far texels are apart on a face.
  [[nodiscard]] double spacing_m(std::size_t face, std::size_t texel) const {
    const double cosine = std::abs(found_.faces[face].normal().dot(found_.directions[texel]));
    return texel_rad() * found_.faces[face].distance_m(found_.directions[texel]) / std::max(0.03, cosine);
  }
  /// Whether the map saw something behind a face there: in the direction of the nearest texel's centre.
  [[nodiscard]] bool looks_through(std::size_t face, const Eigen::Vector3d& point_m) const {
    const Eigen::Vector3d towards = point_m.normalized();
    const double column =
        (std::atan2(towards.x(), -towards.z()) / (2 * std::numbers::pi) + 0.5) * map_.width_px - yaw_texels_;
    const double row =
        (0.5 - std::asin(std::clamp(towards.y(), -1.0, 1.0)) / std::numbers::pi) * map_.height_px;
    const int x = ((static_cast<int>(std::floor(column)) % map_.width_px) + map_.width_px) % map_.width_px,
              y = std::clamp(static_cast<int>(std::floor(row)), 0, map_.height_px - 1);
    const Eigen::Vector3d seen =
        panorama_direction(x + yaw_texels_ + 0.5, y + 0.5, map_.width_px, map_.height_px);
    const double there_m = found_.faces[face].distance_m(seen);
    return there_m > 0 && static_cast<double>(map_.at(x, y)) > there_m * (1 + 2 * tolerance_);
  }

  /// Faces that belong to one box: at right angles, neighbours, each behind the other's plane.
  [[nodiscard]] std::vector<std::vector<std::size_t>> convex_groups() const {
    std::vector<std::size_t> root(found_.faces.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto find = [&](std::size_t face) {
      while (root[face] != face) face = root[face];
      return face;
    };
    for (const auto& [a, b] : neighbours())
      if (make_an_edge(a, b)) root[std::max(find(a), find(b))] = std::min(find(a), find(b));
    std::vector<std::vector<std::size_t>> groups(found_.faces.size());
    for (std::size_t face = 0; face < root.size(); ++face) groups[find(face)].push_back(face);
    std::erase_if(groups, [](const auto& group) { return group.size() < 2; });
    return groups;
  }

  /// Pairs of faces of which texels within two of each other are near in space too, each pair once.
  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> neighbours() const {
    const int width = found_.thin.width_px, height = found_.thin.height_px;
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column)
        for (const auto& [down, right] : {std::pair{0, 1}, {0, 2}, {1, 0}, {2, 0}}) {
          if (row + down >= height) continue;
          const auto at = [&](int y, int x) { return grid_index(y, x % width, width); };
          const std::size_t one = at(row, column), other = at(row + down, column + right);
          const int a = found_.face_of_texel[one], b = found_.face_of_texel[other];
          if (a < 0 || b < 0 || a == b) continue;
          const auto first = static_cast<std::size_t>(a), second = static_cast<std::size_t>(b);
          const double gap_m = (point_m(first, one) - point_m(second, other)).norm();
          if (gap_m > 3 * (spacing_m(first, one) + spacing_m(second, other))) continue;
          pairs.emplace_back(std::min(first, second), std::max(first, second));
        }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  [[nodiscard]] Eigen::Vector3d middle_m(std::size_t face) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::size_t texel : texels_of_face_[face]) sum += point_m(face, texel);
    return sum / static_cast<double>(texels_of_face_[face].size());
  }

  [[nodiscard]] bool make_an_edge(std::size_t a, std::size_t b) const {
    const Eigen::Vector3d &one = found_.faces[a].inverse, &other = found_.faces[b].inverse;
    return std::abs(one.normalized().dot(other.normalized())) < right_angle && one.dot(middle_m(b)) > 1 &&
           other.dot(middle_m(a)) > 1;
  }

  /// Nothing where a box would stand where the map looks through.
  [[nodiscard]] std::optional<ModelBox> box_of(const std::vector<std::size_t>& group) const {
    const std::size_t largest = *std::max_element(
        group.begin(), group.end(),
        [&](std::size_t a, std::size_t b) { return found_.faces[a].share < found_.faces[b].share; });
    const Eigen::Vector3d first = found_.faces[largest].normal();
    std::optional<Eigen::Vector3d> second;
    for (const std::size_t face : group) {
      const Eigen::Vector3d normal = found_.faces[face].normal();
      if (!second && std::abs(normal.dot(first)) < right_angle)
        second = (normal - normal.dot(first) * first).normalized();
    }
    if (!second) return std::nullopt;
    ModelBox box;
    box.axes.col(0) = first, box.axes.col(1) = *second, box.axes.col(2) = first.cross(*second);
    std::array<std::array<bool, 2>, 3> is_face = {};
    if (!set_extents(group, box, is_face)) return std::nullopt;
    widen(box, is_face);
    const auto [explained, through] = shares_of(box);
    double own = 0;
    for (const std::size_t face : group) own += found_.faces[face].share;
    if (explained < 0.8 * own || through > most_looked_through * explained) return std::nullopt;
    return box;
  }

  /// As far as the faces' texels reach, and to the planes of the faces themselves.
  bool set_extents(const std::vector<std::size_t>& group, ModelBox& box,
                   std::array<std::array<bool, 2>, 3>& is_face) const {
    box.least_m.setConstant(nowhere), box.most_m.setConstant(-nowhere);
    for (const std::size_t face : group)
      for (const std::size_t texel : texels_of_face_[face]) {
        const Eigen::Vector3d at_m = box.axes.transpose() * point_m(face, texel);
        box.least_m = box.least_m.cwiseMin(at_m), box.most_m = box.most_m.cwiseMax(at_m);
      }
    for (const std::size_t face : group) {
      const Eigen::Vector3d turned = box.axes.transpose() * found_.faces[face].normal();
      Eigen::Index axis = 0;
      if (turned.cwiseAbs().maxCoeff(&axis) < 0.99) return false;  // at no right angle to the others
      const double at_m = (box.axes.transpose() * middle_m(face))[axis];
      (turned[axis] > 0 ? box.most_m : box.least_m)[axis] = at_m;
      is_face[axis][turned[axis] > 0 ? 1 : 0] = true;
    }
    return ((box.most_m - box.least_m).array() > 0).all();
  }

  /// Sides that are no face reach a little farther where nothing is looked through for it: to the floor.
  void widen(ModelBox& box, const std::array<std::array<bool, 2>, 3>& is_face) const {
    const double margin_m =
        margin_texels * texel_rad() * (box.axes * (0.5 * (box.least_m + box.most_m))).norm();
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        if (is_face[axis][side]) continue;
        ModelBox wider = box;
        (side == 1 ? wider.most_m : wider.least_m)[axis] += side == 1 ? margin_m : -margin_m;
        if (shares_of(wider).second <= shares_of(box).second) box = wider;
      }
  }

  /// Shares of all directions that a box explains, and in which the map looks through it.
  [[nodiscard]] std::pair<double, double> shares_of(const ModelBox& box) const {
    double explained = 0, through = 0;
    for (std::size_t i = 0; i < found_.directions.size(); ++i) {
      const double there_m = box_m(box, found_.directions[i]);
      if (there_m == nowhere) continue;
      const double seen_m = static_cast<double>(found_.thin.distance_m[i]);
      const double weight = texel_solid_angle_sr(static_cast<int>(i) / found_.thin.width_px,
                                                 found_.thin.width_px, found_.thin.height_px) /
                            (4 * std::numbers::pi);
      if (std::abs(seen_m - there_m) <= tolerance_ * there_m) explained += weight;
      if (seen_m > there_m * (1 + 2 * tolerance_)) through += weight;
    }
    return {explained, through};
  }

  /// Level in u where the face is not: seen along the largest upright face.
  [[nodiscard]] Eigen::Vector3d along(std::size_t face) const {
    const Eigen::Vector3d up = Eigen::Vector3d::UnitY(), normal = found_.faces[face].normal();
    constexpr double level = 0.9;
    const auto side = [&](const Eigen::Vector3d& n) { return up.cross(n); };
    if (std::abs(normal.y()) < level) return side(normal).normalized();
    for (const PlaneFace& other : found_.faces)
      if (std::abs(other.normal().y()) < level) {
        const Eigen::Vector3d u = side(other.normal());
        return (u - u.dot(normal) * normal).normalized();
      }
    return (Eigen::Vector3d::UnitX() - normal.x() * normal).normalized();
  }

  [[nodiscard]] ModelRectangle rectangle_of(std::size_t face) const {
    const Eigen::Vector3d u = along(face), v = found_.faces[face].normal().cross(u);
    double left = nowhere, right = -nowhere, low = nowhere, high = -nowhere;
    for (const std::size_t texel : texels_of_face_[face]) {
      const Eigen::Vector3d at_m = point_m(face, texel);
      const double margin_m = margin_texels * spacing_m(face, texel);
      left = std::min(left, at_m.dot(u) - margin_m), right = std::max(right, at_m.dot(u) + margin_m);
      low = std::min(low, at_m.dot(v) - margin_m), high = std::max(high, at_m.dot(v) + margin_m);
    }
    const Eigen::Vector3d foot_m = found_.faces[face].inverse / found_.faces[face].inverse.squaredNorm();
    ModelRectangle rectangle{.corner_m = foot_m + left * u + low * v,
                             .u_m = (right - left) / cells_across * u,
                             .v_m = (high - low) / cells_across * v,
                             .columns = cells_across,
                             .rows = cells_across,
                             .solid = {}};
    for (int row = 0; row < cells_across; ++row)
      for (int column = 0; column < cells_across; ++column) {
        int through = 0;
        for (const auto& [x, y] : {std::pair{0.5, 0.5}, {0.1, 0.1}, {0.9, 0.1}, {0.1, 0.9}, {0.9, 0.9}})
          through += looks_through(
                         face, rectangle.corner_m + (column + x) * rectangle.u_m + (row + y) * rectangle.v_m)
                         ? 1
                         : 0;
        rectangle.solid.push_back(through < 3 ? 1 : 0);
      }
    return rectangle;
  }

  const DepthMap& map_;
  const double yaw_texels_, tolerance_;
  const PlaneFaces found_;
  std::vector<std::vector<std::size_t>> texels_of_face_;
};

void add_quad(DepthMesh& mesh, const std::array<Eigen::Vector3d, 4>& corners_m) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices_m.size());
  for (const Eigen::Vector3d& corner_m : corners_m) mesh.vertices_m.push_back(corner_m.cast<float>());
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

/// Cells of a rectangle in as few pieces as runs of equal rows allow.
void add_rectangle(DepthMesh& mesh, const ModelRectangle& rectangle) {
  const auto row_of = [&](int row) {
    const auto first = rectangle.solid.begin() + static_cast<std::ptrdiff_t>(row) * rectangle.columns;
    return std::vector<std::uint8_t>(first, first + rectangle.columns);
  };
  for (int top = 0, bottom = 0; top < rectangle.rows; top = bottom) {
    const std::vector<std::uint8_t> cells = row_of(top);
    for (bottom = top + 1; bottom < rectangle.rows && row_of(bottom) == cells;) ++bottom;
    for (int left = 0, right = 0; left < rectangle.columns; left = right) {
      const std::uint8_t solid = cells[left];
      for (right = left + 1; right < rectangle.columns && cells[right] == solid;) ++right;
      if (solid == 0) continue;
      const auto at = [&](int column, int row) -> Eigen::Vector3d {
        return rectangle.corner_m + column * rectangle.u_m + row * rectangle.v_m;
      };
      add_quad(mesh, {at(left, top), at(right, top), at(right, bottom), at(left, bottom)});
    }
  }
}

void add_box(DepthMesh& mesh, const ModelBox& box) {
  const auto at = [&](const Eigen::Vector3d& share) -> Eigen::Vector3d {
    return box.axes * (box.least_m + share.cwiseProduct(box.most_m - box.least_m));
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {0, 1}) {
      Eigen::Vector3d across = Eigen::Vector3d::Zero(), up = across, from = across;
      from[axis] = side;
      across[(axis + 1 + (side == 1 ? 0 : 1)) % 3] = 1;
      up[(axis + 1 + (side == 1 ? 1 : 0)) % 3] = 1;
      add_quad(mesh, {at(from), at(from + across), at(from + across + up), at(from + up)});
    }
}

}  // namespace

CoarseModel fit_coarse_model(const DepthMap& map, double yaw_texels, const PlaneSearch& search) {
  return Fit(map, yaw_texels, search).run();
}

double distance_m(const CoarseModel& model, const Eigen::Vector3d& direction) {
  double nearest_m = nowhere;
  for (const ModelRectangle& rectangle : model.rectangles)
    nearest_m = std::min(nearest_m, rectangle_m(rectangle, direction));
  for (const ModelBox& box : model.boxes) nearest_m = std::min(nearest_m, box_m(box, direction));
  return nearest_m;
}

bool explains(const CoarseModel& model, const Eigen::Vector3d& direction, float measured_m) {
  if (is_hole(measured_m)) return false;
  const double there_m = distance_m(model, direction);
  return std::abs(static_cast<double>(measured_m) - there_m) <= model.tolerance * there_m &&
         there_m != nowhere;
}

ModelRecord judge(const CoarseModel& model, const DepthMap& map, double yaw_texels, int threads) {
  struct Row {
    double measured = 0, explained = 0, squares = 0;
  };
  std::vector<Row> rows(static_cast<std::size_t>(map.height_px));
  run_parallel(map.height_px, threads, [&](int row) {
    Row& sums = rows[row];
    const double weight = texel_solid_angle_sr(row, map.width_px, map.height_px);
    for (int column = 0; column < map.width_px; ++column) {
      const float measured_m = map.at(column, row);
      if (is_hole(measured_m)) continue;
      sums.measured += weight;
      const Eigen::Vector3d direction =
          panorama_direction(column + yaw_texels + 0.5, row + 0.5, map.width_px, map.height_px);
      if (!explains(model, direction, measured_m)) continue;
      sums.explained += weight;
      const double there_m = distance_m(model, direction);
      const double error = static_cast<double>(measured_m) / there_m - 1;
      sums.squares += weight * error * error;
    }
  });
  Row all;
  for (const Row& row : rows)
    all.measured += row.measured, all.explained += row.explained, all.squares += row.squares;
  return {.planes = static_cast<int>(model.rectangles.size()),
          .boxes = static_cast<int>(model.boxes.size()),
          .explained_share = all.measured > 0 ? all.explained / all.measured : 0,
          .relative_residual = all.explained > 0 ? std::sqrt(all.squares / all.explained) : 0};
}

DepthMesh model_mesh(const CoarseModel& model) {
  DepthMesh mesh;
  for (const ModelRectangle& rectangle : model.rectangles) add_rectangle(mesh, rectangle);
  for (const ModelBox& box : model.boxes) add_box(mesh, box);
  return mesh;
}

}  // namespace seamline::renderer
