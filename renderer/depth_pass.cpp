#include "renderer/depth_pass.h"

#include <algorithm>
#include <mutex>

#include "renderer/parallel.h"

namespace seamline {
namespace {

/// Samples of one pixel: those from `first_rest` to `end_rest` ask about the rest, those from `first_object`
/// to `end_object` about the object.
struct PixelSamples {
  int first_rest = 0, end_rest = 0, first_object = 0, end_object = 0;
  [[nodiscard]] bool asks_rest(int i) const { return i >= first_rest && i < end_rest; }
  [[nodiscard]] bool asks_object(int i) const { return i >= first_object && i < end_object; }
  [[nodiscard]] int first() const {
    if (first_rest >= end_rest) return first_object;
    return first_object >= end_object ? first_rest : std::min(first_rest, first_object);
  }
  [[nodiscard]] int end() const {
    if (first_rest >= end_rest) return end_object;
    return first_object >= end_object ? end_rest : std::max(end_rest, end_object);
  }
  /// Of the samples from `first` on, those that ask about the object.
  [[nodiscard]] std::span<const StimulusSample> of_object(const std::vector<StimulusSample>& seen) const {
    if (first_object >= end_object) return {};
    return std::span(seen).subspan(static_cast<std::size_t>(first_object - first()),
                                   static_cast<std::size_t>(end_object - first_object));
  }
};

const Rgb no_light = Rgb::Zero();

void add_sample(const StimulusSampler& sampler, const StimulusSample& sample, int index,
                const Rgb& object_direct, DepthSums& sums, GuideSums* guide) {
  using Shows = StimulusSample::Shows;
  DepthPart asked;
  asked.object.direct = object_direct;
  const float reach_m = sampler.add_depth_part(sample, index, asked);
  sums.no += asked.no;
  sums.with += asked.with;
  sums.object += asked.object;
  sums.rest += asked.rest;
  if (sample.shows == Shows::object) sums.covered += 1.0F;
  if (sample.shows == Shows::sky && sample.real) sums.depth_sky += 1.0F;
  if (const SurfacePoint* receiver = sampler.receiver(sample); guide != nullptr && receiver != nullptr)
    guide->add(*receiver, reach_m);
}

}  // namespace

DepthAnswers empty_answers(const Camera& camera, const Answers& answers) {
  DepthAnswers out;
  out.grid = {camera.width_px, camera.height_px};
  const std::size_t pixels =
      static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px);
  for (auto& half : out.halves) half.resize(pixels);
  if (asks_depth_for_rest(answers)) out.guides.resize(pixels);
  out.spp.rest.resize(static_cast<std::size_t>(out.grid.count()));
  out.spp.object.resize(static_cast<std::size_t>(out.grid.count()));
  return out;
}

void ask_depth(const StimulusSampler& sampler, const DepthSamples& wanted,
               const std::vector<char>& shows_object, int threads,
               const std::function<void(double)>& progress, DepthAnswers& answers) {
  std::mutex counting;
  const auto work = [&](int tile) {
    const auto t = static_cast<std::size_t>(tile);
    int &rest = answers.spp.rest[t], &object = answers.spp.object[t];
    const PixelSamples with_object = {rest, wanted.rest[t], object, wanted.object[t]};
    const PixelSamples without_object = {rest, wanted.rest[t], 0, 0};
    if (with_object.first() >= with_object.end()) return;
    const std::int64_t before = rays_traced_by_this_thread();
    const OmittedRays omitted_before = omitted_rays;
    const TileGrid::Rectangle r = answers.grid.rectangle(tile);
    std::vector<StimulusSample> seen;
    std::vector<Rgb> object_direct;  // of the samples from the first that asks about the object
    for (int y = r.top; y < r.bottom; ++y)
      for (int x = r.left; x < r.right; ++x) {
        const std::size_t pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(answers.grid.width_px) +
            static_cast<std::size_t>(x);
        const PixelSamples& samples = shows_object[pixel] != 0 ? with_object : without_object;
        const int first = samples.first();
        seen.clear();
        sampler.look(x, y, first, samples.end(), seen);
        sampler.light_object_in_depth(samples.of_object(seen), object_direct);
        for (int i = first; i < samples.end(); ++i) {
          const StimulusSample& sample = seen[static_cast<std::size_t>(i - first)];
          const bool on_object = sample.shows == StimulusSample::Shows::object;
          if (!(on_object ? samples.asks_object(i) : samples.asks_rest(i))) continue;
          add_sample(sampler, sample, i,
                     on_object ? object_direct[static_cast<std::size_t>(i - samples.first_object)] : no_light,
                     answers.halves[static_cast<std::size_t>(i % 2)][pixel],
                     answers.guides.empty() ? nullptr : &answers.guides[pixel]);
        }
      }
    rest = std::max(rest, wanted.rest[t]);
    object = std::max(object, wanted.object[t]);
    const std::lock_guard lock(counting);
    answers.rays += rays_traced_by_this_thread() - before;
    answers.omitted += omitted_rays - omitted_before;
  };
  const int tiles = answers.grid.count();
  parallel_for(tiles, threads, work, [&](int finished) {
    if (progress) progress(static_cast<double>(finished) / tiles);
  });
}

namespace {

constexpr int packet = 16;

/// The order in one tile.
void order_of_tile(const TruthScene& scene, const ObjectTile& object, const TileGrid::Rectangle& r, int spp,
                   const Geometry& depth, std::uint64_t seed, std::array<std::vector<OrderSums>, 2>& order) {
  for (auto& half : order) half.resize(tile_pixels);
  std::array<Ray, packet> rays;
  std::array<float, packet> real_m, object_m, depth_m;
  std::array<std::size_t, packet> halves;
  for (int y = r.top; y < r.bottom; ++y)
    for (int x = r.left; x < r.right; ++x) {
      const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
      for (int sample = 0; sample < spp;) {
        std::size_t count = 0;
        for (; sample < spp && count < packet; ++sample) {
          const std::size_t at = static_cast<std::size_t>(sample) * tile_pixels + place;
          if (at >= object.object_m.size() || object.object_m[at] == std::numeric_limits<float>::infinity())
            continue;
          rays[count] = camera_ray(scene.camera, x, y, Sampler(seed, x, y, sample));
          object_m[count] = object.object_m[at];
          real_m[count] = object.real_m[at];
          halves[count++] = static_cast<std::size_t>(sample % 2);
        }
        depth.distances(std::span<const Ray>(rays.data(), count), std::span(depth_m.data(), count));
        for (std::size_t i = 0; i < count; ++i) {
          const bool in_truth = object_m[i] < real_m[i], in_depth = object_m[i] < depth_m[i];
          OrderSums& sums = order[halves[i]][place];
          sums.truth_only += in_truth && !in_depth ? 1.0F : 0.0F;
          sums.depth_only += in_depth && !in_truth ? 1.0F : 0.0F;
        }
      }
    }
}

}  // namespace

ObjectOrder ask_order(const TruthScene& scene, const SceneSums& sums, int object_index, const Geometry& depth,
                      std::uint64_t seed, int threads) {
  const auto& tiles = sums.objects[static_cast<std::size_t>(object_index - 1)];
  ObjectOrder order(tiles.size());
  parallel_for(static_cast<int>(tiles.size()), threads, [&](int tile) {
    const auto t = static_cast<std::size_t>(tile);
    if (tiles[t])
      order_of_tile(scene, *tiles[t], sums.grid.rectangle(tile), sums.spp[t], depth, seed, order[t]);
  });
  return order;
}

}  // namespace seamline
