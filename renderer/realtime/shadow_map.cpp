#include "renderer/realtime/shadow_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace seamline::renderer {
namespace {

constexpr float steepest = 8.0F;  ///< tangent of the angle of incidence, beyond which the bias grows no more
constexpr float endless_m = std::numeric_limits<float>::infinity();

/// Where a light sees a point: in its axes, on its picture plane and in texels of its map.
struct SeenPoint {
  SeenPoint(const ShadowMap& map, const Eigen::Vector3f& point_m)
      : at_m(map.view.axes * (point_m - map.view.eye_m)),
        texel(map.view.size[0] / static_cast<float>(map.depth.width_px)) {
    const float over_depth = map.view.from_point ? 1.0F / at_m.z() : 1.0F;
    place = {at_m.x() * over_depth, at_m.y() * over_depth};
    column = (place[0] - map.view.corner[0]) / texel;
    row = (place[1] - map.view.corner[1]) / texel;
  }
  [[nodiscard]] float texel_m(const ShadowMap& map) const {
    return map.view.from_point ? texel * at_m.z() : texel;
  }
  /// The centres of a column and of a row on the picture plane.
  [[nodiscard]] float u(const ShadowMap& map, int x) const {
    return map.view.corner[0] + (static_cast<float>(x) + 0.5F) * texel;
  }
  [[nodiscard]] float v(const ShadowMap& map, int y) const {
    return map.view.corner[1] + (static_cast<float>(y) + 0.5F) * texel;
  }

  Eigen::Vector3f at_m;
  Eigen::Array2f place;
  float texel, column = 0, row = 0;
};

/// The column or row that a place in texels lies in; -1 outside the map.
int texel_of(float place, int size_px) {
  return place >= 0.0F && place < static_cast<float>(size_px) ? static_cast<int>(place) : -1;
}

/// What stands in a texel; infinity in none.
float found_in(const ShadowMap& map, int x, int y) {
  return x >= 0 && y >= 0 ? map.depth.at(x, y) : endless_m;
}

/// The nine texels of percentage-closer filtering, row by row, and what stands in each.
struct NineTexels {
  NineTexels(const ShadowMap& map, const SeenPoint& seen) {
    std::array<int, 3> x, y;
    for (int i = 0; i < 3; ++i) {
      x[i] = texel_of(seen.column + static_cast<float>(i - 1), map.depth.width_px);
      y[i] = texel_of(seen.row + static_cast<float>(i - 1), map.depth.height_px);
      u[i] = seen.u(map, x[i]);
      v[i] = seen.v(map, y[i]);
    }
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) found_m[3 * row + column] = found_in(map, x[column], y[row]);
  }
  [[nodiscard]] float nearest_m() const { return *std::min_element(found_m.begin(), found_m.end()); }
  [[nodiscard]] float farthest_m() const { return *std::max_element(found_m.begin(), found_m.end()); }

  std::array<float, 3> u, v;  ///< of the texels' centres on the picture plane
  std::array<float, 9> found_m;
};

/// A receiver as a light sees it: its plane's depth near it.
class Receiver {
 public:
  Receiver(const ShadowMap& map, const ShadowLookup& how, const SeenPoint& seen,
           const Eigen::Vector3f& normal)
      : map_(map), seen_(seen), normal_(map.view.axes * normal) {
    const Eigen::Vector3f along =
        map.view.from_point ? Eigen::Vector3f(seen.at_m.normalized()) : Eigen::Vector3f::UnitZ();
    const float cosine = std::max(std::abs(normal_.dot(along)), 1e-6F);
    const float tangent = std::min(std::sqrt(std::max(0.0F, 1.0F - cosine * cosine)) / cosine, steepest);
    bias_m_ = how.bias_texels * texel_m() * (1.0F + tangent);
  }

  [[nodiscard]] float depth_m() const { return seen_.at_m.z(); }
  [[nodiscard]] float texel_m() const { return seen_.texel_m(map_); }

  /// Depth of what stands in the light's way in the texel at an offset in texels; infinity where nothing
  /// does. `on_plane`: compared with the receiver's plane at the texel's centre instead of its own depth.
  [[nodiscard]] float blocker_m(float right, float down, bool on_plane) const {
    const int x = texel_of(seen_.column + right, map_.depth.width_px);
    const int y = texel_of(seen_.row + down, map_.depth.height_px);
    const float found_m = found_in(map_, x, y);
    if (found_m == endless_m) return endless_m;
    const float own_m = on_plane ? plane_m(seen_.u(map_, x), seen_.v(map_, y)) : depth_m();
    return is_in_the_way(found_m, own_m) ? found_m : endless_m;
  }

  /// Whether what stands in a texel, at a place of the picture plane, is in the light's way.
  [[nodiscard]] bool is_blocked(float found_m, float u, float v) const {
    return found_m != endless_m && is_in_the_way(found_m, plane_m(u, v));
  }

 private:
  [[nodiscard]] bool is_in_the_way(float found_m, float own_m) const { return found_m < own_m - bias_m_; }

  /// Depth of the receiver's plane at a place of the picture plane, no steeper than the bias knows.
  [[nodiscard]] float plane_m(float u, float v) const {
    const float right = u - seen_.place[0], down = v - seen_.place[1];
    if (map_.view.from_point) {
      const float along = normal_.dot(Eigen::Vector3f(u, v, 1.0F));
      const float facing = normal_.dot(seen_.at_m);
      const float found = facing / along;
      if (!std::isfinite(found)) return depth_m();
      if (std::abs(found - depth_m()) <
          0.99F * steepest * depth_m() * std::max(std::abs(right), std::abs(down)))
        return found;  // nearer than the way to it allows, which need not be known exactly
      const float farthest = std::hypot(right, down) * depth_m() * steepest;
      return std::clamp(found, depth_m() - farthest, depth_m() + farthest);
    }
    const float least = 1.0F / std::sqrt(1.0F + steepest * steepest);
    const float facing = normal_.z() < 0.0F ? std::min(normal_.z(), -least) : std::max(normal_.z(), least);
    return depth_m() - (normal_.x() * right + normal_.y() * down) / facing;
  }

  const ShadowMap& map_;
  const SeenPoint& seen_;
  Eigen::Vector3f normal_;
  float bias_m_ = 0;
};

/// Tap `number` of `count` over a unit disc, evenly by area (Vogel's spiral).
Eigen::Array2f disc_tap(int number, int count, float turn) {
  constexpr float golden = 2.39996322972865F;
  const float radius = std::sqrt((static_cast<float>(number) + 0.5F) / static_cast<float>(count));
  const float angle = golden * static_cast<float>(number) + 2.0F * std::numbers::pi_v<float> * turn;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

float percentage_closer(const ShadowMap& map, const ShadowLookup& how, const SeenPoint& seen,
                        const Eigen::Vector3f& normal) {
  const NineTexels texels(map, seen);
  // Most points lie far before or behind all nine, whichever way their plane is turned: the centres of texels
  // are at most 1.5 of them to the side and 1.5 down, and planes and bias are no steeper than they may be.
  const float turned_m = 2.2F * steepest * seen.texel_m(map);
  if (texels.nearest_m() > seen.at_m.z() + turned_m) return 1.0F;
  if (texels.farthest_m() <
      seen.at_m.z() - turned_m - how.bias_texels * seen.texel_m(map) * (1.01F + steepest))
    return 0.0F;
  const Receiver receiver(map, how, seen, normal);
  int arrives = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      arrives +=
          receiver.is_blocked(texels.found_m[3 * row + column], texels.u[column], texels.v[row]) ? 0 : 1;
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
  const SeenPoint seen(map, point_m);
  if (map.view.from_point && !(seen.at_m.z() > 0.0F)) return 1.0F;  // behind the lamp
  switch (how.filter) {
    case ShadowFilter::none:
      return one_texel({map, how, seen, normal});
    case ShadowFilter::pcf:
      return percentage_closer(map, how, seen, normal);
    case ShadowFilter::pcss:
      return soft(map, {map, how, seen, normal}, how.taps, turn);
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
