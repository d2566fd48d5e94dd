#include "renderer/estimators/fast/fast_depth_pass.h"
#include "raytracer/scene/panorama_camera.h"

#include <algorithm>
#include <mutex>

#include "raytracer/common/parallel.h"

namespace seamline::renderer {
namespace {

/// Samples of one pixel: those from `first_uncovered` to `end_uncovered` ask about light off the object,
/// those from `first_object` to `end_object` about the object.
struct PixelSamples {
  int first_uncovered = 0, end_uncovered = 0, first_object = 0, end_object = 0;
  bool is_paired_with_truth = false;
  [[nodiscard]] bool asks_uncovered(int i) const { return i >= first_uncovered && i < end_uncovered; }
  [[nodiscard]] bool asks_object(int i) const { return i >= first_object && i < end_object; }
  [[nodiscard]] int first() const {
    if (first_uncovered >= end_uncovered) return first_object;
    return first_object >= end_object ? first_uncovered : std::min(first_uncovered, first_object);
  }
  [[nodiscard]] int end() const {
    if (first_uncovered >= end_uncovered) return end_object;
    return first_object >= end_object ? end_uncovered : std::max(end_uncovered, end_object);
  }
};

/// Asks for the samples of one tile, those of several pixels at once: a ratio is content with few a pixel.
class TileAsker {
 public:
  TileAsker(const StimulusSampler& sampler, DepthAnswers& answers) : sampler_(sampler), answers_(answers) {}

  void add(int x, int y, const PixelSamples& samples) {
    const std::size_t pixel = answers_.grid.index(x, y);
    for (int i = samples.first(); i < samples.end(); ++i) {
      ids_.push_back({x, y, i});
      wanted_.push_back(
          {pixel, samples.asks_uncovered(i), samples.asks_object(i), samples.is_paired_with_truth});
    }
    if (ids_.size() >= at_once) ask();
  }

  void ask() {
    sampler_.look(ids_, seen_, work_);
    drop_unasked();
    sampler_.ask_depth(seen_, lights_, work_);
    for (std::size_t i = 0; i < seen_.size(); ++i) add_light(seen_[i], lights_[i], wanted_[i].pixel);
    ids_.clear();
    wanted_.clear();
  }

  [[nodiscard]] RayCounts counts() const { return work_.counts(); }

 private:
  static constexpr std::size_t at_once = 32;
  struct Wanted {
    std::size_t pixel;
    bool uncovered, object, is_paired_with_truth;
  };

  /// What a sample shows decides which of its pixel's two numbers of samples counts.
  void drop_unasked() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      const bool on_object = seen_[i].shows == StimulusSample::Shows::object;
      if (!(on_object ? wanted_[i].object : wanted_[i].uncovered)) continue;
      seen_[kept] = seen_[i], wanted_[kept] = wanted_[i];
      seen_[kept].is_paired_with_truth = wanted_[i].is_paired_with_truth;
      ++kept;
    }
    seen_.erase(seen_.begin() + static_cast<std::ptrdiff_t>(kept), seen_.end());
  }

  void add_light(const StimulusSample& sample, const DepthLight& light, std::size_t pixel) {
    using Shows = StimulusSample::Shows;
    const auto half = static_cast<std::size_t>(sample.number % 2);
    DepthPixel& sums = answers_.halves[half][pixel];
    sums.without_object += light.without_object;
    sums.with_object += light.with_object;
    sums.object += light.object;
    if (!answers_.mirrored[half].empty()) {
      DepthMirrored& mirrored = answers_.mirrored[half][pixel];
      mirrored.without_object += light.without_object.mirrored;
      mirrored.with_object += light.with_object.mirrored;
      mirrored.object += light.object.mirrored;
    }
    sums.uncovered_surfaces += light.uncovered_surfaces;
    if (sample.shows == Shows::object) sums.covered += 1.0F;
    if (sample.is_paired_with_truth) answers_.object_in_truth[half][pixel] += light.object_in_truth;
    if (sample.shows == Shows::sky && sample.real) sums.depth_sky += 1.0F;
    if (answers_.guides.empty()) return;
    if (const SurfacePoint* receiver = sampler_.receiver(sample))
      answers_.guides[pixel].add(*receiver, light.reach_m);
  }

  const StimulusSampler& sampler_;
  DepthAnswers& answers_;
  std::vector<SampleId> ids_;
  std::vector<Wanted> wanted_;
  std::vector<StimulusSample> seen_;
  std::vector<DepthLight> lights_;
  SamplingWork work_;
};

}  // namespace

DepthAnswers empty_answers(const Camera& camera, const Answers& answers,
                           const std::vector<int>& photograph_spp, bool mirrors) {
  DepthAnswers out;
  out.grid = {camera.width_px, camera.height_px, wraps(camera)};
  const std::size_t pixels =
      static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px);
  for (auto& half : out.halves) half.resize(pixels);
  if (mirrors)
    for (auto& half : out.mirrored) half.resize(pixels);
  if (asks_depth_off_object(answers)) out.guides.resize(pixels);
  out.spp.uncovered.resize(static_cast<std::size_t>(out.blocks().count()));
  out.spp.object.resize(static_cast<std::size_t>(out.blocks().count()));
  out.spp.photograph = photograph_spp;
  if (adds_to_object(answers))
    for (auto& half : out.object_in_truth) half.resize(pixels, Rgb::Zero());
  return out;
}

void ask_depth(const StimulusSampler& sampler, const DepthSamples& wanted,
               const std::vector<char>& shows_object, int threads,
               const std::function<void(double)>& progress, DepthAnswers& answers) {
  std::mutex counting;
  const auto work = [&](int tile) {
    TileAsker asker(sampler, answers);
    for (const int block : blocks_of(answers.grid, tile)) {
      const auto b = static_cast<std::size_t>(block);
      int &uncovered = answers.spp.uncovered[b], &object = answers.spp.object[b];
      const bool is_paired_with_truth =
          !answers.object_in_truth[0].empty() && wanted.object[b] < wanted.photograph[b];
      const PixelSamples with_object = {uncovered, wanted.uncovered[b], object, wanted.object[b],
                                        is_paired_with_truth};
      const PixelSamples without_object = {uncovered, wanted.uncovered[b], 0, 0};
      if (with_object.first() >= with_object.end()) continue;
      const BlockGrid::Rectangle r = answers.blocks().rectangle(block);
      for (int y = r.top; y < r.bottom; ++y)
        for (int x = r.left; x < r.right; ++x)
          asker.add(x, y, shows_object[answers.grid.index(x, y)] != 0 ? with_object : without_object);
      uncovered = std::max(uncovered, wanted.uncovered[b]);
      object = std::max(object, wanted.object[b]);
    }
    asker.ask();
    const std::lock_guard lock(counting);
    answers.counts += asker.counts();
  };
  const int tiles = answers.grid.count();
  parallel_for(tiles, threads, work, [&](int finished) {
    if (progress) progress(static_cast<double>(finished) / tiles);
  });
}

namespace {

/// The order in one tile.
void order_of_tile(const TruthScene& scene, const SceneSums& sums, const ObjectTile& tile,
                   const TileGrid::Rectangle& r, const Geometry& object, const DepthWorld& depth,
                   std::uint64_t seed, std::array<std::vector<OrderPixel>, 2>& order) {
  for (auto& half : order) half.resize(tile_pixels);
  std::array<Ray, rays_a_call> rays;
  std::array<Eigen::Array2f, rays_a_call> places;
  std::array<std::optional<SurfacePoint>, rays_a_call> on_object, on_depth;
  std::array<bool, rays_a_call> in_truth;
  std::array<std::size_t, rays_a_call> halves;
  for (int y = r.top; y < r.bottom; ++y)
    for (int x = r.left; x < r.right; ++x) {
      const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
      const ObjectOnRays& on_rays = tile.on_rays[ObjectTile::block_in_tile(x, y)];
      const int spp = sums.samples_at(x, y);
      for (int sample = 0; sample < spp;) {
        std::size_t count = 0;
        for (; sample < spp && count < rays_a_call; ++sample) {
          const ObjectOnRays::Is found = on_rays.at(sample, x, y);
          if (found == ObjectOnRays::Is::absent) continue;
          in_truth[count] = found == ObjectOnRays::Is::in_front;
          const Sampler sampler(seed, x, y, sample);
          rays[count] = camera_ray(scene.camera, x, y, sampler);
          if (depth.occlusion != nullptr) places[count] = camera_place(scene.camera, x, y, sampler);
          halves[count++] = static_cast<std::size_t>(sample % 2);
        }
        const std::span<const Ray> asked(rays.data(), count);
        nearest_seen(scene.camera, object, asked, std::span(on_object.data(), count));
        if (depth.occlusion == nullptr)
          nearest_seen(scene.camera, *depth.mesh, asked, std::span(on_depth.data(), count));
        for (std::size_t i = 0; i < count; ++i) {
          if (!on_object[i]) continue;  // its very edge
          const bool in_depth =
              is_in_front(depth, {rays[i].direction, places[i]}, *on_object[i], on_depth[i]);
          OrderPixel& out = order[halves[i]][place];
          out.truth_only += in_truth[i] && !in_depth ? 1.0F : 0.0F;
          out.depth_only += in_depth && !in_truth[i] ? 1.0F : 0.0F;
        }
      }
    }
}

}  // namespace

ObjectOrder ask_order(const TruthScene& scene, const SceneSums& sums, int object_index,
                      const Geometry& object, const DepthWorld& depth, std::uint64_t seed, int threads) {
  const auto& tiles = sums.objects[object_index - 1];
  ObjectOrder order(tiles.size());
  parallel_for(static_cast<int>(tiles.size()), threads, [&](int tile) {
    const auto t = static_cast<std::size_t>(tile);
    if (tiles[t])
      order_of_tile(scene, sums, *tiles[t], sums.grid.rectangle(tile), object, depth, seed, order[t]);
  });
  return order;
}

}  // namespace seamline::renderer
