#include "composites/light/clipped_sources.h"

#include <algorithm>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "raytracer/common/parallel.h"
#include "renderer/depth/depth_map.h"
#include "renderer/transport/transport.h"

namespace seamline::renderer {
namespace {

constexpr float clipped_share_of_white = 0.98F;
constexpr int clipped_map_px = 64, clipped_map_rows = clipped_map_px / 2, samples_of_clipped = 64;
constexpr int clipped_light_px = 512;
constexpr std::uint64_t clipped_seed = 0xc11b;
constexpr double left_out_share = 0.02, least_clipped_part = 0.1, most_clipped_factor = 1e5;

bool is_clipped(const Rgb& radiance, float white) {
  return radiance.maxCoeff() >= clipped_share_of_white * white;
}

/// What is clipped, and what is not, each as a light of its own; smaller than the panorama.
struct PartedLight {
  Light clipped, rest;
};

PartedLight parted_light(const Image& panorama, const Geometry& local, float white) {
  const int step = std::max(1, panorama.width_px / clipped_light_px);
  Image clipped(panorama.width_px / step, panorama.height_px / step, 3), rest = clipped;
  const float share = 1.0F / static_cast<float>(step * step);
  for (int y = 0; y < clipped.height_px * step; ++y)
    for (int x = 0; x < clipped.width_px * step; ++x) {
      const Rgb radiance = panorama.rgb(x, y);
      Image& part = is_clipped(radiance, white) ? clipped : rest;
      part.set_rgb(x / step, y / step, part.rgb(x / step, y / step) + share * radiance);
    }
  const auto light_of = [&](Image&& part) {
    Light light;
    light.environment = std::make_shared<const EnvironmentMap>(std::move(part), 0.0F);
    light.photographed = std::shared_ptr<const Geometry>(std::shared_ptr<const Geometry>(), &local);
    light.bounces = 0;
    return light;
  };
  return {light_of(std::move(clipped)), light_of(std::move(rest))};
}

/// The factor that one texel asks for, and how much of all directions it is.
struct AskedFactor {
  double factor = 0, solid_angle_sr = 0;
};

std::optional<AskedFactor> clipped_factor_at(const PartedLight& light, const Geometry& local,
                                             const Image& panorama, float white, int column, int row) {
  float sent = 0, by_clipped = 0, by_rest = 0;
  for (int i = 0; i < samples_of_clipped; ++i) {
    const Sampler sampler(clipped_seed, column, row, i);
    const Eigen::Array2f within = sampler.point(dimension::pixel);
    const double x = (column + double{within[0]}) / clipped_map_px,
                 y = (row + double{within[1]}) / clipped_map_rows;
    const Rgb shown =
        panorama.rgb(std::min(static_cast<int>(x * panorama.width_px), panorama.width_px - 1),
                     std::min(static_cast<int>(y * panorama.height_px), panorama.height_px - 1));
    if (is_clipped(shown, white)) continue;
    const Eigen::Vector3f direction =
        panorama_direction(x * clipped_map_px, y * clipped_map_rows, clipped_map_px, clipped_map_rows)
            .cast<float>();
    std::optional<SurfacePoint> point = local.nearest({Eigen::Vector3f::Zero(), direction});
    if (!point) continue;
    point->albedo = Rgb::Ones();
    sent += shown.mean();
    by_clipped += leaving_pair(local, nullptr, *point, light.clipped, sampler).without_object.total().mean();
    by_rest += leaving_pair(local, nullptr, *point, light.rest, sampler).without_object.total().mean();
  }
  if (!(by_clipped > static_cast<float>(least_clipped_part) * (by_clipped + by_rest))) return std::nullopt;
  return AskedFactor{double{sent - by_rest} / double{by_clipped},
                     texel_solid_angle_sr(row, clipped_map_px, clipped_map_rows)};
}

}  // namespace

ClippedSources find_clipped_sources(const Image& panorama, const Geometry& local, float white, int threads) {
  ClippedSources found;
  for (int y = 0; y < panorama.height_px; ++y) {
    int clipped = 0;
    for (int x = 0; x < panorama.width_px; ++x) clipped += is_clipped(panorama.rgb(x, y), white) ? 1 : 0;
    found.share +=
        clipped * texel_solid_angle_sr(y, panorama.width_px, panorama.height_px) / (4 * std::numbers::pi);
  }
  if (!(found.share > 0)) return found;
  const PartedLight light = parted_light(panorama, local, white);
  std::vector<std::optional<AskedFactor>> asked(std::size_t{clipped_map_px} * std::size_t{clipped_map_rows});
  parallel_for(clipped_map_rows, threads, [&](int row) {
    for (int column = 0; column < clipped_map_px; ++column)
      asked[static_cast<std::size_t>(row) * std::size_t{clipped_map_px} + static_cast<std::size_t>(column)] =
          clipped_factor_at(light, local, panorama, white, column, row);
  });
  std::vector<AskedFactor> factors;
  double reached_sr = 0;
  for (const auto& one : asked)
    if (one) factors.push_back(*one), reached_sr += one->solid_angle_sr;
  std::sort(factors.begin(), factors.end(),
            [](const AskedFactor& a, const AskedFactor& b) { return a.factor > b.factor; });
  double passed_sr = 0;
  for (const AskedFactor& one : factors) {
    passed_sr += one.solid_angle_sr;
    if (passed_sr < left_out_share * reached_sr) continue;
    found.factor = std::clamp(one.factor, 1.0, most_clipped_factor);
    break;
  }
  return found;
}

void raise_clipped_sources(Image& panorama, float white, double factor) {
  for (int y = 0; y < panorama.height_px; ++y)
    for (int x = 0; x < panorama.width_px; ++x)
      if (const Rgb radiance = panorama.rgb(x, y); is_clipped(radiance, white))
        panorama.set_rgb(x, y, static_cast<float>(factor) * radiance);
}

}  // namespace seamline::renderer
