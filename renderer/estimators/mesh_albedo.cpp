#include "renderer/estimators/mesh_albedo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "raytracer/common/parallel.h"
#include "renderer/depth/depth_map.h"
#include "renderer/transport/transport.h"

namespace seamline::renderer {
namespace {

constexpr int widest_of_photograph_px = 1024;
constexpr float least_share_of_median = 0.02F;
constexpr std::uint64_t irradiance_seed = 0x5eed;

AlbedoMap empty_map(int width_px, double usual_albedo) {
  AlbedoMap map{.width_px = width_px,
                .height_px = width_px / 2,
                .texels = {},
                .known = {},
                .elsewhere = Rgb::Constant(static_cast<float>(usual_albedo))};
  const auto texels = static_cast<std::size_t>(map.width_px) * static_cast<std::size_t>(map.height_px);
  map.texels.assign(texels, map.elsewhere);
  map.known.assign(texels, 0);
  return map;
}

Eigen::Vector3f direction_in(const AlbedoMap& map, int column, int row, const Eigen::Array2f& place) {
  return panorama_direction(column + static_cast<double>(place[0]), row + static_cast<double>(place[1]),
                            map.width_px, map.height_px)
      .cast<float>();
}

/// The photograph's pixel that a direction shows; null outside it.
const float* pixel_in(const PhotographedScene& scene, const Eigen::Vector3f& direction) {
  const Camera& camera = scene.camera;
  const Eigen::Vector3f local = camera.axes.transpose() * direction;
  if (!(local.z() < 0.0F)) return nullptr;
  const float scale = 0.5F * static_cast<float>(camera.width_px) / camera.tan_half_horizontal;
  const float x = local.x() / -local.z() * scale + 0.5F * static_cast<float>(camera.width_px);
  const float y = 0.5F * static_cast<float>(camera.height_px) - local.y() / -local.z() * scale;
  if (!(x >= 0.0F && y >= 0.0F && x < static_cast<float>(camera.width_px) &&
        y < static_cast<float>(camera.height_px)))
    return nullptr;
  return &scene.photograph.values[scene.photograph.index(static_cast<int>(x), static_cast<int>(y))];
}

/// Samples of a texel: each is a path, and there are as many of them in maps of all widths.
int samples_a_texel(int width_px) {
  const double of_widest = static_cast<double>(widest_of_photograph_px) / width_px;
  return static_cast<int>(std::clamp(32 * of_widest * of_widest, 32.0, 1024.0));
}

/// What the photograph and the local scene have in one texel.
struct TexelLight {
  Rgb radiance = Rgb::Zero();    ///< of the photograph, mean
  Rgb irradiance = Rgb::Zero();  ///< of the local scene, mean
  bool seen = false;
};

TexelLight light_in(const AlbedoMap& map, int column, int row, const Geometry& local,
                    const PhotographedScene& scene) {
  // Most texels are not in the picture: their corners and their middle say so. One that it only touches is
  // known from the part that it shows.
  const auto shows = [&](float x, float y) {
    return pixel_in(scene, direction_in(map, column, row, {x, y})) != nullptr;
  };
  if (!shows(0, 0) && !shows(1, 0) && !shows(0, 1) && !shows(1, 1) && !shows(0.5F, 0.5F)) return {};
  TexelLight sum;
  int samples = 0;
  for (int sample = 0; sample < samples_a_texel(map.width_px); ++sample) {
    const Sampler sampler(irradiance_seed, column, row, sample);
    const Eigen::Vector3f direction = direction_in(map, column, row, sampler.point(dimension::pixel));
    const float* pixel = pixel_in(scene, direction);
    if (pixel == nullptr) continue;
    std::optional<SurfacePoint> point;
    const Ray ray{Eigen::Vector3f::Zero(), direction};
    local.nearest_from_centre({&ray, 1}, {&point, 1});
    if (!point) continue;
    SurfacePoint white = *point;
    white.albedo = Rgb::Ones();
    const RadiancePair light = radiance_with_and_without(local, nullptr, white, scene.light, sampler);
    sum.irradiance += light.without_object.total() * std::numbers::pi_v<float>;
    sum.radiance += Rgb(pixel[0], pixel[1], pixel[2]);
    ++samples;
  }
  if (samples == 0) return {};
  const float share = 1.0F / static_cast<float>(samples);
  return {sum.radiance * share, sum.irradiance * share, true};
}

float median_of(std::vector<float> values) {
  if (values.empty()) return 0.0F;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

AlbedoMap estimate(const Geometry& local, int width_px, const PhotographedScene& scene) {
  AlbedoMap map = empty_map(width_px, scene.usual_albedo);
  std::vector<TexelLight> lights(map.texels.size());
  parallel_for(map.height_px, scene.threads, [&](int row) {
    for (int column = 0; column < map.width_px; ++column)
      lights[map.index(column, row)] = light_in(map, column, row, local, scene);
  });
  std::vector<float> irradiances;
  for (const TexelLight& light : lights)
    if (light.seen) irradiances.push_back(light.irradiance.mean());
  const float least = least_share_of_median * median_of(std::move(irradiances));
  for (std::size_t i = 0; i < lights.size(); ++i) {
    map.known[i] = 1;  // what is not shown has the usual albedo, also beside what is
    if (!lights[i].seen || !(lights[i].irradiance.minCoeff() > least)) continue;
    map.texels[i] = (lights[i].radiance / lights[i].irradiance * std::numbers::pi_v<float>)
                        .max(least_photographed_albedo)
                        .min(most_photographed_albedo);
  }
  return map;
}

}  // namespace

int albedo_map_width_px(const DepthSettings& depth) {
  int width_px = depth.width_px;
  if (depth.chain && !is_panorama(*depth.chain)) {
    const sensors::PinholeCamera& camera = *camera_of(depth.chain->sources.front());
    width_px = 2 * static_cast<int>(std::lround(std::numbers::pi * camera.fx_px));
  }
  width_px = std::clamp(width_px, 4, 16384);
  return depth.albedo == MeshAlbedo::photograph ? std::min(width_px, widest_of_photograph_px) : width_px;
}

AlbedoMap albedo_of_truth(const Geometry& truth, int width_px, double usual_albedo, int threads) {
  AlbedoMap map = empty_map(width_px, usual_albedo);
  parallel_for(map.height_px, threads, [&](int row) {
    for (int column = 0; column < map.width_px; ++column) {
      const auto hit = truth.nearest({Eigen::Vector3f::Zero(), direction_in(map, column, row, {0.5F, 0.5F})});
      if (!hit) continue;
      map.texels[map.index(column, row)] = hit->albedo + (1.0F - hit->albedo) * hit->f0;
      map.known[map.index(column, row)] = 1;
    }
  });
  return map;
}

std::shared_ptr<const AlbedoMap> paint_from_photograph(Geometry& local, int width_px,
                                                       const PhotographedScene& scene) {
  std::shared_ptr<const AlbedoMap> map;
  const int passes = scene.light.bounces > 0 ? 2 : 1;
  for (int pass = 0; pass < passes; ++pass) {
    map = std::make_shared<const AlbedoMap>(estimate(local, width_px, scene));
    local.paint(map);
  }
  return map;
}

void paint_mesh(Geometry& local, const Geometry& truth, const DepthSettings& depth,
                const PhotographedScene& scene) {
  const int width_px = albedo_map_width_px(depth);
  switch (depth.albedo) {
    case MeshAlbedo::constant:
      return;
    case MeshAlbedo::truth:
      local.paint(std::make_shared<const AlbedoMap>(
          albedo_of_truth(truth, width_px, scene.usual_albedo, scene.threads)));
      return;
    case MeshAlbedo::photograph:
      (void)paint_from_photograph(local, width_px, scene);
      return;
  }
}

}  // namespace seamline::renderer
