#include "renderer/realtime/shadow_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seamline::renderer {
namespace {

constexpr float steepest = 8.0F;  ///< tangent of the angle of incidence, beyond which the bias grows no more
constexpr float endless_m = std::numeric_limits<float>::infinity();

/// A receiver as a light sees it: its plane's depth near it.
class Receiver {
 public:
  Receiver(const ShadowMap& map, const ShadowLookup& how, const Eigen::Vector3f& point_m,
           const Eigen::Vector3f& normal)
      : map_(map),
        at_m_(map.view.axes * (point_m - map.view.eye_m)),
        normal_(map.view.axes * normal),
        texel_(map.view.size[0] / static_cast<float>(map.depth.width_px)) {
    const float over_depth = map.view.from_point ? 1.0F / at_m_.z() : 1.0F;
    place_ = {at_m_.x() * over_depth, at_m_.y() * over_depth};
    const Eigen::Vector3f along =
        map.view.from_point ? Eigen::Vector3f(at_m_.normalized()) : Eigen::Vector3f::UnitZ();
    const float cosine = std::max(std::abs(normal_.dot(along)), 1e-6F);
    const float tangent = std::min(std::sqrt(std::max(0.0F, 1.0F - cosine * cosine)) / cosine, steepest);
    bias_m_ = how.bias_texels * texel_m() * (1.0F + tangent);
  }

  [[nodiscard]] bool is_behind_light() const { return map_.view.from_point && !(at_m_.z() > 0.0F); }
  [[nodiscard]] float depth_m() const { return at_m_.z(); }
  [[nodiscard]] float texel_m() const { return map_.view.from_point ? texel_ * at_m_.z() : texel_; }

  /// Depth of what stands in the light's way in the texel at an offset in texels; infinity where nothing
  /// does. `on_plane`: compared with the receiver's plane at the texel's centre instead of its own depth.
  [[nodiscard]] float blocker_m(float right, float down, bool on_plane) const {
    const float x = std::floor((place_[0] - map_.view.corner[0]) / texel_ + right);
    const float y = std::floor((place_[1] - map_.view.corner[1]) / texel_ + down);
    const float found_m = depth_at(map_.depth, x + 0.5F, y + 0.5F);
    if (found_m == endless_m) return endless_m;
    const float own_m = on_plane ? plane_m(map_.view.corner[0] + (x + 0.5F) * texel_,
                                           map_.view.corner[1] + (y + 0.5F) * texel_)
                                 : at_m_.z();
    return found_m < own_m - bias_m_ ? found_m : endless_m;
  }

 private:
  /// Depth of the receiver's plane at a place of the picture plane, no steeper than the bias knows.
  [[nodiscard]] float plane_m(float u, float v) const {
    if (map_.view.from_point) {
      const float along = normal_.dot(Eigen::Vector3f(u, v, 1.0F));
      const float facing = normal_.dot(at_m_);
      const float found = facing / along;
      const float farthest = std::hypot(u - place_[0], v - place_[1]) * at_m_.z() * steepest;
      if (!std::isfinite(found)) return at_m_.z();
      return std::clamp(found, at_m_.z() - farthest, at_m_.z() + farthest);
    }
    const float least = 1.0F / std::sqrt(1.0F + steepest * steepest);
    const float facing = normal_.z() < 0.0F ? std::min(normal_.z(), -least) : std::max(normal_.z(), least);
    return at_m_.z() - (normal_.x() * (u - place_[0]) + normal_.y() * (v - place_[1])) / facing;
  }

  const ShadowMap& map_;
  Eigen::Vector3f at_m_, normal_;
  Eigen::Array2f place_;
  float texel_, bias_m_ = 0;
};

/// Tap `number` of `count` over a unit disc, evenly by area (Vogel's spiral).
Eigen::Array2f disc_tap(int number, int count, float turn) {
  constexpr float golden = 2.39996322972865F;
  const float radius = std::sqrt((static_cast<float>(number) + 0.5F) / static_cast<float>(count));
  const float angle = golden * static_cast<float>(number) + 2.0F * std::numbers::pi_v<float> * turn;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

float percentage_closer(const Receiver& receiver) {
  int arrives = 0;
  for (int down = -1; down <= 1; ++down)
    for (int right = -1; right <= 1; ++right)
      arrives +=
          receiver.blocker_m(static_cast<float>(right), static_cast<float>(down), true) == endless_m ? 1 : 0;
  return static_cast<float>(arrives) / 9.0F;
}

float one_texel(const Receiver& receiver) {
  return receiver.blocker_m(0, 0, false) == endless_m ? 1.0F : 0.0F;
}

float soft(const ShadowMap& map, const Receiver& receiver, int taps, float turn) {
  const float search_m = map.tan_radius * (receiver.depth_m() - map.nearest_m);
  if (!(search_m > 0.0F)) return one_texel(receiver);
  const float per_texel = 1.0F / receiver.texel_m();
  double depth_sum_m = 0;
  int blockers = 0;
  for (int i = 0; i < taps; ++i) {
    const Eigen::Array2f tap = disc_tap(i, taps, turn) * (search_m * per_texel);
    const float found_m = receiver.blocker_m(tap[0], tap[1], true);
    if (found_m == endless_m) continue;
    depth_sum_m += static_cast<double>(found_m);
    ++blockers;
  }
  if (blockers == 0) return 1.0F;
  const float radius_m =
      map.tan_radius * (receiver.depth_m() - static_cast<float>(depth_sum_m / static_cast<double>(blockers)));
  if (radius_m * per_texel < 0.5F) return one_texel(receiver);
  int arrives = 0;
  for (int i = 0; i < taps; ++i) {
    const Eigen::Array2f tap = disc_tap(i, taps, turn) * (radius_m * per_texel);
    arrives += receiver.blocker_m(tap[0], tap[1], true) == endless_m ? 1 : 0;
  }
  return static_cast<float>(arrives) / static_cast<float>(taps);
}

/// Fits a square window around places of the picture plane, with two texels beside them.
void fit_window(const Eigen::Array2f& least, const Eigen::Array2f& most, float margin, int width_px,
                DrawView& view) {
  const Eigen::Array2f middle = 0.5F * (least + most);
  const float side = std::max((most - least).maxCoeff() + 2.0F * margin, 1e-6F) *
                     static_cast<float>(width_px) / static_cast<float>(std::max(width_px - 4, 1));
  view.size.setConstant(side);
  view.corner = middle - 0.5F * side;
}

void draw(std::span<const TriangleSpan> casters, int width_px, int threads, ShadowMap& map) {
  map.depth = empty_picture(width_px, width_px);
  draw_depth(map.view, casters, threads, map.depth);
  map.nearest_m = *std::min_element(map.depth.depth_m.begin(), map.depth.depth_m.end());
}

}  // namespace

float arriving(const ShadowMap& map, const ShadowLookup& how, const Eigen::Vector3f& point_m,
               const Eigen::Vector3f& normal, float turn) {
  const Receiver receiver(map, how, point_m, normal);
  if (receiver.is_behind_light()) return 1.0F;
  switch (how.filter) {
    case ShadowFilter::none:
      return one_texel(receiver);
    case ShadowFilter::pcf:
      return percentage_closer(receiver);
    case ShadowFilter::pcss:
      return soft(map, receiver, how.taps, turn);
  }
  return 1.0F;
}

ShadowMap sun_shadow_map(const Sun& sun, std::span<const TriangleSpan> casters,
                         std::span<const Eigen::Vector3f> covered_m, int width_px, int threads) {
  ShadowMap map;
  map.view.axes = axes_along(-sun.to_sun);
  map.tan_radius = std::tan(sun.angular_radius_rad);
  Eigen::Array3f least = Eigen::Array3f::Constant(endless_m), most = -least;
  for (const Eigen::Vector3f& point_m : covered_m) {
    const Eigen::Array3f seen = (map.view.axes * point_m).array();
    least = least.min(seen);
    most = most.max(seen);
  }
  if (covered_m.empty()) least = most = Eigen::Array3f::Zero();
  fit_window(least.head<2>(), most.head<2>(), map.tan_radius * (most[2] - least[2]), width_px, map.view);
  draw(casters, width_px, threads, map);
  return map;
}

ShadowMap lamp_shadow_map(const Lamp& lamp, std::span<const TriangleSpan> casters,
                          std::span<const Eigen::Vector3f> covered_m, int width_px, int threads) {
  ShadowMap map;
  map.view.from_point = true;
  map.view.eye_m = lamp.position_m;
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& point_m : covered_m) middle += (point_m - lamp.position_m).normalized();
  if (!(middle.norm() > 1e-6F)) middle = lamp.axis;
  map.view.axes = axes_along(middle.normalized());
  const float widest = std::tan(80.0F * std::numbers::pi_v<float> / 180.0F);
  Eigen::Array2f least = Eigen::Array2f::Constant(widest), most = -least;
  for (const Eigen::Vector3f& point_m : covered_m) {
    const Eigen::Vector3f seen = map.view.axes * (point_m - lamp.position_m);
    if (!(seen.z() > 0.0F)) continue;
    const Eigen::Array2f place = (seen.head<2>() / seen.z()).array().max(-widest).min(widest);
    least = least.min(place);
    most = most.max(place);
  }
  if ((least > most).any()) least = -1, most = 1;
  fit_window(least, most, 0.0F, width_px, map.view);
  draw(casters, width_px, threads, map);
  return map;
}

ShadowMaps draw_shadow_maps(const Light& light, std::span<const TriangleSpan> casters,
                            std::span<const Eigen::Vector3f> covered_m, int width_px, int threads) {
  ShadowMaps maps;
  for (const Sun& sun : light.suns)
    maps.suns.push_back(sun_shadow_map(sun, casters, covered_m, width_px, threads));
  for (const Lamp& lamp : light.lamps)
    maps.lamps.push_back(lamp_shadow_map(lamp, casters, covered_m, width_px, threads));
  return maps;
}

}  // namespace seamline::renderer
