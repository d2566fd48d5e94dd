#include "composites/light/clipped_sources.h"

#include <algorithm>
#include <functional>
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
constexpr double grey_albedo = 0.5;

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

/// What the surfaces in one texel send, and what white ones would receive there from what is clipped and from
/// the rest: linear colours, means over the texel.
struct SeenSurfaces {
  Eigen::Array3d sent = Eigen::Array3d::Zero(), by_clipped = sent, by_rest = sent;
  double solid_angle_sr = 0;
};

/// The least factor with which no colour of these surfaces is sent brighter than it is received.
double factor_of_white(const SeenSurfaces& seen) {
  double factor = 0;
  for (int c = 0; c < 3; ++c)
    if (seen.by_clipped[c] > least_clipped_part * seen.by_clipped.maxCoeff())
      factor = std::max(factor, (seen.sent[c] - seen.by_rest[c]) / seen.by_clipped[c]);
  return factor;
}

/// The factor with which these surfaces have this albedo, over all colours.
double factor_of_albedo(const SeenSurfaces& seen, double albedo) {
  return (seen.sent.mean() / albedo - seen.by_rest.mean()) / seen.by_clipped.mean();
}

/// What a share of the solid angle exceeds.
double exceeded_by(double share, const std::vector<SeenSurfaces>& seen,
                   const std::function<double(const SeenSurfaces&)>& value) {
  std::vector<std::pair<double, double>> values;
  double all_sr = 0, passed_sr = 0;
  for (const SeenSurfaces& one : seen)
    values.emplace_back(value(one), one.solid_angle_sr), all_sr += one.solid_angle_sr;
  std::sort(values.begin(), values.end(), std::greater<>());
  for (const auto& [number, solid_angle_sr] : values) {
    passed_sr += solid_angle_sr;
    if (passed_sr >= share * all_sr) return number;
  }
  return 0;
}

std::optional<SeenSurfaces> surfaces_at(const PartedLight& light, const Geometry& local,
                                        const Image& panorama, float white, int column, int row) {
  SeenSurfaces seen;
  int met = 0;
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
    ++met;
    seen.sent += shown.cast<double>();
    seen.by_clipped += radiance_with_and_without(local, nullptr, *point, light.clipped, sampler)
                           .without_object.total()
                           .cast<double>();
    seen.by_rest += radiance_with_and_without(local, nullptr, *point, light.rest, sampler)
                        .without_object.total()
                        .cast<double>();
  }
  if (!(seen.by_clipped.mean() > 0)) return std::nullopt;
  for (Eigen::Array3d* mean : {&seen.sent, &seen.by_clipped, &seen.by_rest}) *mean /= met;
  seen.solid_angle_sr = texel_solid_angle_sr(row, clipped_map_px, clipped_map_rows);
  return seen;
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
  std::vector<std::optional<SeenSurfaces>> texels(std::size_t{clipped_map_px} *
                                                  std::size_t{clipped_map_rows});
  parallel_for(clipped_map_rows, threads, [&](int row) {
    for (int column = 0; column < clipped_map_px; ++column)
      texels[static_cast<std::size_t>(row) * std::size_t{clipped_map_px} + static_cast<std::size_t>(column)] =
          surfaces_at(light, local, panorama, white, column, row);
  });
  std::vector<SeenSurfaces> reached;
  for (const auto& texel : texels)
    if (texel) reached.push_back(*texel);
  // What is hardly reached says little: its factor is noise over nearly nothing.
  const auto clipped = [](const SeenSurfaces& one) { return one.by_clipped.mean(); };
  const double most = exceeded_by(left_out_share, reached, clipped);
  std::erase_if(reached, [&](const SeenSurfaces& one) { return clipped(one) < least_clipped_part * most; });
  const auto possible = [](double factor) { return std::clamp(factor, 1.0, most_clipped_factor); };
  found.factor = possible(exceeded_by(left_out_share, reached, factor_of_white));
  found.factor_of_grey = possible(
      exceeded_by(0.5, reached, [](const SeenSurfaces& one) { return factor_of_albedo(one, grey_albedo); }));
  return found;
}

void raise_clipped_sources(Image& panorama, float white, double factor) {
  for (int y = 0; y < panorama.height_px; ++y)
    for (int x = 0; x < panorama.width_px; ++x)
      if (const Rgb radiance = panorama.rgb(x, y); is_clipped(radiance, white))
        panorama.set_rgb(x, y, static_cast<float>(factor) * radiance);
}

}  // namespace seamline::renderer
