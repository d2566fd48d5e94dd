#include "live/running/live_session.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "live/frame/moving_objects.h"
#include "support/running/parallel.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::live {
namespace {

constexpr double usual_height_share = 0.2;  ///< of the distance

/// In the colour camera's frame, what the first picture shows nearest to its middle where there is depth.
Eigen::Vector3d middle_m(const LoadedRecording& recording) {
  const sensors::PinholeCamera& view = recording.view;
  const DepthPoints points(recording.rig.depth_form, recording.rig.colour_from_depth, 1);
  renderer::DepthPicture depth = renderer::empty_picture(view.width_px, view.height_px);
  PointRegistration registration(view);
  registration(points, recording.frames.front().depth.depth_m, 1, depth);
  double least_px2 = std::numeric_limits<double>::infinity();
  std::optional<Eigen::Vector3d> found_m;
  for (int y = 0; y < view.height_px; ++y)
    for (int x = 0; x < view.width_px; ++x) {
      const Eigen::Vector2d place_px(x + 0.5, y + 0.5);
      const double off_px2 = (place_px - 0.5 * Eigen::Vector2d(view.width_px, view.height_px)).squaredNorm();
      if (off_px2 >= least_px2 || !std::isfinite(depth.at(x, y))) continue;
      const auto direction = sensors::direction_through(view, place_px);
      if (!direction) continue;
      least_px2 = off_px2;
      found_m = *direction * static_cast<double>(depth.at(x, y));
    }
  if (!found_m)
    throw input_error({.field = request_name("at"),
                       .wanted = "where the objects stand, because the first picture has no depth",
                       .found = "nothing"});
  return *found_m;
}

}  // namespace

std::vector<renderer::PlacedModel> placed_models(const LoadedRecording& recording,
                                                 const Eigen::Isometry3d& first_pose,
                                                 const LiveRequest& request) {
  std::vector<renderer::PlacedModel> models = request.models;
  std::optional<Eigen::Vector3d> place_m;
  for (const RequestedObject& object : request.objects) {
    renderer::PlacedModel model{.file = object.file, .path = object.path, .height_m = object.height_m};
    model.stands = true;
    model.materials = MaterialModel::diffuse;
    if ((!object.position_m || !object.height_m) && !place_m) place_m = middle_m(recording);
    if (!object.height_m) model.height_m = usual_height_share * place_m->z();
    model.position_m = object.position_m ? *object.position_m : Eigen::Vector3d(first_pose * *place_m);
    models.push_back(model);
  }
  return models;
}

LiveSession::LiveSession(const LiveRequest& request)
    : recording_(load_recording(read_recording(request.recording), request.load)) {
  require_tracking(request.tracking, recording_, request_name("track"));
  tracker_ = std::make_unique<Tracker>(recording_, request.tracking, request.marker_side_m,
                                       request.settings.threads);
  const Eigen::Isometry3d first = tracker_->track(0).world_from_colour;
  const SceneRequest scene{.models = placed_models(recording_, first, request),
                           .light = request.light ? &*request.light : nullptr};
  LiveScene placed = live_scene(recording_, scene, first.translation());
  if (request.physics) make_movable(scene.models, first.translation(), placed);
  pipeline_ =
      std::make_unique<LivePipeline>(recording_, std::move(placed), first.translation(), request.settings);
  if (!request.physics) return;
  const DepthPoints& points = pipeline_->depth_points();
  bodies_ = std::make_unique<FallingBodies>(falling_bodies(scene.models),
                                            DepthGround(points, request.settings.local_mesh), request.drop_m);
  bodies_->begin(points, recording_.frames.front().depth.depth_m, first);
}

LiveSession::Step LiveSession::next(const Methods& methods) {
  StageTimes times;
  current_ = next_;
  next_ = (next_ + 1) % recording_.frames.size();
  {
    const StageTimer timer(times, FrameStage::tracking);
    pose_ = tracker_->track(current_);
  }
  if (bodies_ != nullptr) {
    const StageTimer timer(times, FrameStage::physics);
    let_fall();
  }
  has_shown_ = true;
  return compose(methods, times);
}

void LiveSession::let_fall() {
  if (pose_.is_found && !holds_bodies_)
    bodies_->advance(pipeline_->depth_points(), recording_.frames[current_].depth.depth_m,
                     pose_.world_from_colour, has_shown_ ? interval_before_s(recording_, current_) : 0);
  pipeline_->move(bodies_->moves());
}

void LiveSession::let_go() {
  if (bodies_ == nullptr) return;
  bodies_->let_go();
  pipeline_->move(bodies_->moves());
}

LiveSession::Step LiveSession::again(const Methods& methods) {
  return compose(methods, {});
}

LiveSession::Step LiveSession::compose(const Methods& methods, StageTimes before) {
  LiveFrame& frame = pipeline_->compose(recording_.frames[current_], pose_.world_from_colour, methods);
  for (const FrameStage stage : {FrameStage::tracking, FrameStage::physics})
    frame.times.add(stage, before.of(stage));
  return {current_, frame, pose_};
}

std::size_t LiveSession::virtual_triangles() const {
  std::size_t count = 0;
  for (const auto& mesh : pipeline_->scene().objects.meshes) count += mesh->triangles.size();
  return count;
}

}  // namespace seamline::live
