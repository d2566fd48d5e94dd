#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "registration/calibration/estimate.h"

namespace seamline::registration {

/// A chessboard's inner corners, where four squares meet.
struct Board {
  int columns = 9;
  int rows = 6;
  double square_m = 0.03;

  [[nodiscard]] std::size_t corners() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
  /// The i-th corner, row by row, in the board's own plane.
  [[nodiscard]] Eigen::Vector3d corner_m(std::size_t i) const;
};

/// The corners of one board in one picture, in the board's order; image positions as everywhere here, pixel
/// centres at half integers.
using Corners = std::vector<Eigen::Vector2d>;

/// What one camera saw of the board, picture by picture.
struct BoardPictures {
  int width_px = 0, height_px = 0;
  std::vector<Corners> boards;
};

/// A point of the depth camera's frame and its place in the photograph, as somebody clicked or listed it
/// (paper 000, section 2.2.1), with how far the depth camera trusts the point.
struct PointPair {
  Eigen::Vector2d position_px = Eigen::Vector2d::Zero();
  Eigen::Vector3d point_m = Eigen::Vector3d::Zero();
  double confidence = 1;
};

inline constexpr int least_boards = 3;
inline constexpr int least_pairs = 6;

/// Intrinsics of one camera. Throws InputError naming `what` for fewer than three boards, boards of another
/// number of corners, or boards that leave a parameter undetermined.
[[nodiscard]] Refined calibrate_camera(const Board& board, const BoardPictures& pictures,
                                       const std::string& what);

/// Intrinsics of both cameras and the pose between them, all in one least-squares problem: the i-th boards of
/// both are the same board at the same moment. A detector may begin to count corners at either end of the
/// board; of the two, the one is taken by which the cameras are turned against each other by less than 90
/// degrees. Throws InputError as `calibrate_camera`, and where the numbers of boards differ.
[[nodiscard]] Refined calibrate_two_cameras(const Board& board, const BoardPictures& first,
                                            BoardPictures second, const std::string& what);

/// The pose of the points' frame in a camera whose intrinsics are known: the first (and only) view of the
/// result. Throws InputError naming `what` for fewer than six pairs, points on one line, and points that
/// leave the pose undetermined.
[[nodiscard]] Refined pose_of_pairs(const sensors::PinholeCamera& camera, const std::vector<PointPair>& pairs,
                                    const std::string& what);

}  // namespace seamline::registration
