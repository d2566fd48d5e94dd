#pragma once
#include <string>

#include "sensors/rig/rig.h"
#include "support/arithmetic/random.h"
#include "support/files/image.h"

/// Pictures of a chessboard that cameras of a known rig take.
namespace seamline::test {

/// A board of so many squares, with a white border, on grey.
struct Board {
  int columns = 8, rows = 6;
  double square_m = 0.04;
};

/// Every pixel is the mean of 4 x 4 places in it.
inline ByteImage chessboard_picture(const Board& board, const sensors::PinholeCamera& camera,
                                    const Eigen::Isometry3d& camera_from_board) {
  const Eigen::Isometry3d board_from_camera = camera_from_board.inverse();
  const auto brightness = [&](const Eigen::Vector2d& at_px) {
    const Eigen::Vector3d from = board_from_camera.translation(),
                          along = board_from_camera.linear() * *sensors::direction_through(camera, at_px);
    const Eigen::Vector3d place = from - along * (from.z() / along.z());
    const double column = place.x() / board.square_m + 1, row = place.y() / board.square_m + 1;
    if (column < -1 || column > board.columns + 1 || row < -1 || row > board.rows + 1) return 0.4;
    if (column < 0 || column > board.columns || row < 0 || row > board.rows) return 0.95;
    return (static_cast<int>(column) + static_cast<int>(row)) % 2 == 0 ? 0.05 : 0.95;
  };
  ByteImage picture{camera.width_px, camera.height_px, 1, {}};
  for (int row = 0; row < camera.height_px; ++row)
    for (int column = 0; column < camera.width_px; ++column) {
      double sum = 0;
      for (const double down : {0.125, 0.375, 0.625, 0.875})
        for (const double right : {0.125, 0.375, 0.625, 0.875})
          sum += brightness({column + right, row + down});
      picture.values.push_back(code_from_display(srgb_from_linear(static_cast<float>(sum / 16))));
    }
  return picture;
}

/// Where the board stands before a camera, about in the middle of its picture, slanted; another place for
/// every call.
inline Eigen::Isometry3d next_board_place(const Board& board, Random& random) {
  Eigen::Isometry3d place =
      sensors::pose_of({0, 0, 0}, {random.normal(), random.normal(), 0.2}, 15 + 15 * random.uniform());
  const Eigen::Vector3d middle(0.5 * (board.columns - 2) * board.square_m,
                               0.5 * (board.rows - 2) * board.square_m, 0);
  place.translation() = Eigen::Vector3d(0.1 * random.uniform() - 0.05, 0.1 * random.uniform() - 0.05,
                                        0.55 + 0.2 * random.uniform()) -
                        place.linear() * middle;
  return place;
}

}  // namespace seamline::test
