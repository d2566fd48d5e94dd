// The adaptive depth mesh beside full density.
#include <fmt/format.h>

#include <array>

#include "laboratory/bench/bench.h"
#include "laboratory/bench/bench_rays.h"
#include "laboratory/bench/bench_timing.h"
#include "raytracer/tracing/ray_device.h"
#include "renderer/depth/capture.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/estimators/path/path_depth_pass.h"
#include "renderer/picture/composite.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/assets.h"

namespace seamline::renderer {
namespace {

/// A local scene and what it took.
struct Built {
  std::size_t triangles = 0;
  double mesh_s = 0, embree_s = 0;
  double memory_mb = 0;
  std::unique_ptr<Geometry> geometry = nullptr;
};

Built build(const DepthMap& map, MeshDensity density, int threads) {
  Built built;
  DepthMesh mesh;
  built.mesh_s =
      time_once(Clock::wall, [&] { mesh = build_depth_mesh(map, {.density = density, .threads = threads}); });
  built.triangles = mesh.triangles.size();
  const std::int64_t before = RayDevice::instance().memory_bytes();
  built.embree_s =
      time_once(Clock::wall, [&] { built.geometry = std::make_unique<Geometry>(mesh, Rgb::Constant(0.5F)); });
  built.memory_mb = 1e-6 * static_cast<double>(RayDevice::instance().memory_bytes() - before +
                                               built.geometry->own_memory_bytes());
  return built;
}

/// How two pictures differ as people see them.
struct PictureChange {
  double share_beyond_one = 0;  ///< of pixels, by more than one 8-bit step in any channel
  double largest = 0;           ///< steps
};

PictureChange change(const ByteImage& a, const ByteImage& b) {
  PictureChange change;
  const std::size_t pixels = a.values.size() / 3;
  for (std::size_t i = 0; i < pixels; ++i) {
    int steps = 0;
    for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
      steps = std::max(steps, std::abs(int{a.values[k]} - int{b.values[k]}));
    change.share_beyond_one += steps > 1 ? 1.0 / pixels : 0.0;
    change.largest = std::max(change.largest, static_cast<double>(steps));
  }
  return change;
}

struct Subject {
  const char* scene;
  Artifact artifact;
};

std::vector<BenchLine> measure_builds(const std::string& name, const Built& adaptive, const Built& full,
                                      Wanted build_s, Wanted memory_mb) {
  const auto beside = [&](const char* what, const char* unit, double found, double other, Wanted wanted) {
    std::vector<BenchLine> lines = {{.what = fmt::format("{}, {}", name, what),
                                     .unit = unit,
                                     .found = found,
                                     .beside = other,
                                     .ratio = found / other}};
    // A bound on the thing itself, not on the ratio, is a line of its own.
    if (wanted.kind != Wanted::Kind::nothing)
      lines.push_back({.what = fmt::format("{}, {}, adaptive", name, what),
                       .unit = unit,
                       .found = found,
                       .beside = {},
                       .ratio = {},
                       .wanted = wanted});
    return lines;
  };
  std::vector<BenchLine> all;
  for (const auto& lines :
       {beside("triangles", "millions", 1e-6 * adaptive.triangles, 1e-6 * full.triangles, {}),
        beside("mesh build", "s", adaptive.mesh_s, full.mesh_s, build_s),
        beside("Embree build and table", "s", adaptive.embree_s, full.embree_s, {}),
        beside("memory", "MB", adaptive.memory_mb, full.memory_mb, memory_mb)})
    all.insert(all.end(), lines.begin(), lines.end());
  return all;
}

BenchLine measure_rays(const std::string& name, const TruthScene& scene, const Geometry& adaptive,
                       const Geometry& full, bool quick) {
  const RecordedRays rays = record_rays(scene, adaptive, quick ? 30 : 16);
  const auto trace = [&](const Geometry& geometry) {
    std::optional<SurfacePoint> hit;
    for (const Ray& ray : rays.bounce) hit = geometry.nearest(ray);
  };
  const InterleavedTimes timings =
      time_interleaved(quick ? 3 : 5, Clock::processor,
                       std::array<std::function<void()>, 2>{[&] { trace(adaptive); }, [&] { trace(full); }});
  const double million = 1e-6 * rays.bounce.size();
  return {.what = fmt::format("{}, bounce rays", name),
          .unit = "Mrays/s",
          .found = million / timings.median_s(0),
          .beside = million / timings.median_s(1),
          .ratio = timings.median_ratio(1, 0)};
}

/// The same samples on both meshes.
std::vector<BenchLine> measure_picture(const std::string& name, const Subject& subject,
                                       const TruthScene& scene, const std::array<const Geometry*, 2>& depths,
                                       const BenchOptions& options) {
  const ObjectGeometry geometry = object_geometry(scene, 2);
  // As many samples as a study has: of four, one that falls on the other side of a shadow's edge would be a
  // quarter of the pixel.
  const int spp = read_study(builtin_study("depth_resolution_isolated")).samples_per_pixel;
  const PassOptions pass{.spp = options.quick ? 1 : spp, .seed = 1, .threads = options.threads};
  const TruthSums truth = render_truth(scene, geometry, pass);
  std::array<ByteImage, 2> pictures;
  for (std::size_t i = 0; i < 2; ++i)
    pictures[i] = display_image(compose(render_stimulus(scene, geometry, depths[i], truth,
                                                        recipe(subject.artifact, Isolation::query), pass))
                                    .picture,
                                scene.definition.exposure_ev);
  const PictureChange found = change(pictures[0], pictures[1]);
  const auto line = [&](const char* what, const char* unit, double value, double most) {
    return BenchLine{.what = fmt::format("{}, {}: {}", name, word(subject.artifact), what),
                     .unit = unit,
                     .found = value,
                     .beside = {},
                     .ratio = {},
                     .wanted = {Wanted::Kind::at_most, most}};
  };
  return {line("pixels changed by more than one step", "of 1", found.share_beyond_one, 0.001),
          line("largest change", "steps of 255", found.largest, 8)};
}

}  // namespace

std::vector<BenchLine> bench_mesh(const BenchOptions& options) {
  std::vector<BenchLine> all;
  const int width_px = options.quick ? 512 : 4096;
  const int picture_px = options.quick ? 240 : 960;
  for (const Subject& subject :
       {Subject{"bedroom", Artifact::receiver}, Subject{"gazebo", Artifact::overlap}}) {
    const std::string name = fmt::format("{}, W = {}", subject.scene, width_px);
    const TruthScene scene = load_truth_scene(bench_scene(subject.scene), picture_px, picture_px * 9 / 16);
    const Geometry truth = scene.geometry_without(2);
    const DepthMap map = capture_depth(truth, width_px, 0, options.threads);
    const Built adaptive = build(map, MeshDensity::adaptive, options.threads);
    const Built full = build(map, MeshDensity::full, options.threads);
    const auto append = [&](const std::vector<BenchLine>& some) {
      all.insert(all.end(), some.begin(), some.end());
    };
    append(measure_builds(name, adaptive, full, {Wanted::Kind::at_most, 0.5}, {Wanted::Kind::at_most, 40}));
    append({measure_rays(name, scene, *adaptive.geometry, *full.geometry, options.quick)});
    append(measure_picture(name, subject, scene, {adaptive.geometry.get(), full.geometry.get()}, options));
  }
  return all;
}

}  // namespace seamline::renderer
