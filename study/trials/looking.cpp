#include "study/trials/looking.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180;
constexpr double least_gap_ms = 1000.0 / 30;   // between poses
constexpr std::size_t most_text_bytes = 3900;  // of an event's 4000

double clamp_to(double value, const std::array<double, 2>& limits) {
  return std::clamp(value, limits[0], limits[1]);
}

/// A number and what follows it.
bool take_number(const char*& at, const char* end, char after, double& value) {
  const auto [stop, error] = std::from_chars(at, end, value);
  if (error != std::errc() || !std::isfinite(value)) return false;
  if (stop == end) {
    at = end;
    return after == ';';
  }
  at = stop + 1;
  return *stop == after;
}

}  // namespace

std::array<double, 2> half_tangents(const LookDefinition& look) {
  const double across = std::tan(0.5 * look.horizontal_fov_deg * rad_per_deg);
  return {across, across * look.view_px[1] / look.view_px[0]};
}

std::array<double, 9> axes_of(const Pose& pose) {
  const double sa = std::sin(pose.yaw_deg * rad_per_deg), ca = std::cos(pose.yaw_deg * rad_per_deg);
  const double sp = std::sin(pose.pitch_deg * rad_per_deg), cp = std::cos(pose.pitch_deg * rad_per_deg);
  return {ca, 0, sa, -sp * sa, cp, sp * ca, -cp * sa, -sp, cp * ca};
}

Direction3 direction_at(const LookDefinition& look, const Pose& pose, const ViewPlace& at) {
  const auto [across, down] = half_tangents(look);
  const double x = (2 * at.x_px / look.view_px[0] - 1) * across,
               y = (1 - 2 * at.y_px / look.view_px[1]) * down;
  const std::array<double, 9> a = axes_of(pose);
  return {x * a[0] + y * a[3] - a[6], x * a[1] + y * a[4] - a[7], x * a[2] + y * a[5] - a[8]};
}

ViewPlace place_of(int width_px, int height_px, const Direction3& d) {
  const double column = (std::atan2(d[0], -d[2]) / (2 * std::numbers::pi) + 0.5) * width_px;
  return {column >= width_px ? column - width_px : column,
          (0.5 - std::atan2(d[1], std::hypot(d[0], d[2])) / std::numbers::pi) * height_px};
}

Direction3 direction_of(int width_px, int height_px, const ViewPlace& at) {
  const double azimuth = (at.x_px / width_px - 0.5) * 2 * std::numbers::pi;
  const double elevation = (0.5 - at.y_px / height_px) * std::numbers::pi;
  return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
          -std::cos(azimuth) * std::cos(elevation)};
}

std::optional<ViewPlace> place_in_view(const LookDefinition& look, const Pose& pose, const Direction3& d) {
  const std::array<double, 9> a = axes_of(pose);
  const double x = d[0] * a[0] + d[1] * a[1] + d[2] * a[2], y = d[0] * a[3] + d[1] * a[4] + d[2] * a[5],
               z = d[0] * a[6] + d[1] * a[7] + d[2] * a[8];
  if (z > -1e-3) return std::nullopt;
  const auto [across, down] = half_tangents(look);
  return ViewPlace{(x / -z / across + 1) * look.view_px[0] / 2, (1 - y / -z / down) * look.view_px[1] / 2};
}

namespace {

PictureFrame frame_in_view(const LookDefinition& look, const Pose& pose, const ObjectMap& map,
                           const PictureFrame& frame) {
  if (frame.width_px <= 0) return {};
  const double width = look.view_px[0], height = look.view_px[1];
  constexpr int steps = 8;
  int asked = 0, seen = 0;
  double left = width, right = 0, top = height, bottom = 0;
  const auto take = [&](double s, double t) {
    ++asked;
    const auto at =
        place_in_view(look, pose,
                      direction_of(map.width_px, map.height_px,
                                   {frame.x_px + s * frame.width_px, frame.y_px + t * frame.height_px}));
    if (!at || at->x_px <= -width / 2 || at->y_px <= -height / 2 || at->x_px >= 1.5 * width ||
        at->y_px >= 1.5 * height)
      return;
    ++seen;
    left = std::min(left, at->x_px), right = std::max(right, at->x_px);
    top = std::min(top, at->y_px), bottom = std::max(bottom, at->y_px);
  };
  for (int i = 0; i <= steps; ++i) {
    const double along = static_cast<double>(i) / steps;
    take(along, 0), take(along, 1), take(0, along), take(1, along);
  }
  if (2 * seen < asked) return {};
  left = std::round(std::clamp(left, 0.0, width)), right = std::round(std::clamp(right, 0.0, width));
  top = std::round(std::clamp(top, 0.0, height)), bottom = std::round(std::clamp(bottom, 0.0, height));
  if (!(right > left && bottom > top)) return {};
  return {left, top, right - left, bottom - top};
}

}  // namespace

std::vector<PictureFrame> frames_in_view(const LookDefinition& look, const Pose& pose, const ObjectMap& map) {
  std::vector<PictureFrame> frames(map.frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i] = frame_in_view(look, pose, map, map.frames[i]);
  return frames;
}

int object_in_view(const LookDefinition& look, const Pose& pose, const ObjectMap& map, const ViewPlace& at) {
  if (at.x_px < 0 || at.y_px < 0 || at.x_px >= look.view_px[0] || at.y_px >= look.view_px[1]) return 0;
  const ViewPlace there = place_of(map.width_px, map.height_px, direction_at(look, pose, at));
  return object_at(map, there.x_px, std::min(there.y_px, map.height_px - 1.0));
}

Pose turned(const LookDefinition& look, const Pose& pose, double right_deg, double up_deg) {
  if (look.kind != LookKind::mouse) return pose;
  const double yaw = pose.yaw_deg + right_deg;
  return {look.is_all_round() ? yaw - 360 * std::floor((yaw + 180) / 360) : clamp_to(yaw, look.yaw_deg),
          clamp_to(pose.pitch_deg + up_deg, look.pitch_deg)};
}

double zoomed_fov_deg(const LookDefinition& look, int steps_nearer) {
  if (look.kind != LookKind::mouse || !look.fov_limits_deg) return look.horizontal_fov_deg;
  return clamp_to(look.horizontal_fov_deg - 5 * steps_nearer, *look.fov_limits_deg);
}

Pose pose_towards(const ObjectMap& map, const PictureFrame& frame) {
  const double x = (frame.x_px + frame.width_px / 2) / map.width_px,
               y = (frame.y_px + frame.height_px / 2) / map.height_px;
  return {std::fmod((x - 0.5) * 360 + 540, 360) - 180, (0.5 - y) * 180};
}

Pose drawn_start(const LookDefinition& look, const std::array<double, 2>& start_deg, int stimulus,
                 int trial_index) {
  if (!(look.start_spread_deg > 0)) return {start_deg[0], start_deg[1]};
  Random random(stimulus, trial_index);
  return turned(look, {start_deg[0], start_deg[1]}, (2 * random.uniform() - 1) * look.start_spread_deg, 0);
}

double degrees_per_pixel(const LookDefinition& look) {
  return 2 * half_tangents(look)[0] / look.view_px[0] / rad_per_deg;
}

void PoseRecorder::write(const Moment& moment) {
  waiting_.reset();
  // Less than half of the last decimal is no minus.
  const auto decimal = [](double value) { return std::round(value * 10) / 10 + 0.0; };
  std::string text =
      fmt::format("{:.1f} {:.1f}", decimal(moment.pose.yaw_deg), decimal(moment.pose.pitch_deg));
  if (moment.fov_deg) text += fmt::format(" {:.1f}", *moment.fov_deg);
  if (last_ == text) return;
  last_ = text;
  last_ms_ = moment.ms;
  const std::string entry = fmt::format("{:.0f} {}", moment.ms, text);
  if (texts_.empty() || texts_.back().size() + entry.size() + 1 > most_text_bytes)
    texts_.push_back(entry);
  else
    texts_.back() += ";" + entry;
}

void PoseRecorder::write_waiting() {
  Moment moment = *waiting_;
  moment.ms = std::max(moment.ms, last_ms_ + least_gap_ms);
  write(moment);
}

void PoseRecorder::add(double ms, const Pose& pose, std::optional<double> fov_deg) {
  if (waiting_ && ms - last_ms_ >= least_gap_ms) write_waiting();
  if (!last_ || ms - last_ms_ >= least_gap_ms)
    write({ms, pose, fov_deg});
  else
    waiting_ = Moment{ms, pose, fov_deg};
}

std::vector<std::string> PoseRecorder::take() {
  if (waiting_) write_waiting();
  last_.reset();
  return std::exchange(texts_, {});
}

std::optional<std::vector<PoseAt>> poses_of(const std::string& text) {
  std::vector<PoseAt> poses;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    PoseAt one;
    if (!take_number(at, end, ' ', one.ms) || !take_number(at, end, ' ', one.pose.yaw_deg))
      return std::nullopt;
    const char* const stop = std::find_if(at, end, [](char c) { return c == ' ' || c == ';'; });
    const bool has_field = stop != end && *stop == ' ';
    if (!take_number(at, end, has_field ? ' ' : ';', one.pose.pitch_deg)) return std::nullopt;
    if (has_field && !take_number(at, end, ';', one.fov_deg.emplace())) return std::nullopt;
    poses.push_back(one);
  }
  return poses;
}

}  // namespace seamline::study
