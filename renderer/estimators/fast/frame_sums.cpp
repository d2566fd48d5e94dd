#include "renderer/estimators/fast/frame_sums.h"

#include <algorithm>
#include <array>
#include <memory>
#include <type_traits>

#include "raytracer/common/parallel.h"
#include "raytracer/scene/moving_scenes.h"

namespace seamline::renderer {
namespace {

/// Of the variance that a block's light has in the base: what its change may have.
constexpr double most_change_noise = 0.1;

constexpr std::size_t kinds_of_light = 4;  ///< direct, bounce, mirrored, sky: each is judged by itself
constexpr std::size_t mirrored_light = 2, sky_light = 3;

template <class Sums>
using Pointer = std::conditional_t<std::is_const_v<Sums>, const Rgb*, Rgb*>;

template <class Unsplit>
void add_to(Unsplit& light, std::size_t& n, auto& out) {
  out[n++] = &light.direct;
  out[n++] = &light.bounce;
}

/// The light of a pixel: direct and bounce in turn, or one part alone.
template <class Sums>
  requires std::is_same_v<std::remove_const_t<Sums>, WorldPixel>
auto lights_of(Sums& pixel) {
  std::array<Pointer<Sums>, 2 * worlds_a_group> out{};
  std::size_t n = 0;
  for (auto& seen : pixel.seen) add_to(seen, n, out);
  return out;
}
template <class Sums>
  requires std::is_same_v<std::remove_const_t<Sums>, ObjectPixel>
auto lights_of(Sums& pixel) {
  std::array<Pointer<Sums>, 8> out{};
  std::size_t n = 0;
  add_to(pixel.object, n, out), add_to(pixel.behind, n, out);
  add_to(pixel.behind_with, n, out), add_to(pixel.hidden, n, out);
  return out;
}
template <class Sums>
  requires std::is_same_v<std::remove_const_t<Sums>, WorldPart>
auto lights_of(Sums& pixel) {
  std::array<Pointer<Sums>, worlds_a_group> out{};
  for (std::size_t v = 0; v < worlds_a_group; ++v) out[v] = &pixel.seen[v];
  return out;
}
template <class Sums>
  requires std::is_same_v<std::remove_const_t<Sums>, ObjectPart>
auto lights_of(Sums& pixel) {
  return std::array<Pointer<Sums>, 4>{&pixel.object, &pixel.behind, &pixel.behind_with, &pixel.hidden};
}

bool same_samples(const WorldPixel& a, const WorldPixel& b) {
  return a.surfaces == b.surfaces;
}
bool same_samples(const ObjectPixel& a, const ObjectPixel& b) {
  return a.covered == b.covered && a.behind_surfaces == b.behind_surfaces &&
         a.hidden_samples == b.hidden_samples;
}
bool is_seen(const ObjectPixel& pixel) {
  return pixel.covered > 0.0F || pixel.hidden_samples > 0.0F;
}

/// A deep copy.
SceneSums copy_of(const SceneSums& sums, bool with_guides) {
  SceneSums out;
  out.grid = sums.grid;
  out.groups = sums.groups;
  out.halves = sums.halves;
  out.mirrored = sums.mirrored;
  out.sky = sums.sky;
  if (with_guides) out.guides = sums.guides;
  out.objects.resize(sums.objects.size());
  for (std::size_t k = 0; k < sums.objects.size(); ++k)
    for (const auto& tile : sums.objects[k])
      out.objects[k].push_back(tile ? std::make_unique<ObjectTile>(*tile) : nullptr);
  out.spp = sums.spp;
  return out;
}

/// A frame beside its base, after one step.
class Comparison {
 public:
  Comparison(const FrameBase& base, int step, const std::vector<bool>& moved, const SceneSums& sums)
      : base_(base), few_(base.steps[step]), moved_(moved), sums_(sums) {}

  /// Blocks where an object that moved is or was seen.
  [[nodiscard]] std::vector<char> with_what_moved() const {
    std::vector<char> out(sums_.spp.size(), 0);
    for (std::size_t k = 0; k < moved_.size(); ++k)
      if (moved_[k])
        for (int tile = 0; tile < sums_.grid.count(); ++tile)
          for (const SceneSums* from : {&sums_, &base_.whole})
            mark_seen(from->objects[k][tile].get(), tile, out);
    return out;
  }

  enum class Block { as_in_base, beside_base, too_noisy, anew };
  [[nodiscard]] Block judge(int block) const {
    Noise noise;
    const float scale = scale_of(block);
    const BlockGrid::Rectangle r = sums_.blocks().rectangle(block);
    for (int y = r.top; y < r.bottom; ++y)
      for (int x = r.left; x < r.right; ++x)
        if (!add_pixel(x, y, scale, noise)) return Block::anew;
    if (!noise.changes) return Block::as_in_base;
    if (noise.below_zero) return Block::too_noisy;
    for (std::size_t kind = 0; kind < kinds_of_light; ++kind)
      if (noise.of_change[kind] > most_change_noise * noise.of_base[kind]) return Block::too_noisy;
    return Block::beside_base;
  }

  /// From the samples of a step to all.
  [[nodiscard]] float scale_of(int block) const {
    const auto b = static_cast<std::size_t>(block);
    return static_cast<float>(base_.spp[b]) / static_cast<float>(sums_.spp[b]);
  }

 private:
  struct Noise {
    std::array<double, kinds_of_light> of_change = {}, of_base = {};
    bool changes = false, below_zero = false;
  };

  void mark_seen(const ObjectTile* tile, int number, std::vector<char>& out) const {
    if (tile == nullptr) return;
    const TileGrid::Rectangle r = sums_.grid.rectangle(number);
    for (int y = r.top; y < r.bottom; ++y)
      for (int x = r.left; x < r.right; ++x)
        for (const auto& half : tile->halves)
          if (is_seen(half[static_cast<std::size_t>(TileGrid::place(x, y))]))
            out[static_cast<std::size_t>(sums_.blocks().square_of(x, y))] = 1;
  }

  /// False where the camera rays met something else.
  bool add_pixel(int x, int y, float scale, Noise& noise) const {
    for (std::size_t group = 0; group < sums_.groups; ++group) {
      const std::size_t i = sums_.index(x, y) * sums_.groups + group;
      if (!same_samples(sums_.halves[0][i], few_.halves[0][i]) ||
          !same_samples(sums_.halves[1][i], few_.halves[1][i]))
        return false;
      add_lights(sums_.halves, few_.halves, base_.whole.halves, i, {0, 1}, scale, noise);
      add_part(sums_.mirrored, few_.mirrored, base_.whole.mirrored, i, mirrored_light, scale, noise);
      add_part(sums_.sky, few_.sky, base_.whole.sky, i, sky_light, scale, noise);
    }
    const auto tile = static_cast<std::size_t>(sums_.grid.square_of(x, y));
    const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
    for (std::size_t k = 0; k < sums_.objects.size(); ++k) {
      const ObjectTile *now = sums_.objects[k][tile].get(), *then = few_.objects[k][tile].get();
      if (now == nullptr && then == nullptr) continue;
      static const ObjectPixel none;
      for (std::size_t half = 0; half < 2; ++half)
        if (!same_samples(now != nullptr ? now->halves[half][place] : none,
                          then != nullptr ? then->halves[half][place] : none))
          return false;
      if (now == nullptr || then == nullptr) continue;
      const ObjectTile& whole = *base_.whole.objects[k][tile];
      add_lights(now->halves, then->halves, whole.halves, place, {0, 1}, scale, noise);
      add_part(now->mirrored, then->mirrored, whole.mirrored, place, mirrored_light, scale, noise);
      add_part(now->sky, then->sky, whole.sky, place, sky_light, scale, noise);
    }
    return true;
  }

  template <class Sums>
  using Parts = std::array<std::vector<Sums>, 2>;

  template <class Sums>
  static void add_part(const Parts<Sums>& now, const Parts<Sums>& then, const Parts<Sums>& whole,
                       std::size_t i, std::size_t kind, float scale, Noise& noise) {
    if (!now[0].empty()) add_lights(now, then, whole, i, {kind, kind}, scale, noise);
  }

  /// `kinds`: of the lights of a pixel, in turn.
  template <class Sums>
  static void add_lights(const Parts<Sums>& now, const Parts<Sums>& then, const Parts<Sums>& whole,
                         std::size_t i, const std::array<std::size_t, 2>& kinds, float scale, Noise& noise) {
    const auto a = lights_of(now[0][i]), b = lights_of(now[1][i]), c = lights_of(then[0][i]),
               d = lights_of(then[1][i]), e = lights_of(whole[0][i]), f = lights_of(whole[1][i]);
    for (std::size_t n = 0; n < a.size(); ++n) {
      const std::size_t kind = kinds[n % 2];
      noise.of_base[kind] += (*e[n] - *f[n]).square().sum();
      if ((*a[n] == *c[n]).all() && (*b[n] == *d[n]).all()) continue;
      noise.changes = true;
      const Rgb first = scale * (*a[n] - *c[n]), second = scale * (*b[n] - *d[n]);
      noise.of_change[kind] += (first - second).square().sum();
      noise.below_zero = noise.below_zero || (*e[n] + first < 0.0F).any() || (*f[n] + second < 0.0F).any();
    }
  }

  const FrameBase& base_;
  const SceneSums& few_;
  const std::vector<bool>& moved_;
  const SceneSums& sums_;
};

template <class Sums>
void put_beside(const std::vector<Sums>& few, const std::vector<Sums>& whole, std::size_t i, float scale,
                std::vector<Sums>& sums) {
  const auto now = lights_of(sums[i]);
  const auto then = lights_of(few[i]);
  const auto all = lights_of(whole[i]);
  for (std::size_t n = 0; n < now.size(); ++n) *now[n] = *all[n] + scale * (*now[n] - *then[n]);
}

/// The base's sums and what the step changed in them.
void put_beside(const SceneSums& few, const SceneSums& whole, int block, float scale, SceneSums& sums) {
  const BlockGrid::Rectangle r = sums.blocks().rectangle(block);
  for (int y = r.top; y < r.bottom; ++y)
    for (int x = r.left; x < r.right; ++x) {
      const std::size_t pixel = sums.index(x, y);
      for (std::size_t k = 0; k < sums.guides.size(); ++k) sums.guides[k][pixel] = whole.guides[k][pixel];
      for (std::size_t half = 0; half < 2; ++half)
        for (std::size_t i = pixel * sums.groups; i < (pixel + 1) * sums.groups; ++i) {
          put_beside(few.halves[half], whole.halves[half], i, scale, sums.halves[half]);
          sums.halves[half][i].surfaces = whole.halves[half][i].surfaces;
          for (const auto part : {&SceneSums::mirrored, &SceneSums::sky})
            if (!(sums.*part)[half].empty())
              put_beside((few.*part)[half], (whole.*part)[half], i, scale, (sums.*part)[half]);
        }
      const auto tile = static_cast<std::size_t>(sums.grid.square_of(x, y));
      const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
      for (std::size_t k = 0; k < sums.objects.size(); ++k) {
        const ObjectTile *then = few.objects[k][tile].get(), *all = whole.objects[k][tile].get();
        auto& now = sums.objects[k][tile];
        if (all == nullptr) continue;
        if (now == nullptr) {
          now = std::make_unique<ObjectTile>();
          for (auto& half : now->halves) half.resize(tile_pixels);
          for (const auto part : {&ObjectTile::mirrored, &ObjectTile::sky})
            if (!((*all).*part)[0].empty())
              for (auto& half : (*now).*part) half.resize(tile_pixels);
          now->guides.resize(tile_pixels);
        }
        now->guides[place] = all->guides[place];
        now->on_rays[ObjectTile::block_in_tile(x, y)] = all->on_rays[ObjectTile::block_in_tile(x, y)];
        for (std::size_t half = 0; half < 2; ++half) {
          const bool changed =
              then != nullptr &&
              then->halves[half][place].covered + then->halves[half][place].hidden_samples > 0.0F;
          ObjectPixel& own = now->halves[half][place];
          if (!changed) {
            own = all->halves[half][place];
            for (const auto part : {&ObjectTile::mirrored, &ObjectTile::sky})
              if (!((*all).*part)[half].empty()) ((*now).*part)[half][place] = ((*all).*part)[half][place];
            continue;
          }
          put_beside(then->halves[half], all->halves[half], place, scale, now->halves[half]);
          const ObjectPixel& counted = all->halves[half][place];
          own.covered = counted.covered;
          own.behind_surfaces = counted.behind_surfaces;
          own.hidden_samples = counted.hidden_samples;
          for (const auto part : {&ObjectTile::mirrored, &ObjectTile::sky})
            if (!((*all).*part)[half].empty())
              put_beside(((*then).*part)[half], ((*all).*part)[half], place, scale, ((*now).*part)[half]);
        }
      }
    }
  sums.spp[block] = whole.spp[block];
}

/// Which objects stand elsewhere, or look otherwise.
std::vector<bool> moved_objects(const SceneDefinition& base, const SceneDefinition& frame) {
  std::vector<bool> out;
  for (std::size_t k = 0; k < frame.objects.size(); ++k) {
    SceneDefinition then = base, now = base;
    then.objects = {base.objects[k]};
    now.objects = {frame.objects[k]};
    out.push_back(canonical_text(then) != canonical_text(now));
  }
  return out;
}

}  // namespace

int samples_of_step(int step, int spp) {
  constexpr std::array<int, frame_steps> share = {12, 4};
  constexpr int turn = 8;  // a tail in every half
  const int few = turn * std::max(1, (spp / share[step] + turn / 2) / turn);
  return few <= spp / 2 ? few : spp;
}

bool may_be_base(const FrameBase& base, const SceneDefinition& frame, const EstimatorChoices& choices) {
  return base.choices == choices && base.definition.objects.size() == frame.objects.size() &&
         unmoved_meaning(base.definition) == unmoved_meaning(frame);
}

FrameBase make_frame_base(const TruthScene& scene, const SceneGeometry& geometry,
                          const EstimatorChoices& choices, const std::vector<int>& spp,
                          const ScenePassOptions& options) {
  FrameBase base{.definition = scene.definition, .choices = choices, .spp = spp, .steps = {}, .whole = {}};
  SceneSums sums = empty_sums(scene.camera, scene.objects.size());
  for (int step = 0; step < frame_steps; ++step) {
    std::vector<int> wanted;
    wanted.reserve(spp.size());
    for (const int all : spp) wanted.push_back(samples_of_step(step, all));
    add_samples(scene, geometry, wanted, options, sums);
    base.steps.push_back(copy_of(sums, false));
  }
  add_samples(scene, geometry, spp, options, sums);
  base.whole = std::move(sums);
  return base;
}

FrameBlocks add_samples_beside(const FrameBase& base, const TruthScene& scene, const SceneGeometry& geometry,
                               const ScenePassOptions& options, SceneSums& sums) {
  const std::vector<bool> moved = moved_objects(base.definition, scene.definition);
  const auto blocks = base.spp.size();
  std::vector<int> beside(blocks, -1);  // the step of whose samples the change is made
  std::vector<char> open(blocks, 1);    // not decided yet
  std::vector<char> still(blocks, 0);
  for (int step = 0; step < frame_steps; ++step) {
    std::vector<int> wanted(blocks, 0);
    for (std::size_t b = 0; b < blocks; ++b)
      if (open[b] != 0) wanted[b] = samples_of_step(step, base.spp[b]);
    add_samples(scene, geometry, wanted, options, sums);
    const Comparison comparison(base, step, moved, sums);
    if (step == 0) {
      const std::vector<char> seen = comparison.with_what_moved();
      for (std::size_t b = 0; b < blocks; ++b)
        if (seen[b] != 0)
          each_neighbour(sums.blocks(), static_cast<int>(b), [&](std::size_t near) { open[near] = 0; });
    }
    parallel_for(static_cast<int>(blocks), options.threads, [&](int block) {
      const auto b = static_cast<std::size_t>(block);
      if (open[b] == 0 || sums.spp[b] == base.spp[b]) return;
      const Comparison::Block found = comparison.judge(block);
      if (found == Comparison::Block::too_noisy) return;
      open[b] = 0;
      if (found == Comparison::Block::anew) return;
      beside[b] = step;
      still[b] = found == Comparison::Block::as_in_base ? 1 : 0;
    });
  }
  FrameBlocks out;
  std::vector<int> wanted(blocks, 0);
  for (std::size_t b = 0; b < blocks; ++b) {
    if (beside[b] < 0) wanted[b] = base.spp[b];
    ++(beside[b] < 0 ? out.anew : still[b] != 0 ? out.as_in_base : out.beside_base);
  }
  add_samples(scene, geometry, wanted, options, sums);
  out.rays_spared = base.whole.counts.traced - sums.counts.traced;
  for (std::size_t b = 0; b < blocks; ++b)
    if (beside[b] >= 0)
      put_beside(base.steps[static_cast<std::size_t>(beside[b])], base.whole, static_cast<int>(b),
                 static_cast<float>(base.spp[b]) / static_cast<float>(sums.spp[b]), sums);
  return out;
}

}  // namespace seamline::renderer
