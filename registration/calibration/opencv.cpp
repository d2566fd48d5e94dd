// Of the files that include OpenCV, the one for cameras and poses.
#include "registration/calibration/opencv.h"

#include "support/text/error.h"

#ifdef SEAMLINE_HAS_OPENCV
#include <Eigen/LU>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#endif

namespace seamline::registration {

#ifdef SEAMLINE_HAS_OPENCV

namespace {

constexpr double half_px = 0.5;  ///< OpenCV counts from the middle of the first pixel

/// What OpenCV says of points that it cannot use is of no help to anybody.
template <class Work>
auto with_opencv_errors(const std::string& what, Work&& work) {
  try {
    cv::setNumThreads(1);  // the same numbers on every machine
    return work();
  } catch (const cv::Exception&) {
    throw input_error({.field = what,
                       .wanted = "points from which a search can begin",
                       .found = "some that are too few, too alike or on one line"});
  }
}

Eigen::Isometry3d pose_of_vectors(const cv::Mat& turn, const cv::Mat& step) {
  cv::Mat rotation;
  cv::Rodrigues(turn, rotation);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) pose.linear()(row, column) = rotation.at<double>(row, column);
    pose.translation()[row] = step.at<double>(row);
  }
  return pose;
}

cv::Point2f opencv_point(const Eigen::Vector2d& position_px) {
  return {static_cast<float>(position_px.x() - half_px), static_cast<float>(position_px.y() - half_px)};
}

/// The distance of neighbouring corners that are nearest to each other.
double least_distance_px(const std::vector<cv::Point2f>& corners, const Board& board) {
  double least_px = 1e9;
  for (int row = 0; row < board.rows; ++row)
    for (int column = 0; column < board.columns; ++column) {
      const auto at = [&](int c, int r) {
        return corners[static_cast<std::size_t>(r) * static_cast<std::size_t>(board.columns) +
                       static_cast<std::size_t>(c)];
      };
      if (column + 1 < board.columns)
        least_px = std::min(least_px, cv::norm(at(column + 1, row) - at(column, row)));
      if (row + 1 < board.rows)
        least_px = std::min(least_px, cv::norm(at(column, row + 1) - at(column, row)));
    }
  return least_px;
}

}  // namespace

bool has_opencv() {
  return true;
}

void require_opencv() {}

std::optional<Corners> find_corners(const ByteImage& grey, const Board& board) {
  return with_opencv_errors("board", [&]() -> std::optional<Corners> {
    std::vector<std::uint8_t> bytes = grey.values;
    const cv::Mat picture(grey.height_px, grey.width_px, CV_8UC1, bytes.data());
    std::vector<cv::Point2f> found;
    if (!cv::findChessboardCorners(picture, {board.columns, board.rows}, found,
                                   cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE))
      return std::nullopt;
    // A window that holds no other corner.
    const int window = std::clamp(static_cast<int>(least_distance_px(found, board) / 3), 2, 11);
    cv::cornerSubPix(picture, found, {window, window}, {-1, -1},
                     {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 100, 1e-4});
    Corners corners;
    for (const cv::Point2f& corner : found)
      corners.emplace_back(static_cast<double>(corner.x) + half_px, static_cast<double>(corner.y) + half_px);
    return corners;
  });
}

Estimate start_of_camera(const Board& board, const BoardPictures& pictures, const std::string& what) {
  return with_opencv_errors(what, [&] {
    std::vector<cv::Point3f> points;
    for (std::size_t i = 0; i < board.corners(); ++i) {
      const Eigen::Vector3f corner = board.corner_m(i).cast<float>();
      points.emplace_back(corner.x(), corner.y(), corner.z());
    }
    std::vector<std::vector<cv::Point2f>> places;
    for (const Corners& corners : pictures.boards) {
      places.emplace_back();
      for (const Eigen::Vector2d& corner : corners) places.back().push_back(opencv_point(corner));
    }
    cv::Mat matrix, lens;
    std::vector<cv::Mat> turns, steps;
    cv::calibrateCamera(std::vector(places.size(), points), places, {pictures.width_px, pictures.height_px},
                        matrix, lens, turns, steps);
    sensors::PinholeCamera camera;
    camera.width_px = pictures.width_px;
    camera.height_px = pictures.height_px;
    camera.fx_px = matrix.at<double>(0, 0);
    camera.fy_px = matrix.at<double>(1, 1);
    camera.cx_px = matrix.at<double>(0, 2) + half_px;
    camera.cy_px = matrix.at<double>(1, 2) + half_px;
    camera.distortion = {.k1 = lens.at<double>(0),
                         .k2 = lens.at<double>(1),
                         .p1 = lens.at<double>(2),
                         .p2 = lens.at<double>(3),
                         .k3 = lens.at<double>(4)};
    Estimate start;
    start.cameras.push_back(camera);
    for (std::size_t i = 0; i < turns.size(); ++i)
      start.first_from_view.push_back(pose_of_vectors(turns[i], steps[i]));
    return start;
  });
}

Eigen::Isometry3d start_of_pose(const sensors::PinholeCamera& camera, const std::vector<PointPair>& pairs,
                                const std::string& what) {
  return with_opencv_errors(what, [&] {
    std::vector<cv::Point3d> points;
    std::vector<cv::Point2d> directions;  // the lens is taken out first: a camera of focal length 1
    for (const PointPair& pair : pairs) {
      const auto direction = sensors::direction_through(camera, pair.position_px);
      if (!direction) continue;
      points.emplace_back(pair.point_m.x(), pair.point_m.y(), pair.point_m.z());
      directions.emplace_back(direction->x(), direction->y());
    }
    cv::Mat turn, step;
    const bool found = cv::solvePnP(points, directions, cv::Mat::eye(3, 3, CV_64F), cv::noArray(), turn, step,
                                    false, cv::SOLVEPNP_SQPNP);
    Eigen::Isometry3d pose = found ? pose_of_vectors(turn, step) : Eigen::Isometry3d::Identity();
    if (!found || !pose.matrix().allFinite())
      throw input_error(
          {.field = what, .wanted = "pairs that some pose brings together", .found = "none that does"});
    return pose;
  });
}

#else

bool has_opencv() {
  return false;
}

void require_opencv() {
  throw input_error({.field = "calibrate",
                     .wanted = "a Seamline that was built with OpenCV (Debian: libopencv-calib3d-dev)",
                     .found = "one without"});
}

std::optional<Corners> find_corners(const ByteImage&, const Board&) {
  require_opencv();
  return std::nullopt;
}

Estimate start_of_camera(const Board&, const BoardPictures&, const std::string&) {
  require_opencv();
  return {};
}

Eigen::Isometry3d start_of_pose(const sensors::PinholeCamera&, const std::vector<PointPair>&,
                                const std::string&) {
  require_opencv();
  return Eigen::Isometry3d::Identity();
}

#endif

}  // namespace seamline::registration
