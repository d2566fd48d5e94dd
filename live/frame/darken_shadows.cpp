#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "live/frame/caster_blocks.h"
#include "live/frame/codes.h"
#include "live/frame/fitted_surface.h"
#include "live/frame/live_eye.h"
#include "live/frame/pixel_rays.h"
#include "raytracer/common/parallel.h"
#include "renderer/realtime/depth_normals.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::live {
namespace {

constexpr std::size_t most_lights = 64;  ///< of a bit each; light of the others is not taken away

/// The part of a light's picture in which the objects lie. Without maps: all of it.
struct Window {
  Eigen::Matrix3f axes;
  Eigen::Vector3f eye_m;
  bool from_point = false;
  float left = 0, right = 0, top = 0, bottom = 0;
};

Window window_of(const renderer::DrawView& view) {
  return {view.axes,
          view.eye_m,
          view.from_point,
          view.corner[0],
          view.corner[0] + view.size[0],
          view.corner[1],
          view.corner[1] + view.size[1]};
}

/// A row of pixels in a light's axes: the pixel x at planar depth z is at `start + z (first + x step)`.
struct RowInWindow {
  Eigen::Vector3f start, first, step;
};

/// 1 where a row's pixels lie in the window, else 0. Plain arithmetic over arrays, so that it is done for
/// several pixels at once; infinite depth is no place at all.
void find_inside(const Window& window, const RowInWindow& row, const float* depth_m, int width_px,
                 std::int32_t* inside) {
  for (int x = 0; x < width_px; ++x) {
    const float z = depth_m[x], column = static_cast<float>(x);
    float u = row.start.x() + z * (row.first.x() + column * row.step.x());
    float v = row.start.y() + z * (row.first.y() + column * row.step.y());
    if (window.from_point) {
      const float over = 1.0F / (row.start.z() + z * (row.first.z() + column * row.step.z()));
      u *= over;
      v *= over;
    }
    const bool is_inside = (u >= window.left) & (u <= window.right) & (v >= window.top) &
                           (v <= window.bottom) & (z < std::numeric_limits<float>::max());
    inside[x] = is_inside ? 1 : 0;
  }
}

class Darkening {
 public:
  Darkening(const ShadowPass& pass, LiveEye& eye)
      : scene_(pass.scene),
        shadows_(pass.shadows),
        surface_reach_px_(pass.surface_reach_px),
        eye_(eye),
        rays_(eye.view, eye.codes.width_px, eye.codes.height_px),
        lights_(std::min(scene_.light_count(), most_lights)),
        ambient_w_m2_(std::numbers::pi_v<float> * scene_.ambient_radiance) {
    if (!shadows_.object) return;
    for (const renderer::ShadowMap& map : shadows_.object->suns) windows_.push_back(window_of(map.view));
    for (const renderer::ShadowMap& map : shadows_.object->lamps) windows_.push_back(window_of(map.view));
    if (shadows_.method == Shadows::pcss) return;  // its taps reach as far as its light is large
    for (const renderer::ShadowMap& map : shadows_.object->suns) casters_.emplace_back(map);
    for (const renderer::ShadowMap& map : shadows_.object->lamps) casters_.emplace_back(map);
  }

  void darken_row(int y) {
    const int width_px = eye_.codes.width_px;
    std::vector<std::uint64_t> marks(width_px, windows_.empty() ? all_lights() : 0);
    const float* depth_m = &eye_.real.depth_m[grid_index(y, 0, width_px)];
    std::vector<std::int32_t> inside(width_px);
    for (std::size_t i = 0; i < std::min(lights_, windows_.size()); ++i) {
      const Window& window = windows_[i];
      find_inside(window,
                  {window.axes * (rays_.eye_m() - window.eye_m), window.axes * rays_.direction(0, y),
                   window.axes * rays_.right_per_px()},
                  depth_m, width_px, inside.data());
      for (int x = 0; x < width_px; ++x) marks[x] |= static_cast<std::uint64_t>(inside[x]) << i;
    }
    for (int x = 0; x < width_px; ++x)
      if (marks[x] != 0 && std::isfinite(depth_m[x])) darken_pixel(x, y, depth_m[x], marks[x]);
  }

 private:
  [[nodiscard]] std::uint64_t all_lights() const {
    return lights_ == most_lights ? ~std::uint64_t{0} : (std::uint64_t{1} << lights_) - 1;
  }

  void darken_pixel(int x, int y, float planar_m, std::uint64_t marks) {
    const std::size_t pixel = grid_index(y, x, eye_.codes.width_px);
    if (eye_.covered[pixel] != 0) return;
    const Eigen::Vector3f direction = rays_.direction(x, y);
    marks = marks_near_casters(rays_.eye_m() + planar_m * direction, marks);
    if (marks == 0) return;
    const FittedSurface surface = surface_at(x, y, planar_m);
    const LitPoint point{rays_.eye_m() + surface.planar_m * direction, surface.normal,
                         surface.planar_m * direction.norm(), turn_of_pixel(x, y)};
    std::array<float, most_lights> passes_object;
    bool any_taken = false;
    for (std::size_t i = 0; i < lights_; ++i) {
      passes_object[i] = 1;
      if ((marks >> i & 1U) == 0) continue;
      const SeenLight seen = seen_light(scene_.light, i, point.position_m);
      passes_object[i] = shadows_.arriving(Caster::object, i, seen, point);
      any_taken = any_taken || passes_object[i] < 1.0F;
    }
    if (any_taken) apply(pixel, point, passes_object);
  }

  /// The marked lights whose map has something near a point.
  [[nodiscard]] std::uint64_t marks_near_casters(const Eigen::Vector3f& point_m, std::uint64_t marks) const {
    for (std::size_t i = 0; i < std::min(lights_, casters_.size()); ++i) {
      if ((marks >> i & 1U) == 0) continue;
      const Window& window = windows_[i];
      const Eigen::Vector3f seen = window.axes * (point_m - window.eye_m);
      const float over = window.from_point ? 1.0F / seen.z() : 1.0F;
      if (!casters_[i].near(seen.x() * over, seen.y() * over)) marks &= ~(std::uint64_t{1} << i);
    }
    return marks;
  }

  /// What receives the shadow. At a reach of one pixel, and where no plane fits, it is the pixel's own depth
  /// and the cross product of its neighbours'.
  [[nodiscard]] FittedSurface surface_at(int x, int y, float planar_m) const {
    if (surface_reach_px_ > 1)
      if (const auto fitted = fitted_surface(eye_.real, rays_, x, y, surface_reach_px_)) return *fitted;
    const Eigen::Vector3f normal = renderer::cross_product_normal(eye_.real, eye_.view, x, y);
    return {planar_m,
            normal.squaredNorm() > 0.0F ? normal : Eigen::Vector3f(-rays_.direction(x, y).normalized())};
  }

  void apply(std::size_t pixel, const LitPoint& point, const std::array<float, most_lights>& passes_object) {
    Rgb with = ambient_w_m2_, without = ambient_w_m2_;
    for (std::size_t i = 0; i < lights_; ++i) {
      const SeenLight seen = seen_light(scene_.light, i, point.position_m);
      const float cosine = point.normal.dot(seen.to_light);
      if (!(cosine > 0.0F)) continue;
      const float passes_real = shadows_.arriving(Caster::real, i, seen, point);
      const Rgb arrives = seen.irradiance_w_m2 * (cosine * passes_real);
      without += arrives;
      with += arrives * passes_object[i];
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const auto channel = static_cast<Eigen::Index>(c);
      if (!(without[channel] > 0.0F) || with[channel] == without[channel]) continue;
      std::uint8_t& code = eye_.codes.values[3 * pixel + c];
      code = codes_.code(codes_.linear(code) * (with[channel] / without[channel]));
    }
  }

  const LiveScene& scene_;
  const ShadowAnswers& shadows_;
  int surface_reach_px_;
  LiveEye& eye_;
  PixelRays rays_;
  std::size_t lights_;
  Rgb ambient_w_m2_;
  std::vector<Window> windows_;
  std::vector<CasterBlocks> casters_;  ///< of the windows, but for `pcss`
  const CodeTables& codes_ = code_tables();
};

}  // namespace

void darken_shadows(const ShadowPass& pass, LiveEye& eye) {
  if (pass.shadows.method == Shadows::none || pass.scene.light_count() == 0) return;
  Darkening darkening(pass, eye);
  renderer::parallel_for(eye.codes.height_px, pass.threads, [&](int y) { darkening.darken_row(y); });
}

}  // namespace seamline::live
