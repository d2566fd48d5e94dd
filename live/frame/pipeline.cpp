#include "live/frame/pipeline.h"

#include <array>
#include <utility>

#include "live/frame/moving_objects.h"
#include "live/frame/other_eye.h"
#include "support/running/parallel.h"

namespace seamline::live {

using renderer::TriangleSpan;

LivePipeline::LivePipeline(const LoadedRecording& recording, LiveScene scene, const Eigen::Vector3d& origin_m,
                           const PipelineSettings& settings)
    : scene_(std::move(scene)),
      origin_m_(origin_m),
      settings_(settings),
      view_(recording.view),
      points_(recording.rig.depth_form, recording.rig.colour_from_depth, settings.threads),
      register_points_(recording.view),
      local_mesh_(points_, settings.local_mesh) {
  if (settings_.threads == 0) settings_.threads = default_thread_count();
  const std::size_t pixels =
      static_cast<std::size_t>(view_.width_px) * static_cast<std::size_t>(view_.height_px);
  frame_.registered = renderer::empty_picture(view_.width_px, view_.height_px);
  frame_.eyes.resize(settings_.views);
  for (LiveEye& eye : frame_.eyes) {
    eye.real = renderer::empty_picture(view_.width_px, view_.height_px);
    eye.ghosts = renderer::empty_picture(view_.width_px, view_.height_px);
    eye.codes = {.width_px = view_.width_px, .height_px = view_.height_px, .channels = 3, .values = {}};
    eye.codes.values.resize(3 * pixels);
  }
}

void LivePipeline::move(std::span<const Eigen::Isometry3d> moves) {
  move_objects(moves, origin_m_, scene_);
}

LiveFrame& LivePipeline::compose(const LoadedFrame& frame, const Eigen::Isometry3d& world_from_colour,
                                 const Methods& methods) {
  frame_.times = {};
  Eigen::Isometry3d pose = world_from_colour;
  pose.translation() -= origin_m_;
  map_depth(frame, pose, methods);
  const ShadowAnswers shadows = shadow_answers(methods);
  for (std::size_t i = 0; i < frame_.eyes.size(); ++i) {
    draw_eye(i, frame.colour, pose, methods);
    {
      const StageTimer timer(frame_.times, FrameStage::object);
      draw_objects({.scene = scene_,
                    .shadows = shadows,
                    .occlusion = methods.occlusion,
                    .local_scene = tree_ ? &*tree_ : nullptr,
                    .threads = settings_.threads},
                   frame_.eyes[i]);
    }
    const StageTimer timer(frame_.times, FrameStage::shadow);
    darken_shadows({.scene = scene_,
                    .shadows = shadows,
                    .surface_reach_px = settings_.surface_reach_px,
                    .threads = settings_.threads},
                   frame_.eyes[i]);
  }
  return frame_;
}

void LivePipeline::map_depth(const LoadedFrame& frame, const Eigen::Isometry3d& pose,
                             const Methods& methods) {
  {
    const StageTimer timer(frame_.times, FrameStage::local_scene);
    local_mesh_.build(points_, frame.depth.depth_m, pose, settings_.threads);
    frame_.triangles = local_mesh_.mesh().triangles.size();
  }
  {
    const StageTimer timer(frame_.times, FrameStage::mapping);
    if (methods.mapping == Mapping::points) {
      register_points_(points_, frame.depth.depth_m, settings_.threads, frame_.registered);
    } else {
      const std::array<TriangleSpan, 1> meshes = {local_mesh_.span()};
      renderer::draw_depth(eye_view(view_, pose, 0, settings_.zero_parallax_m), meshes, settings_.threads,
                           frame_.registered);
    }
  }
  tree_.reset();
  if (!needs_tree(methods)) return;
  const StageTimer timer(frame_.times, FrameStage::tree);
  tree_.emplace(local_mesh_.mesh(), Rgb::Constant(0.5F), renderer::TreeQuality::for_few_rays,
                renderer::CentreRays::by_tree);
}

ShadowAnswers LivePipeline::shadow_answers(const Methods& methods) {
  ShadowAnswers shadows{
      .method = methods.shadows,
      .lookup = {filter_of(methods.shadows), static_cast<float>(settings_.shadow_bias_texels)},
      .depth_bias = static_cast<float>(settings_.depth_bias),
      .object = {},
      .real = {},
      .objects = &scene_,
      .real_geometry = tree_ ? &*tree_ : nullptr};
  if (!uses_maps(methods.shadows)) return shadows;
  const StageTimer timer(frame_.times, FrameStage::maps);
  draw_maps(scene_, local_mesh_.span(), settings_.shadow_map_px, settings_.threads, shadows);
  return shadows;
}

/// The real world in one eye's picture, and what hides virtual things there. The camera's own eye shows the
/// colour picture itself.
void LivePipeline::draw_eye(std::size_t index, const ByteImage& colour, const Eigen::Isometry3d& pose,
                            const Methods& methods) {
  LiveEye& eye = frame_.eyes[index];
  const double right_m = (index - 0.5 * (frame_.eyes.size() - 1)) * settings_.eye_spacing_m;
  eye.view = eye_view(view_, pose, right_m, settings_.zero_parallax_m);
  const std::array<TriangleSpan, 1> meshes = {local_mesh_.span()};
  const bool is_mesh_drawn = right_m != 0 || methods.mapping == Mapping::mesh;
  {
    const StageTimer timer(frame_.times, FrameStage::views);
    if (right_m == 0) {
      eye.codes.values = colour.values;
      eye.real.depth_m = frame_.registered.depth_m;
    } else {
      draw_other_eye(local_mesh_.span(), eye_view(view_, pose, 0, settings_.zero_parallax_m), colour,
                     settings_.threads, eye);
    }
  }
  if (methods.occlusion != Occlusion::ghosts) return;
  const StageTimer timer(frame_.times, FrameStage::object);
  if (is_mesh_drawn)
    eye.ghosts.depth_m = eye.real.depth_m;
  else
    renderer::draw_depth(eye.view, meshes, settings_.threads, eye.ghosts);
}

}  // namespace seamline::live
