#include "registration/calibration/calibrate.h"

#include <fmt/core.h>

#include <Eigen/SVD>
#include <algorithm>
#include <numbers>

#include "registration/calibration/opencv.h"
#include "support/text/error.h"

namespace seamline::registration {
namespace {

void require_boards(const Board& board, const BoardPictures& pictures, const std::string& what) {
  if (pictures.boards.size() < least_boards)
    throw input_error({.field = what,
                       .wanted = fmt::format("at least {} pictures that show the whole board", least_boards),
                       .found = std::to_string(pictures.boards.size())});
  for (const Corners& corners : pictures.boards)
    if (corners.size() != board.corners())
      throw input_error({.field = what,
                         .wanted = fmt::format("{} corners of each board", board.corners()),
                         .found = std::to_string(corners.size())});
}

void add_seen(std::vector<SeenPoint>& seen, const Board& board, const BoardPictures& pictures, int camera) {
  for (std::size_t view = 0; view < pictures.boards.size(); ++view)
    for (std::size_t i = 0; i < board.corners(); ++i)
      seen.push_back({camera, static_cast<int>(view), board.corner_m(i), pictures.boards[view][i]});
}

double angle_rad(const Eigen::Isometry3d& pose) {
  return Eigen::AngleAxisd(Eigen::Matrix3d(pose.linear())).angle();
}

/// From the board counted from its other end to the board.
Eigen::Isometry3d turned_round(const Board& board) {
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  turn.translation() = board.corner_m(board.corners() - 1);
  return turn;
}

/// Points on one line leave a turn about it open; on one point, everything.
bool are_on_a_line(const std::vector<PointPair>& pairs) {
  Eigen::Matrix3Xd points(3, pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = pairs[i].point_m;
  const Eigen::Vector3d middle = points.rowwise().mean();
  points.colwise() -= middle;
  const Eigen::Vector3d spread =
      Eigen::JacobiSVD<Eigen::Matrix3d>(points * points.transpose()).singularValues().cwiseSqrt();
  return !(spread[1] > 1e-4 * spread[0]);
}

}  // namespace

Eigen::Vector3d Board::corner_m(std::size_t i) const {
  const std::size_t width = static_cast<std::size_t>(columns), row = i / width, column = i % width;
  return {square_m * static_cast<double>(column), square_m * static_cast<double>(row), 0};
}

Refined calibrate_camera(const Board& board, const BoardPictures& pictures, const std::string& what) {
  require_boards(board, pictures, what);
  std::vector<SeenPoint> seen;
  add_seen(seen, board, pictures, 0);
  return refine(start_of_camera(board, pictures, what), seen, {.cameras = true}, what);
}

Refined calibrate_two_cameras(const Board& board, const BoardPictures& first, BoardPictures second,
                              const std::string& what) {
  if (first.boards.size() != second.boards.size())
    throw input_error({.field = what,
                       .wanted = "as many boards of one camera as of the other",
                       .found = fmt::format("{} and {}", first.boards.size(), second.boards.size())});
  const Estimate one = calibrate_camera(board, first, what + ", first camera").estimate;
  Estimate other = calibrate_camera(board, second, what + ", second camera").estimate;
  for (std::size_t view = 0; view < second.boards.size(); ++view) {
    Eigen::Isometry3d& pose = other.first_from_view[view];
    if (angle_rad(pose * one.first_from_view[view].inverse()) < std::numbers::pi / 2) continue;
    std::reverse(second.boards[view].begin(), second.boards[view].end());
    pose = pose * turned_round(board);
  }
  Estimate start = one;
  start.cameras.push_back(other.cameras.front());
  start.second_from_first = other.first_from_view.front() * one.first_from_view.front().inverse();
  std::vector<SeenPoint> seen;
  add_seen(seen, board, first, 0);
  add_seen(seen, board, second, 1);
  return refine(start, seen, {.cameras = true, .second_from_first = true}, what);
}

Refined pose_of_pairs(const sensors::PinholeCamera& camera, const std::vector<PointPair>& pairs,
                      const std::string& what) {
  if (pairs.size() < least_pairs)
    throw input_error({.field = what,
                       .wanted = fmt::format("at least {} pairs", least_pairs),
                       .found = std::to_string(pairs.size())});
  if (are_on_a_line(pairs))
    throw input_error({.field = what,
                       .wanted = "points that do not lie on one line",
                       .found = fmt::format("{} on one", pairs.size())});
  std::vector<SeenPoint> seen;
  seen.reserve(pairs.size());
  for (const PointPair& pair : pairs) seen.push_back({0, 0, pair.point_m, pair.position_px});
  Estimate start;
  start.cameras.push_back(camera);
  start.first_from_view.push_back(start_of_pose(camera, pairs, what));
  return refine(start, seen, {.cameras = false}, what);
}

}  // namespace seamline::registration
