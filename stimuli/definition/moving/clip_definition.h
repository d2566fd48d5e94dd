#pragma once
#include <Eigen/Core>
#include <compare>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace seamline::inline stimuli {

/// Where an object stands, as `ObjectDefinition` says it.
struct ObjectPose {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d rotation_deg = Eigen::Vector3d::Zero();
};

/// An object goes from its own position to `to_m` at an even speed, and there back again, without end; or it
/// stops there.
struct LineMotion {
  Eigen::Vector3d to_m = Eigen::Vector3d::Zero();
  double speed_m_s = 0;  ///< where the level is not the speed
  bool comes_back = true;
};

/// It turns about the vertical through its own position at an even speed, counter-clockwise from above.
struct TurnMotion {
  double speed_deg_s = 0;
};

struct MotionKey {
  double time_s = 0;
  ObjectPose pose = {};
};

/// It is at each key's pose at its time, and between two on the straight line between them; before the first
/// and after the last it stands still.
struct KeyedMotion {
  std::vector<MotionKey> keys;  ///< one at least, rising
};

/// An animation of a glTF file that plays while a clip is shown: from `from_s` to `to_s` of its own time,
/// then it stands, or begins anew at `from_s`.
struct FileAnimation {
  std::string name;  ///< empty: the file's only one
  double from_s = 0;
  std::optional<double> to_s = {};  ///< none: to its end
  bool repeats = false;             ///< with an end only
  double speed = 1;                 ///< its seconds in one second
};

/// Where the camera is at a time, and what it looks at.
struct CameraKey {
  double time_s = 0;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d look_at_m = -Eigen::Vector3d::UnitZ();
};

/// As a keyed path of an object.
struct CameraMotion {
  std::vector<CameraKey> keys;  ///< two at least, rising
};

/// How an object moves while a clip is shown.
using ObjectMotion = std::variant<LineMotion, TurnMotion, KeyedMotion>;

/// When the depth of a frame is captured.
struct DepthClock {
  double frames_per_s = 0;  ///< captured at k / frames_per_s and held until the next; 0: at every frame
  double delay_ms = 0;      ///< depth is at least so much older than the picture

  auto operator<=>(const DepthClock&) const = default;
};

enum class ClipQuestion {
  during,  ///< people answer while the clip is shown
  after    ///< once it has been shown
};

/// Every stimulus of the study is a clip: frame k shows the scene at k / frames_per_s seconds.
struct ClipDefinition {
  int frames = 48;
  double frames_per_s = 24;
  bool loops = true;  ///< it begins anew after its last frame; else the last frame stays
  ClipQuestion question = ClipQuestion::during;
  std::map<std::pair<std::string, std::string>, ObjectMotion> motions;  ///< by scene and object
  /// By scene and object; "" for an object: the background.
  std::map<std::pair<std::string, std::string>, FileAnimation> animations;
  std::map<std::string, CameraMotion> cameras;  ///< by scene
  std::map<std::string, DepthClock> clocks;     ///< by condition, "" where there are none
  bool are_conditions = false;                  ///< the study's conditions are the frames (`study_of_frames`)
};

[[nodiscard]] std::string_view word(ClipQuestion question);

/// Where an object is at a time that is at `start` when the clip begins. Before that, motion is continued
/// backwards. `speed_m_s` is that of lines, where the level says it.
[[nodiscard]] ObjectPose pose_at(const ObjectMotion& motion, const ObjectPose& start, double time_s,
                                 const std::optional<double>& speed_m_s);

/// The animation's own time at a time of the clip.
[[nodiscard]] double animation_time_s(const FileAnimation& animation, double time_s);

/// A camera's key at a time, between keys on the straight line between them.
[[nodiscard]] CameraKey camera_at(const CameraMotion& motion, double time_s);

/// When the depth was captured that is at hand at a time: the last capture that is at least as old as the
/// delay.
[[nodiscard]] double capture_time_s(const DepthClock& clock, double time_s);

/// What decides the pictures, as lines for hashes.
[[nodiscard]] std::string canonical_text(const ClipDefinition& clip);

}  // namespace seamline::inline stimuli
