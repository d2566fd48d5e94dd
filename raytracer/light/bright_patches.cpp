#include "raytracer/light/bright_patches.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "raytracer/light/light.h"
#include "raytracer/material/hemisphere.h"
#include "raytracer/tracing/geometry.h"

namespace seamline::renderer {
namespace {

constexpr int rays_of_lamp = 1024;
constexpr int most_of_lamp = 3;           ///< a lamp in a corner
constexpr float nearest_share = 0.2F;     ///< of the way to what else the lamp lights
constexpr float least_share = 0.01F;      ///< of a lamp's light, sent on by a spot
constexpr float largest_aim = 0.5F;       ///< of the paths that leave a point
constexpr float least_cosine = 0.1F;      ///< at the lamp, of the spot's edge: ten heights away
constexpr float roughest_mirror = 0.25F;  ///< alpha, as in `blur_after`

float light_luminance_of(const Rgb& light) {
  return 0.2126F * light[0] + 0.7152F * light[1] + 0.0722F * light[2];
}

/// Directions all over the sphere, as far from each other as can be (a Fibonacci lattice).
Eigen::Vector3f lattice_direction(int number, int count) {
  const double height = 1.0 - (2.0 * number + 1.0) / count;
  const double angle = 2.0 * std::numbers::pi * number / std::numbers::phi;
  const double sine = std::sqrt(1.0 - height * height);
  return Eigen::Vector3d(sine * std::cos(angle), height, sine * std::sin(angle)).cast<float>();
}

/// What a ray of a lamp met.
struct LitPlace {
  SurfacePoint surface;
  float sent = 0;  ///< luminance of the lamp's light that the surface sends on, W/sr
};

std::vector<LitPlace> lit_places(const Lamp& lamp, const Geometry& everything) {
  std::vector<LitPlace> places;
  for (int i = 0; i < rays_of_lamp; ++i) {
    const Eigen::Vector3f direction = lattice_direction(i, rays_of_lamp);
    const float intensity = light_luminance_of(intensity_towards(lamp, direction));
    if (!(intensity > 0.0F)) continue;
    const auto hit = everything.nearest({lamp.position_m, direction});
    if (hit && hit->distance_m > 0.0F)
      places.push_back({*hit, intensity * light_luminance_of(hit->albedo + hit->f0)});
  }
  return places;
}

/// Takes away the places that lie on the plane of the nearest, and returns them as a spot.
BrightPatch take_nearest(const Lamp& lamp, std::vector<LitPlace>& places) {
  const auto nearest = std::min_element(places.begin(), places.end(), [](const auto& a, const auto& b) {
    return a.surface.distance_m < b.surface.distance_m;
  });
  BrightPatch patch;
  patch.normal = nearest->surface.geometric_normal;
  patch.height_m = patch.normal.dot(lamp.position_m - nearest->surface.position_m);
  patch.foot_m = lamp.position_m - patch.height_m * patch.normal;
  float sent = 0;
  std::erase_if(places, [&](const LitPlace& place) {
    const float depth_m = patch.normal.dot(lamp.position_m - place.surface.position_m);
    const bool lies_on_it = depth_m > 0.0F && depth_m <= 2.0F * patch.height_m;
    if (lies_on_it) sent += place.sent;
    return lies_on_it;
  });
  // Of the radiant flux (4 pi over the rays), sent on by Lambert's law: a pi-th along the normal.
  patch.strength_w_sr = 4.0F * sent / static_cast<float>(rays_of_lamp);
  return patch;
}

struct Surroundings {
  float sent = 0;            ///< mean over a lamp's rays, W/sr
  float squared_way_m2 = 0;  ///< mean
};
Surroundings surroundings(const std::vector<LitPlace>& places) {
  Surroundings out;
  for (const LitPlace& place : places) {
    out.sent += place.sent / static_cast<float>(rays_of_lamp);
    out.squared_way_m2 +=
        place.surface.distance_m * place.surface.distance_m / static_cast<float>(places.size());
  }
  return out;
}

/// The spots of one lamp; adds what its other light comes to.
void add_spots(const Lamp& lamp, const Geometry& everything, BrightPatches& bright) {
  std::vector<LitPlace> places = lit_places(lamp, everything);
  std::vector<BrightPatch> near;
  for (int i = 0; i < most_of_lamp && !places.empty(); ++i) {
    std::vector<LitPlace> others = places;
    const BrightPatch patch = take_nearest(lamp, others);
    const Surroundings beyond = surroundings(others);
    if (!(patch.height_m > 0.0F) || others.empty() ||
        patch.height_m > nearest_share * std::sqrt(beyond.squared_way_m2))
      break;
    if (patch.strength_w_sr > least_share * 4.0F * light_luminance_of(lamp.intensity_w_sr))
      near.push_back(patch);
    places = std::move(others);
  }
  const Surroundings rest = surroundings(places);
  if (rest.squared_way_m2 > 0.0F) bright.elsewhere_w_m2 += 2.0F * rest.sent / rest.squared_way_m2;
  bright.patches.insert(bright.patches.end(), near.begin(), near.end());
}

/// What the sky and the suns come to, as irradiance that other surfaces send.
float outside_w_m2(const Light& light) {
  constexpr float pi = std::numbers::pi_v<float>;
  Rgb sum = pi * light.environment_radiance;
  if (light.environment) sum += 0.25F * light.environment->total_w_m2();
  for (const Sun& sun : light.suns) sum += 0.25F * sun.irradiance_w_m2;
  return light_luminance_of(sum);
}

/// What a spot sends to a point if nothing is in the way, W/m2.
float sent_to(const BrightPatch& patch, const SurfacePoint& from) {
  const Eigen::Vector3f away = from.position_m - patch.foot_m;
  const float height_m = patch.normal.dot(away);
  const float squared = away.squaredNorm();
  if (!(height_m > 0.0F)) return 0.0F;
  const float facing = -from.normal.dot(away);
  if (!(facing > 0.0F)) return 0.0F;
  return patch.strength_w_sr * facing * height_m / (squared * (squared + patch.height_m * patch.height_m));
}

}  // namespace

std::shared_ptr<const BrightPatches> find_bright_patches(const Light& light, const Geometry& everything) {
  BrightPatches bright;
  for (const Lamp& lamp : light.lamps) add_spots(lamp, everything, bright);
  if (bright.patches.empty()) return nullptr;
  bright.elsewhere_w_m2 += outside_w_m2(light);
  std::stable_sort(
      bright.patches.begin(), bright.patches.end(),
      [](const BrightPatch& a, const BrightPatch& b) { return a.strength_w_sr > b.strength_w_sr; });
  if (bright.patches.size() > BrightPatches::most) bright.patches.resize(BrightPatches::most);
  return std::make_shared<const BrightPatches>(std::move(bright));
}

void add_bright_patches(std::span<const std::shared_ptr<const SurfaceMesh>> background,
                        const Geometry& everything, Light& light) {
  if (auto patches = find_bright_patches(light, everything))
    light.emitters = std::make_shared<EmittingSurfaces>(background, std::move(patches));
}

PatchAim aim_at_patches(const BrightPatches& bright, const SurfacePoint& from) {
  PatchAim aim;
  if ((from.f0 > 0.0F).any() && from.alpha < roughest_mirror) return aim;
  float sum = 0;
  for (std::size_t i = 0; i < bright.patches.size(); ++i) {
    aim.shares[i] = sent_to(bright.patches[i], from);
    sum += aim.shares[i];
  }
  if (!(sum > 0.0F) || !std::isfinite(sum)) return {};
  const float factor = largest_aim / (sum + bright.elsewhere_w_m2);
  for (float& share : aim.shares) {
    share *= factor;
    aim.sum += share;
  }
  return aim;
}

Eigen::Vector3f direction_to_patch(const BrightPatches& bright, const PatchAim& aim, const SurfacePoint& from,
                                   const Eigen::Array2f& point) {
  std::size_t chosen = 0;
  float left = point[0] * aim.sum;
  while (chosen + 1 < bright.patches.size() && left >= aim.shares[chosen]) left -= aim.shares[chosen++];
  const BrightPatch& patch = bright.patches[chosen];
  const float across = std::clamp(left / std::max(1e-30F, aim.shares[chosen]), 0.0F, 1.0F);
  const float cosine = 1.0F - across * (1.0F - least_cosine);
  const float radius_m = patch.height_m * std::sqrt(std::max(0.0F, 1.0F / (cosine * cosine) - 1.0F));
  const float angle = 2.0F * std::numbers::pi_v<float> * point[1];
  const Eigen::Vector3f place =
      patch.foot_m + local_axes(patch.normal) *
                         Eigen::Vector3f(radius_m * std::cos(angle), radius_m * std::sin(angle), 0.0F);
  return (place - from.position_m).normalized();
}

float patch_density_sr(const BrightPatches& bright, const PatchAim& aim, const SurfacePoint& from,
                       const Eigen::Vector3f& direction) {
  float density_sr = 0;
  for (std::size_t i = 0; i < bright.patches.size(); ++i) {
    const BrightPatch& patch = bright.patches[i];
    const float facing = -patch.normal.dot(direction);
    if (!(aim.shares[i] > 0.0F) || !(facing > 0.0F)) continue;
    const float way_m = patch.normal.dot(from.position_m - patch.foot_m) / facing;
    const float off_m2 = (from.position_m + way_m * direction - patch.foot_m).squaredNorm();
    const float squared_height_m2 = patch.height_m * patch.height_m;
    const float cosine = patch.height_m / std::sqrt(squared_height_m2 + off_m2);
    if (cosine < least_cosine) continue;
    const float density_m2 = cosine * cosine * cosine /
                             (2.0F * std::numbers::pi_v<float> * (1.0F - least_cosine) * squared_height_m2);
    density_sr += aim.shares[i] * density_m2 * way_m * way_m / facing;
  }
  return density_sr;
}

}  // namespace seamline::renderer
