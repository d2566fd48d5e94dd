#include "live/tracking/tracker.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "live/frame/live_eye.h"
#include "live/frame/live_scene.h"
#include "live/tracking/optical_flow.h"
#include "registration/calibration/aruco.h"
#include "support/running/parallel.h"
#include "support/text/error.h"

namespace seamline::live {
namespace {

constexpr int most_features = 400, fewest_features = 200;
constexpr double apart_px = 8;
constexpr float flat_ratio = 1.03F;  ///< of depths around a corner; more is a jump, and its place is unsure
constexpr int mesh_triangles = 200'000;  ///< of the depth that corners are placed by

ByteImage grey_of(const ByteImage& codes) {
  ByteImage grey{.width_px = codes.width_px, .height_px = codes.height_px, .channels = 1, .values = {}};
  grey.values.resize(codes.values.size() / 3);
  for (std::size_t i = 0; i < grey.values.size(); ++i)
    grey.values[i] = static_cast<std::uint8_t>(
        (299 * codes.values[3 * i] + 587 * codes.values[3 * i + 1] + 114 * codes.values[3 * i + 2] + 500) /
        1000);
  return grey;
}

/// The depth at an image position, where its neighbourhood is flat.
std::optional<double> flat_depth_m(const renderer::DepthPicture& depth, const Eigen::Vector2d& place_px) {
  const int x = static_cast<int>(std::floor(place_px.x())), y = static_cast<int>(std::floor(place_px.y()));
  constexpr int reach = 2;
  if (x < reach || y < reach || x + reach >= depth.width_px || y + reach >= depth.height_px)
    return std::nullopt;
  float nearest_m = depth.at(x, y), farthest_m = nearest_m;
  for (int down = -reach; down <= reach; ++down)
    for (int right = -reach; right <= reach; ++right) {
      nearest_m = std::min(nearest_m, depth.at(x + right, y + down));
      farthest_m = std::max(farthest_m, depth.at(x + right, y + down));
    }
  if (!std::isfinite(farthest_m) || farthest_m > flat_ratio * nearest_m) return std::nullopt;
  return static_cast<double>(depth.at(x, y));
}

}  // namespace

std::string_view word(Tracking tracking) {
  switch (tracking) {
    case Tracking::recorded:
      return "recorded";
    case Tracking::still:
      return "still";
    case Tracking::marker:
      return "marker";
    case Tracking::features:
      return "features";
  }
  return {};
}

void require_tracking(Tracking tracking, const LoadedRecording& recording, const std::string& field) {
  switch (tracking) {
    case Tracking::recorded:
      if (!recording.has_poses())
        throw input_error({.field = field,
                           .wanted = "still, marker or features, because not every frame has a pose",
                           .found = "recorded"});
      break;
    case Tracking::still:
      break;
    case Tracking::marker:
      registration::require_aruco();
      break;
    case Tracking::features:
      require_optical_flow();
      break;
  }
}

Tracker::Tracker(const LoadedRecording& recording, Tracking tracking, double marker_side_m, int threads)
    : recording_(recording),
      tracking_(tracking),
      marker_side_m_(marker_side_m),
      threads_(threads == 0 ? default_thread_count() : threads),
      pose_(first_pose(recording)),
      points_(recording.rig.depth_form, recording.rig.colour_from_depth, threads),
      mesh_(points_, {.most_triangles = mesh_triangles}),
      depth_(renderer::empty_picture(recording.view.width_px, recording.view.height_px)) {}

TrackedPose Tracker::track(std::size_t frame_index) {
  const LoadedFrame& frame = recording_.frames[frame_index];
  switch (tracking_) {
    case Tracking::recorded:
      return {.world_from_colour = upright(recording_, *frame.world_from_colour)};
    case Tracking::still:
      return {.world_from_colour = pose_};
    case Tracking::marker:
      return by_marker(grey_of(frame.colour));
    case Tracking::features:
      return by_features(frame, grey_of(frame.colour), frame_index == 0);
  }
  return {.world_from_colour = pose_};
}

TrackedPose Tracker::by_marker(const ByteImage& grey) {
  const auto marker =
      registration::find_marker(grey, recording_.view, marker_side_m_, registration::MarkerCorners::subpix);
  if (marker) pose_ = upright(recording_, marker->inverse());
  return {.world_from_colour = pose_, .is_found = marker.has_value()};
}

TrackedPose Tracker::by_features(const LoadedFrame& frame, ByteImage grey, bool begins) {
  if (begins) {
    pose_ = first_pose(recording_);
    features_.clear();
  }
  TrackedPose tracked{.world_from_colour = pose_};
  if (!begins) {
    std::vector<Eigen::Vector2d> places_px;
    for (const Feature& feature : features_) places_px.push_back(feature.place_px);
    const auto followed = follow_corners(before_, grey, places_px);
    std::vector<Feature> kept;
    for (std::size_t i = 0; i < features_.size(); ++i)
      if (followed[i]) kept.push_back({*followed[i], features_[i].world_m});
    std::vector<Eigen::Vector3d> world_m;
    places_px.clear();
    for (const Feature& feature : kept) {
      world_m.push_back(feature.world_m);
      places_px.push_back(feature.place_px);
    }
    const auto found = pose_from_points(recording_.view, world_m, places_px, pose_.inverse());
    tracked.is_found = found.has_value();
    features_.clear();
    if (found) {
      pose_ = found->camera_from_world.inverse();
      for (const std::size_t i : found->inliers) features_.push_back(kept[i]);
    }
    tracked.world_from_colour = pose_;
    tracked.features = static_cast<int>(features_.size());
  }
  if (features_.size() < fewest_features) add_features(frame, grey);
  if (begins) tracked.features = static_cast<int>(features_.size());
  before_ = std::move(grey);
  return tracked;
}

/// New corners where there are none, placed by the frame's own depth and the pose that it was given.
void Tracker::add_features(const LoadedFrame& frame, const ByteImage& grey) {
  mesh_.build(points_, frame.depth.depth_m, Eigen::Isometry3d::Identity(), threads_);
  const std::array<renderer::TriangleSpan, 1> meshes = {mesh_.span()};
  const double parallel = std::numeric_limits<double>::infinity();
  renderer::draw_depth(eye_view(recording_.view, Eigen::Isometry3d::Identity(), 0, parallel), meshes,
                       threads_, depth_);
  std::vector<Eigen::Vector2d> known;
  for (const Feature& feature : features_) known.push_back(feature.place_px);
  const int wanted = most_features - static_cast<int>(features_.size());
  for (const Eigen::Vector2d& place_px : find_corners(grey, wanted, apart_px, known)) {
    const auto planar_m = flat_depth_m(depth_, place_px);
    const auto direction = sensors::direction_through(recording_.view, place_px);
    if (planar_m && direction) features_.push_back({place_px, pose_ * (*direction * *planar_m)});
  }
}

}  // namespace seamline::live
