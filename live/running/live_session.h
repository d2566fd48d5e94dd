#pragma once
#include <memory>

#include "live/physics/falling_bodies.h"
#include "live/running/live_request.h"

namespace seamline::live {

/// A recording that plays: frame after frame through tracking and pipeline, from the first again after the
/// last.
class LiveSession {
 public:
  /// Loads everything. Throws InputError as the readers do.
  explicit LiveSession(const LiveRequest& request);

  struct Step {
    std::size_t frame_index;  ///< in the recording
    LiveFrame& frame;
    TrackedPose pose;
  };
  /// The next frame, by these methods.
  [[nodiscard]] Step next(const Methods& methods);
  /// The frame that was last shown, once more.
  [[nodiscard]] Step again(const Methods& methods);

  /// What falls; null without `LiveRequest::physics`.
  [[nodiscard]] const FallingBodies* bodies() const { return bodies_.get(); }
  /// Lets all things go again from above, where they fall; shown by the next `again` or `next`.
  void let_go();
  /// Whether they stay where they are while the recording plays on.
  void hold_bodies(bool holds) { holds_bodies_ = holds; }

  [[nodiscard]] const LoadedRecording& recording() const { return recording_; }
  [[nodiscard]] std::size_t virtual_triangles() const;

 private:
  [[nodiscard]] Step compose(const Methods& methods, StageTimes before);
  void let_fall();

  LoadedRecording recording_;
  std::unique_ptr<Tracker> tracker_;
  std::unique_ptr<LivePipeline> pipeline_;
  std::unique_ptr<FallingBodies> bodies_;
  std::size_t next_ = 0, current_ = 0;
  bool has_shown_ = false, holds_bodies_ = false;
  TrackedPose pose_;
};

/// Where objects stand that have no place: on what the first picture shows nearest to its middle where it has
/// depth. Throws InputError where it has none.
[[nodiscard]] std::vector<renderer::PlacedModel> placed_models(const LoadedRecording& recording,
                                                               const Eigen::Isometry3d& first_pose,
                                                               const LiveRequest& request);

}  // namespace seamline::live
