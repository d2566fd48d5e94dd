#include "raytracer/light/lamps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace seamline::renderer {
namespace {

constexpr std::size_t most_weighed_lamps = 16;

float light_luminance(const Rgb& light) {
  return 0.2126F * light[0] + 0.7152F * light[1] + 0.0722F * light[2];
}

/// What a lamp would send through a point's horizon, up to a factor.
float weight_at(const Lamp& lamp, const SurfacePoint& point) {
  const Eigen::Vector3f to_lamp = lamp.position_m - point.position_m;
  const float squared = to_lamp.squaredNorm();
  if (!(squared > 0.0F)) return 0.0F;
  const Eigen::Vector3f direction = to_lamp / std::sqrt(squared);
  if (!above_horizon(point, direction)) return 0.0F;
  return light_luminance(intensity_towards(lamp, -direction)) / squared;
}

template <class Weight>
std::optional<ChosenLamp> choose_by(std::span<const Lamp> lamps, float choice, const Weight& weight) {
  float sum = 0;
  for (const Lamp& lamp : lamps) sum += weight(lamp);
  if (!(sum > 0.0F) || !std::isfinite(sum)) return std::nullopt;
  float left = choice * sum;
  std::optional<ChosenLamp> chosen;
  for (const Lamp& lamp : lamps) {
    const float own = weight(lamp);
    if (own <= 0.0F) continue;
    chosen = {&lamp, own / sum};
    if (left < own) break;
    left -= own;
  }
  return chosen;
}

}  // namespace

Rgb intensity_towards(const Lamp& lamp, const Eigen::Vector3f& away) {
  if (!lamp.is_spot) return lamp.intensity_w_sr;
  const float ramp =
      (lamp.axis.dot(away) - lamp.outer_cosine) / std::max(1e-3F, lamp.inner_cosine - lamp.outer_cosine);
  const float share = std::clamp(ramp, 0.0F, 1.0F);
  return lamp.intensity_w_sr * (share * share);
}

std::optional<ChosenLamp> choose_lamp(std::span<const Lamp> lamps, const SurfacePoint& point, float choice) {
  if (lamps.size() > most_weighed_lamps)
    return choose_by(lamps, choice, [](const Lamp& lamp) { return light_luminance(lamp.intensity_w_sr); });
  return choose_by(lamps, choice, [&](const Lamp& lamp) { return weight_at(lamp, point); });
}

EmittingSurfaces::EmittingSurfaces(std::span<const std::shared_ptr<const SurfaceMesh>> background,
                                   std::shared_ptr<const BrightPatches> patches)
    : meshes_(background.begin(), background.end()),
      density_m2_(background.size()),
      patches_(std::move(patches)) {
  double sum = 0;
  for (std::size_t m = 0; m < meshes_.size(); ++m) {
    const SurfaceMesh& mesh = *meshes_[m];
    const double emission = static_cast<double>(light_luminance(mesh.emission));
    if (!(emission > 0)) continue;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      const Eigen::Vector3d first = mesh.positions_m[a].cast<double>();
      const double area_m2 = 0.5 * (mesh.positions_m[b].cast<double>() - first)
                                       .cross(mesh.positions_m[c].cast<double>() - first)
                                       .norm();
      if (!(area_m2 > 0)) continue;
      triangles_.push_back({static_cast<std::uint32_t>(m), static_cast<std::uint32_t>(t)});
      shares_.push_back(sum += area_m2 * emission);
    }
  }
  for (double& share : shares_) share /= sum;
  for (std::size_t m = 0; m < meshes_.size(); ++m)
    if (sum > 0)
      density_m2_[m] = static_cast<float>(static_cast<double>(light_luminance(meshes_[m]->emission)) / sum);
}

EmittingSurfaces::Place EmittingSurfaces::sample(float choice, const Eigen::Array2f& point) const {
  const auto found = std::upper_bound(shares_.begin(), shares_.end(), static_cast<double>(choice));
  const auto index = std::min(static_cast<std::size_t>(found - shares_.begin()), triangles_.size() - 1);
  const SurfaceMesh& mesh = *meshes_[triangles_[index].mesh];
  const auto& [a, b, c] = mesh.triangles[triangles_[index].triangle];
  const float root = std::sqrt(point[0]);
  const float u = root * (1.0F - point[1]), v = root * point[1];
  const Eigen::Vector3f& first = mesh.positions_m[a];
  const Eigen::Vector3f along = mesh.positions_m[b] - first, across = mesh.positions_m[c] - first;
  return {first + u * along + v * across, along.cross(across).normalized(),
          emission_at(mesh, triangles_[index].triangle, u, v), density_m2_[triangles_[index].mesh]};
}

}  // namespace seamline::renderer
