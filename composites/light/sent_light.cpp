#include "composites/light/sent_light.h"

#include <algorithm>
#include <memory>
#include <numbers>
#include <optional>

#include "raytracer/common/parallel.h"
#include "renderer/depth/depth_map.h"
#include "renderer/transport/transport.h"

namespace seamline::renderer {
namespace {

constexpr int samples_of_albedo = 64;
constexpr std::uint64_t received_seed = 0x5e47;
constexpr float least_albedo = 0.01F;
constexpr float noise_of_albedo = 0.1F;  ///< relative; what is implied above 1 by no more is noise

Eigen::Vector3f map_direction(double column, double row, int width, int height) {
  return panorama_direction(column, row, width, height).cast<float>();
}

/// The implied albedo in one texel; none where the depth map is a hole or no light arrives.
std::optional<Rgb> implied_albedo(const Geometry& local, const Light& light, int columns, int column,
                                  int row) {
  Rgb sent = Rgb::Zero(), received = Rgb::Zero();  // both as radiance: received at albedo 1
  for (int sample = 0; sample < samples_of_albedo; ++sample) {
    const Sampler sampler(received_seed, column, row, sample);
    const Eigen::Array2f within = sampler.point(dimension::pixel);
    const Eigen::Vector3f direction =
        map_direction(column + double{within[0]}, row + double{within[1]}, columns, columns / 2);
    std::optional<SurfacePoint> point = local.nearest({Eigen::Vector3f::Zero(), direction});
    if (!point) continue;
    point->albedo = Rgb::Ones();
    received += radiance_with_and_without(local, nullptr, *point, light, sampler).without_object.total();
    sent += light.environment->radiance(direction);
  }
  if (!(received > 0.0F).all()) return std::nullopt;
  return sent / received;
}

/// Whether something so bright shines itself.
bool is_source(const Rgb& radiance, const Rgb& implied, const std::optional<float>& white) {
  return white ? radiance.maxCoeff() >= 0.9F * *white : implied.maxCoeff() > 2.0F;
}

/// The panorama with surfaces that send no more than they receive.
std::shared_ptr<const EnvironmentMap> dimmed(const EnvironmentMap& panorama, const Geometry& local,
                                             const AlbedoMap& implied, const std::optional<float>& white,
                                             int threads) {
  Image out(panorama.width_px(), panorama.height_px(), 3);
  parallel_for(out.height_px, threads, [&](int row) {
    for (int column = 0; column < out.width_px; ++column) {
      const Eigen::Vector3f direction = map_direction(column + 0.5, row + 0.5, out.width_px, out.height_px);
      const Rgb albedo = implied.at(direction), radiance = panorama.texel(column, row);
      const bool is_dimmed = (albedo > 1.0F + noise_of_albedo).any() && !is_source(radiance, albedo, white) &&
                             local.occluded({Eigen::Vector3f::Zero(), direction});
      out.set_rgb(column, row, is_dimmed ? Rgb(radiance / albedo.max(1.0F)) : radiance);
    }
  });
  return std::make_shared<const EnvironmentMap>(std::move(out), 0.0F);
}

}  // namespace

int implied_albedo_columns(const std::optional<double>& error) {
  constexpr double lax_error = 0.02;
  return error.value_or(0) >= lax_error ? 128 : 256;
}

SentLight follow_received_light(const std::shared_ptr<Geometry>& local, Light& light,
                                const std::optional<float>& white, int columns, int threads) {
  light.photographed = local;
  const int width_px = columns, height_px = columns / 2;
  AlbedoMap implied{.width_px = width_px,
                    .height_px = height_px,
                    .texels = {},
                    .known = {},
                    .elsewhere = Rgb::Constant(0.5F)};
  implied.texels.assign(static_cast<std::size_t>(width_px * height_px), implied.elsewhere);
  implied.known.assign(implied.texels.size(), 0);
  parallel_for(height_px, threads, [&](int row) {
    for (int column = 0; column < width_px; ++column)
      if (const auto albedo = implied_albedo(*local, light, columns, column, row)) {
        implied.texels[implied.index(column, row)] = *albedo;
        implied.known[implied.index(column, row)] = 1;
      }
  });
  SentLight said;
  double known_sr = 0, above_sr = 0;
  for (int row = 0; row < height_px; ++row)
    for (int column = 0; column < width_px; ++column) {
      const std::size_t i = implied.index(column, row);
      if (implied.known[i] == 0) continue;
      const double solid_angle_sr = texel_solid_angle_sr(row, width_px, height_px);
      known_sr += solid_angle_sr;
      const float most = implied.texels[i].maxCoeff();
      const Rgb shown =
          light.environment->radiance(map_direction(column + 0.5, row + 0.5, width_px, height_px));
      if (is_source(shown, implied.texels[i], white)) continue;
      if (most > 1.0F + noise_of_albedo) above_sr += solid_angle_sr;
      said.most_albedo = std::max(said.most_albedo, double{most});
    }
  if (above_sr > 0) {
    said.share_above_one = above_sr / known_sr;
    light.environment = dimmed(*light.environment, *local, implied, white, threads);
  }
  for (Rgb& albedo : implied.texels) albedo = albedo.max(least_albedo).min(1.0F);
  local->paint(std::make_shared<const AlbedoMap>(std::move(implied)));
  return said;
}

}  // namespace seamline::renderer
