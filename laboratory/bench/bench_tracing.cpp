// How fast rays are: capture, tracer, local scene.
#include <fmt/format.h>

#include <algorithm>

#include "laboratory/bench/bench.h"
#include "laboratory/bench/bench_embree.h"
#include "laboratory/bench/bench_rays.h"
#include "laboratory/bench/bench_timing.h"
#include "renderer/depth/capture.h"
#include "renderer/depth/depth_mesh.h"

namespace seamline::renderer {
namespace {

int repeats(const BenchOptions& options) {
  return options.quick ? 3 : 9;
}

int tile_row_step(const BenchOptions& options) {
  return options.quick ? 60 : 9;
}

struct LoadedScene {
  TruthScene scene;
  ObjectGeometry geometry;  ///< of the middle object
};

LoadedScene load(const std::string& name) {
  TruthScene scene = load_truth_scene(bench_scene(name), 960, 540);
  ObjectGeometry geometry = object_geometry(scene, 2);
  return {std::move(scene), std::move(geometry)};
}

double million_a_second(std::size_t rays, double seconds) {
  return rays / seconds * 1e-6;
}

/// Where answers go; allocated once.
struct Answers16 {
  std::array<std::optional<SurfacePoint>, rays_a_call> hits;
  std::array<std::uint8_t, rays_a_call> blocked;
};

enum class Question { nearest, nearest_one_by_one, nearest_from_centre, occluded };

void ask(const Geometry& geometry, Question question, Coherence coherence, std::span<const Ray> rays) {
  Answers16 answers;
  for (std::size_t first = 0; first < rays.size(); first += rays_a_call) {
    const auto some = rays.subspan(first, std::min(rays_a_call, rays.size() - first));
    const std::span hits = std::span(answers.hits).first(some.size());
    switch (question) {
      case Question::nearest:
        geometry.nearest(some, hits, coherence);
        break;
      case Question::nearest_one_by_one:
        for (std::size_t i = 0; i < some.size(); ++i) hits[i] = geometry.nearest(some[i]);
        break;
      case Question::nearest_from_centre:
        geometry.nearest_from_centre(some, hits);
        break;
      case Question::occluded:
        geometry.occluded(some, std::span(answers.blocked).first(some.size()), coherence);
        break;
    }
  }
}

/// A bare loop by its packet size and flag.
struct BareLoop {
  int packet_size;
  Coherence coherence;
};
constexpr std::array<BareLoop, 7> every_loop = {{{1, Coherence::scattered},
                                                 {4, Coherence::together},
                                                 {4, Coherence::scattered},
                                                 {8, Coherence::together},
                                                 {8, Coherence::scattered},
                                                 {16, Coherence::together},
                                                 {16, Coherence::scattered}}};

/// Seamline's work beside the fastest of some bare loops on the same rays.
BenchLine beside_best_loop(const std::string& what, std::span<const Ray> rays, const BareScene& bare,
                           bool nearest, const std::function<void()>& ours, int repeats,
                           std::span<const BareLoop> loops = every_loop) {
  std::vector<float> distance_m(rays.size());
  std::vector<std::function<void()>> works = {ours};
  for (const BareLoop& loop : loops)
    works.emplace_back([&, loop] {
      if (nearest)
        bare.nearest(loop.packet_size, loop.coherence, rays, distance_m);
      else
        bare.occluded(loop.packet_size, loop.coherence, rays, distance_m);
    });
  const InterleavedTimes timings = time_interleaved(repeats, Clock::processor, works);
  std::size_t best = 1;
  for (std::size_t i = 2; i < works.size(); ++i)
    if (timings.median_s(i) < timings.median_s(best)) best = i;
  const BareLoop& loop = loops[best - 1];
  return {.what = fmt::format("{} (best: rtc{}{}{})", what, nearest ? "Intersect" : "Occluded",
                              loop.packet_size, loop.coherence == Coherence::together ? ", coherent" : ""),
          .unit = "Mrays/s",
          .found = million_a_second(rays.size(), timings.median_s(0)),
          .beside = million_a_second(rays.size(), timings.median_s(best)),
          .ratio = timings.median_ratio(best, 0)};
}

/// The rays of a depth map, block by block, as capture asks them.
std::vector<Ray> panorama_rays(int width_px) {
  constexpr int block_px = 4;
  std::vector<Ray> rays;
  for (int top = 0; top < width_px / 2; top += block_px)
    for (int left = 0; left < width_px; left += block_px)
      for (int i = 0; i < block_px * block_px; ++i)
        rays.push_back(
            {Eigen::Vector3f::Zero(),
             panorama_direction(left + i % block_px + 0.5, top + i / block_px + 0.5, width_px, width_px / 2)
                 .cast<float>()});
  return rays;
}

}  // namespace

std::vector<BenchLine> bench_capture(const BenchOptions& options) {
  std::vector<BenchLine> measurements;
  for (const char* name : {"bedroom", "gazebo"}) {
    const LoadedScene loaded = load(name);
    const BareScene bare(loaded.geometry.truth.meshes(), Edges::tight);
    const int width_px = options.quick ? 256 : 1024;
    measurements.push_back(beside_best_loop(
        fmt::format("{}, W = {}", name, width_px), panorama_rays(width_px), bare, true,
        [&] { static_cast<void>(capture_depth(loaded.geometry.truth, width_px, 0, 1)); }, repeats(options)));
    measurements.back().wanted = {Wanted::Kind::at_least, 0.8};
  }
  return measurements;
}

std::vector<BenchLine> bench_tracer(const BenchOptions& options) {
  std::vector<BenchLine> measurements;
  for (const char* name : {"bedroom", "gazebo"}) {
    const LoadedScene loaded = load(name);
    const Geometry truth(loaded.geometry.truth.meshes(), Edges::loose);  // as the joint pass asks
    const BareScene bare(truth.meshes(), Edges::loose);
    const RecordedRays rays = record_rays(loaded.scene, truth, tile_row_step(options));
    const auto measure = [&](const std::string& what, std::span<const Ray> some, Question question,
                             const std::function<void()>& ours,
                             std::span<const BareLoop> loops = every_loop) {
      measurements.push_back(beside_best_loop(fmt::format("{}, {}", name, what), some, bare,
                                              question == Question::nearest, ours, repeats(options), loops));
      if (loops.size() == every_loop.size()) measurements.back().wanted = {Wanted::Kind::at_least, 0.7};
    };
    measure("primary rays", rays.primary, Question::nearest,
            [&] { ask(truth, Question::nearest, Coherence::together, rays.primary); });
    measure("sun rays", rays.sun, Question::occluded,
            [&] { ask(truth, Question::occluded, Coherence::together, rays.sun); });
    measure("bounce rays", rays.bounce, Question::nearest,
            [&] { ask(truth, Question::nearest, Coherence::scattered, rays.bounce); });
    const auto one_by_one = [&] {
      ask(truth, Question::nearest_one_by_one, Coherence::scattered, rays.bounce);
    };
    measure("bounce rays one by one", rays.bounce, Question::nearest, one_by_one);
    measure("bounce rays one by one, no packets", rays.bounce, Question::nearest, one_by_one,
            std::span(every_loop).first(1));
    measure("sky rays", rays.bounce, Question::occluded,
            [&] { ask(truth, Question::occluded, Coherence::scattered, rays.bounce); });
  }
  return measurements;
}

std::vector<BenchLine> bench_local_scene(const BenchOptions& options) {
  std::vector<BenchLine> measurements;
  const std::vector<int> widths_px = options.quick ? std::vector{64} : std::vector{64, 512, 4096};
  for (const char* name : {"bedroom", "gazebo"}) {
    const LoadedScene loaded = load(name);
    const Geometry& truth = loaded.geometry.truth;
    const Geometry loose_truth(truth.meshes(), Edges::loose);
    const RecordedRays truth_rays = record_rays(loaded.scene, truth, tile_row_step(options));
    for (const int width_px : widths_px) {
      const DepthMap map = capture_depth(truth, width_px, 0, options.threads);
      const Geometry local(build_depth_mesh(map, {.threads = options.threads}), Rgb::Constant(0.5F));
      const RecordedRays local_rays = record_rays(loaded.scene, local, tile_row_step(options));
      const auto measure = [&](const char* kind, std::vector<Ray> RecordedRays::*rays, Question in_local,
                               Question in_truth, Coherence coherence, Wanted wanted) {
        const std::vector<Ray>&here = local_rays.*rays, &there = truth_rays.*rays;
        const InterleavedTimes timings = time_interleaved(
            repeats(options), Clock::processor,
            std::array<std::function<void()>, 3>{[&] { ask(local, in_local, coherence, here); },
                                                 [&] { ask(truth, in_truth, coherence, there); },
                                                 [&] { ask(loose_truth, in_truth, coherence, there); }});
        const double more_rays = static_cast<double>(here.size()) / static_cast<double>(there.size());
        const auto beside = [&](const char* edges, std::size_t other, Wanted ratio_wanted) {
          measurements.push_back(
              {.what = fmt::format("{}, W = {}, {} rays, truth with {} edges", name, width_px, kind, edges),
               .unit = "Mrays/s",
               .found = million_a_second(here.size(), timings.median_s(0)),
               .beside = million_a_second(there.size(), timings.median_s(other)),
               .ratio = timings.median_ratio(other, 0) * more_rays,
               .wanted = ratio_wanted});
        };
        beside("tight", 1, width_px == 4096 ? wanted : Wanted{});
        beside("loose", 2, {});
      };
      measure("primary", &RecordedRays::primary, Question::nearest_from_centre, Question::nearest,
              Coherence::together, {Wanted::Kind::at_least, 2});
      measure("sun", &RecordedRays::sun, Question::occluded, Question::occluded, Coherence::together, {});
      measure("bounce", &RecordedRays::bounce, Question::nearest_one_by_one, Question::nearest_one_by_one,
              Coherence::scattered, {Wanted::Kind::at_least, 0.65});
      measure("bounce in packets", &RecordedRays::bounce, Question::nearest, Question::nearest,
              Coherence::scattered, {Wanted::Kind::at_least, 0.65});
    }
  }
  return measurements;
}

}  // namespace seamline::renderer
