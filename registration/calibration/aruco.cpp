// The only file that includes OpenCV's ArUco.
#include "registration/calibration/aruco.h"

#include "support/text/error.h"

#ifdef SEAMLINE_HAS_ARUCO
#include <opencv2/aruco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <vector>
#endif

namespace seamline::registration {

std::string_view word(MarkerCorners corners) {
  switch (corners) {
    case MarkerCorners::none:
      return "NONE";
    case MarkerCorners::subpix:
      return "SUBPIX";
  }
  return {};
}

#ifdef SEAMLINE_HAS_ARUCO

bool has_aruco() {
  return true;
}

void require_aruco() {}

std::optional<Eigen::Isometry3d> find_marker(const ByteImage& grey, const sensors::PinholeCamera& camera,
                                             double side_m, MarkerCorners corners) {
  constexpr double half_px = 0.5;  // OpenCV counts from the middle of the first pixel
  cv::setNumThreads(1);            // the same numbers on every machine
  std::vector<std::uint8_t> bytes = grey.values;
  const cv::Mat picture(grey.height_px, grey.width_px, CV_8UC1, bytes.data());
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50);
  const auto parameters = cv::aruco::DetectorParameters::create();
  parameters->cornerRefinementMethod =
      corners == MarkerCorners::subpix ? cv::aruco::CORNER_REFINE_SUBPIX : cv::aruco::CORNER_REFINE_NONE;
  std::vector<std::vector<cv::Point2f>> found;
  std::vector<int> numbers;
  cv::aruco::detectMarkers(picture, dictionary, found, numbers, parameters);
  const cv::Mat matrix = (cv::Mat_<double>(3, 3) << camera.fx_px, camera.skew_px, camera.cx_px - half_px, 0,
                          camera.fy_px, camera.cy_px - half_px, 0, 0, 1);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] != 0) continue;
    std::vector<cv::Vec3d> turns, steps;
    const std::vector<std::vector<cv::Point2f>> one = {found[i]};
    cv::aruco::estimatePoseSingleMarkers(one, static_cast<float>(side_m), matrix, cv::noArray(), turns,
                                         steps);
    cv::Mat rotation;
    cv::Rodrigues(turns.front(), rotation);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        pose.linear()(row, column) = rotation.at<double>(row, column);
      pose.translation()[row] = steps.front()[row];
    }
    if (pose.matrix().allFinite()) return pose;
  }
  return std::nullopt;
}

#else

bool has_aruco() {
  return false;
}

void require_aruco() {
  throw input_error(
      {.field = "marker",
       .wanted = "a Seamline that was built with OpenCV's ArUco (Debian: libopencv-contrib-dev)",
       .found = "one without"});
}

std::optional<Eigen::Isometry3d> find_marker(const ByteImage&, const sensors::PinholeCamera&, double,
                                             MarkerCorners) {
  require_aruco();
  return std::nullopt;
}

#endif

}  // namespace seamline::registration
