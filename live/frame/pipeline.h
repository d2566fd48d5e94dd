#pragma once
#include <optional>
#include <span>
#include <vector>

#include "live/frame/live_eye.h"
#include "live/frame/local_mesh.h"
#include "live/frame/stage_times.h"

namespace seamline::live {

/// What does not change while the pipeline runs.
struct PipelineSettings {
  LocalMeshOptions local_mesh;
  int shadow_map_px = 512;  ///< a side
  double shadow_bias_texels = 1;
  double depth_bias = 0.015;     ///< of the local scene's shadows (`ShadowAnswers`)
  int surface_reach_px = 8;      ///< of real surfaces (`ShadowPass`)
  int views = 1;                 ///< eyes along the camera's right vector; 1: the camera itself
  double eye_spacing_m = 0.065;  ///< between neighbouring eyes
  double zero_parallax_m = 2;    ///< what is so far away has the same pixel in all views
  int threads = 0;               ///< 0: one for each core
};

/// A frame, done: the pictures of all eyes from left to right, and what it cost.
struct LiveFrame {
  std::vector<LiveEye> eyes;
  renderer::DepthPicture registered;  ///< in the colour camera's pixels, by the mapping
  StageTimes times;
  std::size_t triangles = 0;  ///< of the local scene
};

/// Depth in, pictures out, a frame at a time (papers 000, 001 and 002): local scene, mapping, shadow maps,
/// the pictures of the eyes, virtual things, their shadows. Buffers of one frame serve the next. The same
/// pictures for any number of threads.
class LivePipeline {
 public:
  LivePipeline(const LoadedRecording& recording, LiveScene scene, const Eigen::Vector3d& origin_m,
               const PipelineSettings& settings);

  /// `world_from_colour`: upright (`live_scene.h`). What it returns is good until the next frame. Times of
  /// other stages may be added by the caller.
  LiveFrame& compose(const LoadedFrame& frame, const Eigen::Isometry3d& world_from_colour,
                     const Methods& methods);

  /// Moves the objects of a scene whose objects can be moved (`make_movable`): for each, from where it was
  /// placed, in the world.
  void move(std::span<const Eigen::Isometry3d> moves);

  [[nodiscard]] const LiveScene& scene() const { return scene_; }
  [[nodiscard]] const DepthPoints& depth_points() const { return points_; }
  [[nodiscard]] const PipelineSettings& settings() const { return settings_; }

 private:
  void map_depth(const LoadedFrame& frame, const Eigen::Isometry3d& pose, const Methods& methods);
  [[nodiscard]] ShadowAnswers shadow_answers(const Methods& methods);
  void draw_eye(std::size_t index, const ByteImage& colour, const Eigen::Isometry3d& pose,
                const Methods& methods);

  LiveScene scene_;
  Eigen::Vector3d origin_m_;
  PipelineSettings settings_;
  sensors::PinholeCamera view_;
  DepthPoints points_;
  PointRegistration register_points_;
  LocalMesh local_mesh_;
  std::optional<renderer::Geometry> tree_;
  LiveFrame frame_;
};

}  // namespace seamline::live
