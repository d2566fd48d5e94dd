// With calibration/opencv.cpp and calibration/aruco.cpp, all that includes OpenCV below live/.
#include "registration/stereo/semi_global.h"

#include "support/text/error.h"

#ifdef SEAMLINE_HAS_OPENCV
#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#endif

namespace seamline::registration {

#ifdef SEAMLINE_HAS_OPENCV

namespace {

cv::Mat padded_rows(const ByteImage& picture, int left_px) {
  cv::Mat rows(picture.height_px, picture.width_px + left_px, CV_8UC3, cv::Scalar::all(0));
  for (int y = 0; y < picture.height_px; ++y) {
    const auto first = picture.values.begin() + static_cast<std::ptrdiff_t>(y) * picture.width_px * 3;
    std::copy(first, first + std::ptrdiff_t{3} * picture.width_px, rows.ptr<std::uint8_t>(y) + 3 * left_px);
  }
  return rows;
}

}  // namespace

std::vector<float> match_stereo(const ByteImage& left, const ByteImage& right,
                                const StereoMatching& matching) {
  assert(left.channels == 3 && right.channels == 3 && left.width_px == right.width_px &&
         left.height_px == right.height_px);
  cv::setNumThreads(1);
  // OpenCV leaves out as many columns as there are disparities: empty ones stand before the picture for them.
  const int before_px = matching.disparities_px, block_values = 3 * matching.block_px * matching.block_px;
  const auto matcher = cv::StereoSGBM::create(
      0, matching.disparities_px, matching.block_px, 8 * block_values, 32 * block_values, /*disp12MaxDiff=*/1,
      /*preFilterCap=*/63, /*uniquenessRatio=*/10, /*speckleWindowSize=*/100, /*speckleRange=*/2,
      cv::StereoSGBM::MODE_HH);
  cv::Mat sixteenths;
  matcher->compute(padded_rows(left, before_px), padded_rows(right, before_px), sixteenths);
  std::vector<float> disparity_px;
  disparity_px.reserve(left.values.size() / 3);
  for (int y = 0; y < left.height_px; ++y)
    for (int x = 0; x < left.width_px; ++x) {
      const std::int16_t found = sixteenths.at<std::int16_t>(y, x + before_px);
      const bool leaves = found > 16 * x;  // into the empty columns
      disparity_px.push_back(found < 0 || leaves ? std::numeric_limits<float>::quiet_NaN()
                                                 : static_cast<float>(found) / 16.0F);
    }
  return disparity_px;
}

#else

std::vector<float> match_stereo(const ByteImage& /*left*/, const ByteImage& /*right*/,
                                const StereoMatching& /*matching*/) {
  throw input_error({.field = "depth.source",
                     .wanted = "a program that was built with OpenCV (libopencv-calib3d-dev), which matches "
                               "the pictures of \"stereo\"",
                     .found = "one that was built without it"});
}

#endif

}  // namespace seamline::registration
