// What the inner loops are made of: a sample point, a packet of rays, the bound of a mesh, the ratio of a
// pixel.
#include <benchmark/benchmark.h>

#include <array>

#include "raytracer/common/sampler.h"
#include "raytracer/tracing/geometry.h"
#include "renderer/depth/adaptive_mesh.h"
#include "renderer/picture/composite.h"

namespace seamline {
using namespace renderer;
namespace {

void sampler_point(benchmark::State& state) {
  int sample = 0;
  for (auto _ : state) {
    const Sampler sampler(1, 480, 270, sample++ & 63);
    benchmark::DoNotOptimize(sampler.point(dimension::direction(0)));
  }
}
BENCHMARK(sampler_point);

/// A room of waves, so that no triangle can be large.
DepthMap wavy_map(int width_px) {
  DepthMap map{.width_px = width_px, .height_px = width_px / 2, .distance_m = {}};
  for (int row = 0; row < map.height_px; ++row)
    for (int column = 0; column < width_px; ++column) {
      const Eigen::Vector3d d = panorama_direction(column + 0.5, row + 0.5, width_px, map.height_px);
      map.distance_m.push_back(static_cast<float>(3 + 0.2 * std::sin(20 * d.x()) * std::cos(20 * d.y())));
    }
  return map;
}

void mesh_within_its_bound(benchmark::State& state) {
  const DepthMap map = wavy_map(512);
  const DenseSphere sphere = make_dense_sphere(map, 0, 1, 512);
  for (auto _ : state) benchmark::DoNotOptimize(build_adaptive_mesh(sphere, 1e-3, 1));
  state.SetItemsProcessed(state.iterations() * sphere.width * sphere.height);
}
BENCHMARK(mesh_within_its_bound)->Unit(benchmark::kMillisecond);

struct LocalScene {
  Geometry geometry{build_depth_mesh(wavy_map(512), {.threads = 1}), Rgb::Constant(0.5F)};
  std::array<Ray, 16> rays;
  std::array<std::optional<SurfacePoint>, 16> hits;

  LocalScene() {
    for (std::size_t i = 0; i < rays.size(); ++i)
      rays[i] = {Eigen::Vector3f::Zero(),
                 Eigen::Vector3f(0.1F + 0.001F * static_cast<float>(i), 0.2F, -1).normalized()};
  }
};

void rays_one_by_one(benchmark::State& state) {
  LocalScene scene;
  for (auto _ : state) {
    for (std::size_t i = 0; i < scene.rays.size(); ++i) scene.hits[i] = scene.geometry.nearest(scene.rays[i]);
    benchmark::DoNotOptimize(scene.hits);
  }
  state.SetItemsProcessed(state.iterations() * 16);
}
BENCHMARK(rays_one_by_one);

void rays_in_packets(benchmark::State& state) {
  LocalScene scene;
  for (auto _ : state) {
    scene.geometry.nearest(scene.rays, scene.hits);
    benchmark::DoNotOptimize(scene.hits);
  }
  state.SetItemsProcessed(state.iterations() * 16);
}
BENCHMARK(rays_in_packets);

void rays_from_centre(benchmark::State& state) {
  LocalScene scene;
  for (auto _ : state) {
    scene.geometry.nearest_from_centre(scene.rays, scene.hits);
    benchmark::DoNotOptimize(scene.hits);
  }
  state.SetItemsProcessed(state.iterations() * 16);
}
BENCHMARK(rays_from_centre);

void ratio_of_pixels(benchmark::State& state) {
  StimulusSums sums{.width_px = 128, .height_px = 128, .spp = 2};
  StimulusPixel pixel;
  pixel.background = Rgb::Constant(0.5F);
  pixel.without_object = Rgb::Constant(0.4F);
  pixel.with_object = Rgb::Constant(0.3F);
  pixel.uncovered_surfaces = 1;
  for (auto& half : sums.halves) half.assign(128 * 128, pixel);
  sums.guides.resize(128 * 128);
  for (auto _ : state) benchmark::DoNotOptimize(compose(sums));
  state.SetItemsProcessed(state.iterations() * 128 * 128);
}
BENCHMARK(ratio_of_pixels);

}  // namespace
}  // namespace seamline
