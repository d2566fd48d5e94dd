// The only file that includes OpenCV's video part.
#include "live/tracking/optical_flow.h"

#include "support/text/error.h"
#include "support/text/request_name.h"

#ifdef SEAMLINE_HAS_TRACKING
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#endif

namespace seamline::live {

#ifdef SEAMLINE_HAS_TRACKING

namespace {

constexpr double half_px = 0.5;  // OpenCV counts from the middle of the first pixel
constexpr double strayed_px = 0.5, inlier_px = 2;
constexpr std::size_t fewest_points = 8;

/// OpenCV's view of a picture; it only reads.
cv::Mat picture_of(const ByteImage& grey) {
  return {grey.height_px, grey.width_px, CV_8UC1,
          const_cast<std::uint8_t*>(grey.values.data())};  // NOLINT(cppcoreguidelines-pro-type-const-cast)
}

cv::Point2f point_of(const Eigen::Vector2d& place_px) {
  return {static_cast<float>(place_px.x() - half_px), static_cast<float>(place_px.y() - half_px)};
}

Eigen::Vector2d place_of(const cv::Point2f& point) {
  return {static_cast<double>(point.x) + half_px, static_cast<double>(point.y) + half_px};
}

cv::Mat vector_of(const Eigen::Vector3d& v) {
  return (cv::Mat_<double>(3, 1) << v.x(), v.y(), v.z());
}

}  // namespace

bool has_optical_flow() {
  return true;
}

void require_optical_flow() {}

std::vector<Eigen::Vector2d> find_corners(const ByteImage& grey, int most, double apart_px,
                                          std::span<const Eigen::Vector2d> known) {
  constexpr double quality = 0.01;  // of the best corner's eigenvalue
  cv::setNumThreads(1);
  cv::Mat free(grey.height_px, grey.width_px, CV_8UC1, cv::Scalar(255));
  for (const Eigen::Vector2d& place_px : known)
    cv::circle(free, point_of(place_px), static_cast<int>(apart_px), cv::Scalar(0), cv::FILLED);
  std::vector<cv::Point2f> found;
  cv::goodFeaturesToTrack(picture_of(grey), found, most, quality, apart_px, free, 5);
  std::vector<Eigen::Vector2d> corners;
  if (found.empty()) return corners;
  cv::cornerSubPix(picture_of(grey), found, cv::Size(3, 3), cv::Size(-1, -1),
                   cv::TermCriteria(cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 20, 0.01));
  for (const cv::Point2f& point : found) corners.push_back(place_of(point));
  return corners;
}

std::vector<std::optional<Eigen::Vector2d>> follow_corners(const ByteImage& before, const ByteImage& now,
                                                           std::span<const Eigen::Vector2d> positions_px) {
  cv::setNumThreads(1);
  std::vector<std::optional<Eigen::Vector2d>> followed(positions_px.size());
  if (positions_px.empty()) return followed;
  std::vector<cv::Point2f> from, to, back;
  for (const Eigen::Vector2d& place_px : positions_px) from.push_back(point_of(place_px));
  std::vector<unsigned char> there, here;
  const cv::Size window(21, 21);
  constexpr int levels = 3;
  cv::calcOpticalFlowPyrLK(picture_of(before), picture_of(now), from, to, there, cv::noArray(), window,
                           levels);
  cv::calcOpticalFlowPyrLK(picture_of(now), picture_of(before), to, back, here, cv::noArray(), window,
                           levels);
  for (std::size_t i = 0; i < from.size(); ++i)
    if (there[i] != 0 && here[i] != 0 && cv::norm(back[i] - from[i]) <= strayed_px)
      followed[i] = place_of(to[i]);
  return followed;
}

std::optional<FoundPose> pose_from_points(const sensors::PinholeCamera& camera,
                                          std::span<const Eigen::Vector3d> world_m,
                                          std::span<const Eigen::Vector2d> seen_px,
                                          const Eigen::Isometry3d& near) {
  if (world_m.size() < fewest_points) return std::nullopt;
  cv::setNumThreads(1);
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> places;
  for (std::size_t i = 0; i < world_m.size(); ++i) {
    points.emplace_back(world_m[i].x(), world_m[i].y(), world_m[i].z());
    places.emplace_back(seen_px[i].x() - half_px, seen_px[i].y() - half_px);
  }
  const cv::Mat matrix = (cv::Mat_<double>(3, 3) << camera.fx_px, 0, camera.cx_px - half_px, 0, camera.fy_px,
                          camera.cy_px - half_px, 0, 0, 1);
  const Eigen::AngleAxisd about(near.linear());
  cv::Mat turn = vector_of(about.axis() * about.angle()), step = vector_of(near.translation());
  std::vector<int> inliers;
  if (!cv::solvePnPRansac(points, places, matrix, cv::noArray(), turn, step, true, 200,
                          static_cast<float>(inlier_px), 0.999, inliers, cv::SOLVEPNP_ITERATIVE) ||
      inliers.size() < fewest_points)
    return std::nullopt;
  FoundPose found{.camera_from_world = Eigen::Isometry3d::Identity(), .inliers = {}};
  std::vector<cv::Point3d> good_points;
  std::vector<cv::Point2d> good_places;
  for (const int index : inliers) {
    const std::size_t at = index;
    found.inliers.push_back(at);
    good_points.push_back(points[at]);
    good_places.push_back(places[at]);
  }
  cv::solvePnPRefineLM(good_points, good_places, matrix, cv::noArray(), turn, step);
  cv::Mat rotation;
  cv::Rodrigues(turn, rotation);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      found.camera_from_world.linear()(row, column) = rotation.at<double>(row, column);
    found.camera_from_world.translation()[row] = step.at<double>(row);
  }
  if (!found.camera_from_world.matrix().allFinite()) return std::nullopt;
  return found;
}

#else

bool has_optical_flow() {
  return false;
}

void require_optical_flow() {
  throw input_error({.field = request_name("track") + " features",
                     .wanted = "a Seamline that was built with OpenCV's parts imgproc, video and calib3d "
                               "(Debian: libopencv-video-dev, libopencv-calib3d-dev)",
                     .found = "one without"});
}

std::vector<Eigen::Vector2d> find_corners(const ByteImage&, int, double, std::span<const Eigen::Vector2d>) {
  require_optical_flow();
  return {};
}

std::vector<std::optional<Eigen::Vector2d>> follow_corners(const ByteImage&, const ByteImage&,
                                                           std::span<const Eigen::Vector2d>) {
  require_optical_flow();
  return {};
}

std::optional<FoundPose> pose_from_points(const sensors::PinholeCamera&, std::span<const Eigen::Vector3d>,
                                          std::span<const Eigen::Vector2d>, const Eigen::Isometry3d&) {
  require_optical_flow();
  return std::nullopt;
}

#endif

}  // namespace seamline::live
