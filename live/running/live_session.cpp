#include "live/running/live_session.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "support/running/parallel.h"
#include "support/text/error.h"

namespace seamline::live {
namespace {

constexpr double usual_height_share = 0.2;  ///< of the distance
constexpr int middle_share = 20;            ///< of the picture's sides, on either side of its middle

/// The median depth of what the middle of the first picture shows.
double middle_depth_m(const LoadedRecording& recording) {
  const DepthPoints points(recording.rig.depth_form, recording.rig.colour_from_depth, 1);
  renderer::DepthPicture depth = renderer::empty_picture(recording.view.width_px, recording.view.height_px);
  PointRegistration registration(recording.view);
  registration(points, recording.frames.front().depth.depth_m, 1, depth);
  std::vector<float> found;
  const int wide = recording.view.width_px / middle_share, high = recording.view.height_px / middle_share;
  for (int y = recording.view.height_px / 2 - high; y <= recording.view.height_px / 2 + high; ++y)
    for (int x = recording.view.width_px / 2 - wide; x <= recording.view.width_px / 2 + wide; ++x)
      if (x >= 0 && y >= 0 && x < depth.width_px && y < depth.height_px && std::isfinite(depth.at(x, y)))
        found.push_back(depth.at(x, y));
  if (found.empty())
    throw input_error(
        {.field = "--at",
         .wanted = "where the objects stand, because the middle of the first picture has no depth",
         .found = "nothing"});
  std::nth_element(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2), found.end());
  return static_cast<double>(found[found.size() / 2]);
}

}  // namespace

std::vector<renderer::PlacedModel> placed_models(const LoadedRecording& recording,
                                                 const Eigen::Isometry3d& first_pose,
                                                 const LiveRequest& request) {
  std::vector<renderer::PlacedModel> models = request.models;
  std::optional<double> distance_m;
  for (const RequestedObject& object : request.objects) {
    renderer::PlacedModel model{.file = object.file, .path = object.path, .height_m = object.height_m};
    model.stands = true;
    model.materials = MaterialModel::diffuse;
    if ((!object.position_m || !object.height_m) && !distance_m) distance_m = middle_depth_m(recording);
    if (!object.height_m) model.height_m = usual_height_share * *distance_m;
    const Eigen::Vector3d direction(
        (0.5 * recording.view.width_px - recording.view.cx_px) / recording.view.fx_px,
        (0.5 * recording.view.height_px - recording.view.cy_px) / recording.view.fy_px, 1);
    model.position_m =
        object.position_m ? *object.position_m : Eigen::Vector3d(first_pose * (direction * *distance_m));
    models.push_back(model);
  }
  return models;
}

LiveSession::LiveSession(const LiveRequest& request)
    : recording_(load_recording(read_recording(request.recording), request.load)) {
  require_tracking(request.tracking, recording_, "--track");
  tracker_ = std::make_unique<Tracker>(recording_, request.tracking, request.marker_side_m,
                                       request.settings.threads);
  const Eigen::Isometry3d first = tracker_->track(0).world_from_colour;
  const SceneRequest scene{.models = placed_models(recording_, first, request),
                           .light = request.light ? &*request.light : nullptr};
  pipeline_ = std::make_unique<LivePipeline>(recording_, live_scene(recording_, scene, first.translation()),
                                             first.translation(), request.settings);
}

LiveSession::Step LiveSession::next(const Methods& methods) {
  const auto begun = std::chrono::steady_clock::now();
  current_ = next_;
  next_ = (next_ + 1) % recording_.frames.size();
  pose_ = tracker_->track(current_);
  return compose(methods,
                 std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count());
}

LiveSession::Step LiveSession::again(const Methods& methods) {
  return compose(methods, 0);
}

LiveSession::Step LiveSession::compose(const Methods& methods, double tracking_ms) {
  LiveFrame& frame = pipeline_->compose(recording_.frames[current_], pose_.world_from_colour, methods);
  frame.times.add(Stage::tracking, tracking_ms);
  return {current_, frame, pose_};
}

std::size_t LiveSession::virtual_triangles() const {
  std::size_t count = 0;
  for (const auto& mesh : pipeline_->scene().objects.meshes) count += mesh->triangles.size();
  return count;
}

}  // namespace seamline::live
