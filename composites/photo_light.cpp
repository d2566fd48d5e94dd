#include "composites/photo_light.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "raytracer/tracing/geometry.h"
#include "renderer/depth/depth_map.h"
#include "support/text/request_name.h"

namespace seamline::renderer {
namespace {

constexpr double down_to = 0.1, largest_radius_deg = 5, least_share = 0.05;

double brightness(const Rgb& radiance) {
  return 0.2126 * double{radiance[0]} + 0.7152 * double{radiance[1]} + 0.0722 * double{radiance[2]};
}

struct Texel {
  int x, y;
};

/// Texels of an equirectangular picture, connected through sides and corners and over its left and right
/// edge.
class TexelRegion {
 public:
  TexelRegion(int width, int height)
      : width_(width),
        height_(height),
        inside_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  template <class Belongs>
  void grow(Texel from, const Belongs& belongs) {
    std::vector<Texel> open{from};
    set(from);
    while (!open.empty()) {
      const Texel at = open.back();
      open.pop_back();
      texels.push_back(at);
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const Texel next{(at.x + dx + width_) % width_, at.y + dy};
          if (next.y < 0 || next.y >= height_ || has(next) || !belongs(next)) continue;
          set(next);
          open.push_back(next);
        }
    }
  }
  /// Texels that touch it.
  [[nodiscard]] std::vector<Texel> border(int reach) const {
    TexelRegion known = *this;
    std::vector<Texel> around;
    for (const Texel& at : texels)
      for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
          const Texel next{((at.x + dx) % width_ + width_) % width_, at.y + dy};
          if (next.y < 0 || next.y >= height_ || known.has(next)) continue;
          known.set(next);
          around.push_back(next);
        }
    return around;
  }

  std::vector<Texel> texels;

 private:
  [[nodiscard]] std::size_t index(Texel t) const {
    return static_cast<std::size_t>(t.y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(t.x);
  }
  [[nodiscard]] bool has(Texel t) const { return inside_[index(t)] != 0; }
  void set(Texel t) { inside_[index(t)] = 1; }

  int width_, height_;
  std::vector<char> inside_;
};

Eigen::Vector3d direction_of(const Image& panorama, Texel t) {
  return panorama_direction(t.x + 0.5, t.y + 0.5, panorama.width_px, panorama.height_px);
}

}  // namespace

std::optional<SplitSun> split_sun(Image& panorama,
                                  const std::function<bool(const Eigen::Vector3f&)>& is_sky) {
  const int width = panorama.width_px, height = panorama.height_px;
  double peak = 0;
  Texel brightest{0, 0};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (const double here = brightness(panorama.rgb(x, y));
          here > peak && is_sky(direction_of(panorama, {x, y}).cast<float>()))
        peak = here, brightest = {x, y};
  if (!(peak > 0)) return std::nullopt;
  TexelRegion region(width, height);
  region.grow(brightest, [&](Texel t) { return brightness(panorama.rgb(t.x, t.y)) >= down_to * peak; });
  Rgb around = Rgb::Zero();
  const std::vector<Texel> border = region.border(2);
  for (const Texel& t : border) around += panorama.rgb(t.x, t.y) / static_cast<float>(border.size());
  SplitSun split;
  Eigen::Vector3d towards = Eigen::Vector3d::Zero();
  Eigen::Array3d irradiance = Eigen::Array3d::Zero();
  for (const Texel& t : region.texels) {
    const double texel_sr = texel_solid_angle_sr(t.y, width, height);
    const Rgb more = (panorama.rgb(t.x, t.y) - around).max(0.0F);
    split.solid_angle_sr += texel_sr;
    irradiance += more.cast<double>() * texel_sr;
    towards += direction_of(panorama, t) * (brightness(more) * texel_sr);
  }
  if (!(towards.norm() > 0)) return std::nullopt;
  towards.normalize();
  const double radius_rad = std::acos(std::max(-1.0, 1 - split.solid_angle_sr / (2 * std::numbers::pi)));
  double facing = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      facing += brightness(panorama.rgb(x, y)) * texel_solid_angle_sr(y, width, height) *
                std::max(0.0, direction_of(panorama, {x, y}).dot(towards));
  split.share = brightness(irradiance.cast<float>()) / facing;
  if (radius_rad > largest_radius_deg * std::numbers::pi / 180 || split.share < least_share)
    return std::nullopt;
  split.sun = {towards.cast<float>(), irradiance.cast<float>(), static_cast<float>(radius_rad)};
  for (const Texel& t : region.texels) panorama.set_rgb(t.x, t.y, around.min(panorama.rgb(t.x, t.y)));
  return split;
}

std::string sun_text(const SplitSun& split) {
  const Eigen::Vector3f& to = split.sun.to_sun;
  const Rgb& light = split.sun.irradiance_w_m2;
  return fmt::format(
      "{} {:.4f} {:.4f} {:.4f} {} {:.4g} {:.4g} {:.4g} {} {:.3g} (solid angle "
      "{:.3g} sr; {:.0f} % of the irradiance of a surface that faces it)",
      request_name("to_sun"), to.x(), to.y(), to.z(), request_name("sun_irradiance"), light[0], light[1],
      light[2], request_name("sun_radius"), double{split.sun.angular_radius_rad} * 180 / std::numbers::pi,
      split.solid_angle_sr, 100 * split.share);
}

double open_share(const Geometry& depth) {
  constexpr int width = 256, height = width / 2;
  double open = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (!depth.occluded(
              {Eigen::Vector3f::Zero(), panorama_direction(x + 0.5, y + 0.5, width, height).cast<float>()}))
        open += texel_solid_angle_sr(y, width, height);
  return open / (4 * std::numbers::pi);
}

}  // namespace seamline::renderer
