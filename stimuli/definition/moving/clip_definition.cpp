#include "stimuli/definition/moving/clip_definition.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "support/running/overloaded.h"

namespace seamline::inline stimuli {
namespace {

/// A moment that is meant to be a capture's own may have been rounded to just before it.
constexpr double same_capture = 1e-9;

template <class Key>
double share_between(const Key& from, const Key& to, double time_s) {
  const double between_s = to.time_s - from.time_s;
  return between_s > 0 ? (time_s - from.time_s) / between_s : 0;
}

/// The first key after a time, of keys that rise.
template <class Key>
auto key_after(const std::vector<Key>& keys, double time_s) {
  return std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.time_s > time_s; });
}

ObjectPose pose_between(const MotionKey& from, const MotionKey& to, double time_s) {
  const double share = share_between(from, to, time_s);
  return {.position_m = from.pose.position_m + share * (to.pose.position_m - from.pose.position_m),
          .rotation_deg = from.pose.rotation_deg + share * (to.pose.rotation_deg - from.pose.rotation_deg)};
}

ObjectPose on_line(const LineMotion& line, ObjectPose pose, double gone_m) {
  const Eigen::Vector3d way_m = line.to_m - pose.position_m;
  const double gone = gone_m / way_m.norm();
  const double there_and_back = gone - 2 * std::floor(gone / 2);
  const double share =
      line.comes_back ? std::min(there_and_back, 2 - there_and_back) : std::clamp(gone, 0.0, 1.0);
  if (share != 0) pose.position_m += share * way_m;
  return pose;
}

ObjectPose on_keys(const KeyedMotion& path, double time_s) {
  const auto after = key_after(path.keys, time_s);
  if (after == path.keys.begin()) return path.keys.front().pose;
  if (after == path.keys.end()) return path.keys.back().pose;
  return pose_between(*std::prev(after), *after, time_s);
}

}  // namespace

ObjectPose pose_at(const ObjectMotion& motion, const ObjectPose& start, double time_s,
                   const std::optional<double>& speed_m_s) {
  return std::visit(Overloaded{[&](const LineMotion& line) {
                                 return on_line(line, start, speed_m_s.value_or(line.speed_m_s) * time_s);
                               },
                               [&](const TurnMotion& turn) {
                                 ObjectPose pose = start;
                                 pose.rotation_deg.y() += turn.speed_deg_s * time_s;
                                 return pose;
                               },
                               [&](const KeyedMotion& path) { return on_keys(path, time_s); }},
                    motion);
}

double animation_time_s(const FileAnimation& animation, double time_s) {
  const double gone_s = animation.speed * time_s;
  if (!animation.to_s) return animation.from_s + gone_s;
  const double whole_s = *animation.to_s - animation.from_s;
  if (animation.repeats) return animation.from_s + gone_s - whole_s * std::floor(gone_s / whole_s);
  return animation.from_s + std::clamp(gone_s, 0.0, whole_s);
}

CameraKey camera_at(const CameraMotion& motion, double time_s) {
  const auto after = key_after(motion.keys, time_s);
  if (after == motion.keys.begin()) return motion.keys.front();
  if (after == motion.keys.end()) return motion.keys.back();
  const CameraKey &from = *std::prev(after), &to = *after;
  const double share = share_between(from, to, time_s);
  return {.time_s = time_s,
          .position_m = from.position_m + share * (to.position_m - from.position_m),
          .look_at_m = from.look_at_m + share * (to.look_at_m - from.look_at_m)};
}

double capture_time_s(const DepthClock& clock, double time_s) {
  const double newest_s = time_s - clock.delay_ms / 1000;
  if (clock.frames_per_s == 0) return newest_s;
  return std::floor(newest_s * clock.frames_per_s + same_capture) / clock.frames_per_s;
}

}  // namespace seamline::inline stimuli
