#include "registration/mesh/depth_grid.h"

#include <algorithm>
#include <cmath>

namespace seamline::registration {
namespace {

constexpr std::size_t left = 0, right = 1, top = 2, bottom = 3;

/// Where a side of the picture leads.
Eigen::Vector2i outwards_of(std::size_t side) {
  const int way = side == left || side == top ? -1 : 1;
  return side == left || side == right ? Eigen::Vector2i(way, 0) : Eigen::Vector2i(0, way);
}

/// The point at the depth of a pixel, on the ray through an image position that may lie outside the picture.
/// Beyond it the camera is continued as a pinhole, because its lens was never calibrated there.
std::optional<Eigen::Vector3d> point_beyond(const sensors::DepthFrame& measured, const Eigen::Vector2i& pixel,
                                            const Eigen::Vector2d& position_px) {
  const Eigen::Vector2d centre = pixel.cast<double>() + Eigen::Vector2d::Constant(0.5);
  auto direction = sensors::direction_through(measured.camera, centre);
  if (!direction) return std::nullopt;
  const Eigen::Vector2d step = position_px - centre;
  const double dy = step.y() / measured.camera.fy_px;
  direction->x() += (step.x() - measured.camera.skew_px * dy) / measured.camera.fx_px;
  direction->y() += dy;
  if (measured.convention == sensors::DepthConvention::radial) direction->normalize();
  return *direction * static_cast<double>(measured.at(pixel.x(), pixel.y()));
}

}  // namespace

/// The outermost depth of a row or column, and its continuation.
struct DepthGrid::Edge {
  Eigen::Vector2i pixel{-1, -1};
  int outer = -1;  ///< index of the corner beyond the picture; -1: none

  [[nodiscard]] bool is_there() const { return outer >= 0; }
};

DepthGrid::DepthGrid(const sensors::DepthFrame& measured, const Eigen::Isometry3d& colour_from_depth,
                     const MeshRegistration& mesh, std::span<const std::uint8_t> invented)
    : width_px_(measured.camera.width_px), height_px_(measured.camera.height_px) {
  if (mesh.jumps != Jumps::stretch) largest_ratio_ = mesh.jump_ratio;
  const std::vector<Eigen::Vector3d> points_m =
      points_in_colour_frame(measured, colour_from_depth, mesh.threads);
  corners_.reserve(points_m.size());
  for (std::size_t i = 0; i < points_m.size(); ++i)
    corners_.push_back({points_m[i], measured.depth_m[i], !invented.empty() && invented[i] != 0});
  if (mesh.border_extrusion_px > 0) extrude(measured, colour_from_depth, mesh.border_extrusion_px);
}

const Corner* DepthGrid::at(int column, int row) const {
  const Corner& corner = corners_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_px_) +
                                  static_cast<std::size_t>(column)];
  return corner.point_m.allFinite() ? &corner : nullptr;
}

bool DepthGrid::is_cut(const Triangle& triangle) const {
  if (!largest_ratio_) return false;
  const auto [nearest, farthest] =
      std::minmax({triangle[0]->depth_m, triangle[1]->depth_m, triangle[2]->depth_m});
  return static_cast<double>(farthest) > *largest_ratio_ * static_cast<double>(nearest);
}

void DepthGrid::each_of_square(const Square& square, const std::function<void(const Triangle&)>& take) const {
  const auto holes = std::count(square.begin(), square.end(), nullptr);
  if (holes > 1) return;
  const auto give = [&](const Triangle& triangle) {
    if (!is_cut(triangle)) take(triangle);
  };
  if (holes == 1) {
    const std::size_t hole =
        static_cast<std::size_t>(std::find(square.begin(), square.end(), nullptr) - square.begin());
    give({square[(hole + 1) % 4], square[(hole + 2) % 4], square[(hole + 3) % 4]});
    return;
  }
  const auto difference = [&](std::size_t i, std::size_t j) {
    return std::abs(square[i]->depth_m - square[j]->depth_m);
  };
  const std::size_t start = difference(0, 2) <= difference(1, 3) ? 0 : 1;  // a corner of the diagonal
  give({square[start], square[start + 1], square[start + 2]});
  give({square[start], square[start + 2], square[(start + 3) % 4]});
}

void DepthGrid::each_measured(int row, const std::function<void(const Triangle&)>& take) const {
  for (int column = 0; column + 1 < width_px_; ++column)
    each_of_square({at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)},
                   take);
}

void DepthGrid::each_extruded(const std::function<void(const Triangle&)>& take) const {
  for (const Square& square : extruded_) each_of_square(square, take);
}

void DepthGrid::extrude(const sensors::DepthFrame& measured, const Eigen::Isometry3d& colour_from_depth,
                        int reach_px) {
  const Eigen::Vector2i size(width_px_, height_px_);
  // A corner beyond the picture: `outwards` has a side's direction, or for the picture's own corners both.
  const auto add_outer = [&](const Eigen::Vector2i& pixel, const Eigen::Vector2i& outwards) {
    Eigen::Vector2d position = pixel.cast<double>() + Eigen::Vector2d::Constant(0.5);
    for (int axis = 0; axis < 2; ++axis)
      if (outwards[axis] != 0) position[axis] = outwards[axis] < 0 ? -reach_px : size[axis] + reach_px;
    const auto point_m = point_beyond(measured, pixel, position);
    if (!point_m) return -1;
    const Corner* inner = at(pixel.x(), pixel.y());
    outer_.push_back({colour_from_depth * *point_m, inner->depth_m, inner->invented});
    return static_cast<int>(outer_.size()) - 1;
  };
  const auto edges_of = [&](const Eigen::Vector2i& outwards) {
    const int across = outwards.x() != 0 ? 0 : 1, along = 1 - across;
    std::vector<Edge> edges(static_cast<std::size_t>(size[along]));
    for (int line = 0; line < size[along]; ++line)
      for (int depth = 0; depth < std::min(reach_px, size[across]); ++depth) {
        Eigen::Vector2i pixel;
        pixel[along] = line;
        pixel[across] = outwards[across] < 0 ? depth : size[across] - 1 - depth;
        if (at(pixel.x(), pixel.y()) == nullptr) continue;
        edges[static_cast<std::size_t>(line)] = {pixel, add_outer(pixel, outwards)};
        break;
      }
    return edges;
  };
  std::array<std::vector<Edge>, 4> edges;
  for (const std::size_t side : {left, right, top, bottom}) edges[side] = edges_of(outwards_of(side));

  struct Patch {
    Eigen::Vector2i first, second;  ///< pixels of the picture; the same at its corners
    std::array<int, 3> outer;       ///< after `second`, round the square; -1 in the middle: none
  };
  std::vector<Patch> patches;
  for (const std::vector<Edge>& side : edges)
    for (std::size_t i = 0; i + 1 < side.size(); ++i)
      if (side[i].is_there() && side[i + 1].is_there())
        patches.push_back({side[i].pixel, side[i + 1].pixel, {side[i + 1].outer, -1, side[i].outer}});
  for (const std::size_t across : {left, right})
    for (const std::size_t along : {top, bottom}) {
      const Edge& beside = along == top ? edges[across].front() : edges[across].back();
      if (!beside.is_there()) continue;
      const Edge& above = edges[along][static_cast<std::size_t>(beside.pixel.x())];
      if (!above.is_there()) continue;
      const int corner = add_outer(beside.pixel, outwards_of(across) + outwards_of(along));
      if (corner >= 0) patches.push_back({beside.pixel, beside.pixel, {beside.outer, corner, above.outer}});
    }
  // Only now, because addresses change while corners are added.
  const auto outer = [&](int index) { return &outer_[static_cast<std::size_t>(index)]; };
  for (const Patch& patch : patches) {
    const Corner* first = at(patch.first.x(), patch.first.y());
    if (patch.outer[1] < 0)
      extruded_.push_back(
          {first, at(patch.second.x(), patch.second.y()), outer(patch.outer[0]), outer(patch.outer[2])});
    else
      extruded_.push_back({first, outer(patch.outer[0]), outer(patch.outer[1]), outer(patch.outer[2])});
  }
}

}  // namespace seamline::registration
