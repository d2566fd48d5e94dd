#include "renderer/estimators/fast/stimulus_assembly.h"

#include <algorithm>

#include "raytracer/common/parallel.h"
#include "renderer/estimators/fast/filtered_bounce.h"
#include "renderer/estimators/fast/pixel_sky.h"

namespace seamline::renderer {
namespace {

class Assembly {
 public:
  explicit Assembly(const StimulusSources& sources)
      : truth_(sources.truth),
        recipe_(sources.recipe),
        answers_(sources.recipe.answers),
        depth_(sources.depth),
        order_(sources.order),
        dark_layer_(sources.dark_layer) {}

  /// Whether a tile has anything for `add_object`: elsewhere all of it is 0, and most of a picture is not
  /// read.
  [[nodiscard]] bool has_object(std::size_t tile) const {
    const auto& tiles = truth_.scene_sums.objects[truth_.object_index - 1];
    return recipe_.keep == Keep::object_only || tiles[tile] != nullptr;
  }

  /// The object's light, and what is shown of the reference.
  void add_object(int x, int y, std::size_t half, const FilteredBounce& object, StimulusPixel& out) const {
    const Pixel in = gather(x, y, half);
    const std::size_t i = truth_.truth_sums.index(x, y);
    if (recipe_.keep == Keep::object_only)
      out.from_reference =
          in.truth.sky + in.truth.with_object.total() + in.uncovers * in.truth.object.total();
    if (recipe_.keep == Keep::all_but_object)
      out.from_reference =
          in.truth.object.total() + in.covers * Rgb(in.truth.with_object.total() + in.truth.sky);
    else
      out.object =
          object_light(in, (1.0F - in.uncovers) * in.truth.covered, object.texel(i), object.surface(i), half)
              .total();
    if (adds_to_object(answers_)) out.object += added_to_object(x, y, half, in);
    if (recipe_.keep == Keep::everything) out.object += hidden_light(in).total();
  }
  /// Off the object; `as_sampled`: the light without it before the filter, or null where nobody asks.
  void add_uncovered(int x, int y, std::size_t half, const FilteredBounce& uncovered, StimulusPixel& out,
                     float* as_sampled) const {
    const Pixel in = gather(x, y, half);
    const std::size_t i = truth_.truth_sums.index(x, y);
    if (as_sampled != nullptr) {
      StimulusPixel sampled;
      add_uncovered_of(x, y, in, nullptr, nullptr, half, sampled);
      *as_sampled = sampled.without_object.mean();
    }
    add_uncovered_of(x, y, in, uncovered.texel(i), uncovered.surface(i), half, out);
  }

 private:
  /// Everything known of one pixel and half, in the truth's number of samples.
  struct Pixel {
    const TruthPixel& truth;
    const ObjectPixel& own;   ///< in the pixel's own number of samples
    const DepthPixel& depth;  ///< in the depth pass's own number of samples
    const ObjectPart& own_mirrored;
    const ObjectPart& own_sky;
    const DepthMirrored& depth_mirrored;
    float to_sums = 1;   ///< from the pixel's number of samples to the truth's
    float uncovers = 0;  ///< share of the truth's covered samples that the depth mesh uncovers
    float covers = 0;    ///< share of the truth's uncovered samples that it covers
    float newly_covered = 0;
  };

  [[nodiscard]] Pixel gather(int x, int y, std::size_t half) const {
    static const ObjectPixel nothing;
    static const ObjectPart no_part;
    const TruthSums& sums = truth_.truth_sums;
    const std::size_t i = sums.index(x, y);
    const auto tile = static_cast<std::size_t>(truth_.scene_sums.grid.square_of(x, y));
    const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
    const auto& object = truth_.scene_sums.objects[truth_.object_index - 1][tile];
    Pixel in{.truth = sums.halves[half][i],
             .own = object ? object->halves[half][place] : nothing,
             .depth = depth_.halves[half][i],
             .own_mirrored = object ? part_at(object->mirrored[half], place) : no_part,
             .own_sky = object ? part_at(object->sky[half], place) : no_part,
             .depth_mirrored = part_at(depth_.mirrored[half], i)};
    const auto samples_of_pixel = static_cast<float>(truth_.scene_sums.samples_at(x, y));
    in.to_sums = static_cast<float>(sums.spp) / samples_of_pixel;
    if (order_.empty() || order_[tile][half].empty()) return in;
    const OrderPixel& order = order_[tile][half][place];
    const float samples = 0.5F * samples_of_pixel;
    if (in.own.covered > 0) in.uncovers = order.truth_only / in.own.covered;
    if (samples > in.own.covered) in.covers = order.depth_only / (samples - in.own.covered);
    in.newly_covered = order.depth_only * in.to_sums;
    return in;
  }

  /// Light of `covered` samples of the object, without what the depth mesh adds to the truth's. `filtered`
  /// holds its bounce light in the depth mesh, or is null.
  [[nodiscard]] Split object_light(const Pixel& in, float covered, const BounceTexel* filtered,
                                   const Surface* surface, std::size_t half) const {
    if (covered <= 0.0F) return {};
    const Split truth = in.truth.covered > 0.0F ? covered / in.truth.covered * in.truth.object : Split{};
    const bool asked = answers_.bounce == Who::depth || answers_.mirrored == Who::depth;
    if (!asked || in.depth.covered <= 0.0F) return truth;  // or no sample fell on it
    Split depth = covered / in.depth.covered * in.depth.object.with(in.depth_mirrored.object);
    if (answers_.mirrored == Who::truth) depth.mirrored = truth.mirrored;
    if (answers_.bounce == Who::truth) return {truth.direct, truth.bounce, depth.mirrored};
    if (filtered != nullptr && filtered->without_samples(half) > 0.0F)
      depth.bounce =
          filtered->without_object(half) * surface->albedo * (covered / filtered->without_samples(half));
    if (answers_.object_lit == Who::truth) depth.direct = truth.direct;
    return depth;
  }

  /// What sun and sky past the depth mesh add to those of the truth, below 0 where they take away. Where as
  /// many samples were asked as the truth has, they are the same ones, and the truth's sum of them is known.
  [[nodiscard]] Rgb added_to_object(int x, int y, std::size_t half, const Pixel& in) const {
    const auto block = static_cast<std::size_t>(depth_.blocks().square_of(x, y));
    const int asked = depth_.spp.object[block];
    if (asked == 0 || in.depth.covered <= 0.0F) return Rgb::Zero();
    const float to_sums = static_cast<float>(truth_.truth_sums.spp) / static_cast<float>(asked);
    if (asked >= depth_.spp.photograph[block])
      return to_sums * in.depth.object.direct - in.truth.object.direct;
    return to_sums * (in.depth.object.direct - depth_.object_in_truth[half][truth_.truth_sums.index(x, y)]);
  }

  /// Light of the object where the truth hides it and the depth mesh does not, likewise.
  [[nodiscard]] Split hidden_light(const Pixel& in) const {
    if (in.newly_covered <= 0.0F) return {};
    const bool from_depth = answers_.object_lit == Who::depth && answers_.bounce == Who::depth;
    if (from_depth && in.depth.covered > 0.0F)
      return in.newly_covered / in.depth.covered * in.depth.object.with(in.depth_mirrored.object);
    return in.newly_covered / std::max(in.own.hidden_samples, 1.0F) *
           in.own.hidden.with(in.own_mirrored.hidden);
  }

  void add_uncovered_of(int x, int y, const Pixel& in, const BounceTexel* texel, const Surface* surface,
                        std::size_t half, StimulusPixel& out) const {
    const float stays = 1.0F - in.covers;
    const bool uncovers = recipe_.keep == Keep::everything && in.uncovers > 0.0F;
    const float behind = uncovers ? in.uncovers * in.to_sums : 0.0F;
    Split without_object = stays * in.truth.without_object, with_object = stays * in.truth.with_object;
    float uncovered_surfaces = stays * in.truth.uncovered_surfaces;
    out.sky = stays * in.truth.sky;
    if (uncovers) {
      without_object += behind * in.own.behind.with(in.own_mirrored.behind);
      with_object += behind * in.own.behind_with.with(in.own_mirrored.behind_with);
      without_object.direct += behind * in.own_sky.behind;
      with_object.direct += behind * in.own_sky.behind_with;
      uncovered_surfaces += behind * in.own.behind_surfaces;
      if (const float behind_sky = in.own.covered - in.own.behind_surfaces; behind_sky > 0.0F)
        out.sky += behind * behind_sky * pixel_sky(truth_.scene.light, truth_.scene.camera, x, y);
    }
    if (!asks_depth_off_object(answers_)) {
      set_uncovered(uncovered_surfaces, without_object.total(), without_object, with_object, out);
      return;
    }
    const float seen = in.depth.uncovered_surfaces + in.depth.depth_sky;
    const float share = seen > 0.0F ? in.depth.uncovered_surfaces / seen : 0.0F;
    out.sky += (1.0F - share) * without_object.total();
    if (share <= 0.0F) return;
    const Rgb background = share * without_object.total();
    uncovered_surfaces *= share;
    const float to_uncovered = uncovered_surfaces / in.depth.uncovered_surfaces;
    Split depth_without = to_uncovered * in.depth.without_object.with(in.depth_mirrored.without_object),
          depth_with = to_uncovered * in.depth.with_object.with(in.depth_mirrored.with_object);
    if (texel != nullptr)
      filtered_bounce(*texel, *surface, half, uncovered_surfaces, depth_without, depth_with);
    without_object = join(share * without_object, depth_without);
    with_object = join(share * with_object, depth_with);
    set_uncovered(uncovered_surfaces, background, without_object, with_object, out);
  }

  /// Light that truth and depth mesh answer together.
  [[nodiscard]] Split join(const Split& truth, const Split& depth) const {
    if (dark_layer_) return depth;
    const bool direct_from_truth = answers_.receiver == Who::truth && answers_.real_lit == Who::truth;
    if (answers_.bounce == Who::truth)
      return {depth.total(), truth.bounce, truth.mirrored};  // the sky is in depth.bounce
    return direct_from_truth ? Split{truth.direct, depth.bounce, depth.mirrored} : depth;
  }

  static void filtered_bounce(const BounceTexel& texel, const Surface& surface, std::size_t half,
                              float uncovered_surfaces, Split& without_object, Split& with_object) {
    if (texel.without_samples(half) <= 0.0F) return;
    const Rgb to_uncovered = surface.albedo * (uncovered_surfaces / texel.without_samples(half));
    without_object.bounce = texel.without_object(half) * to_uncovered;
    with_object.bounce = without_object.bounce + texel.change(half) * to_uncovered;
  }

  static void set_uncovered(float uncovered_surfaces, const Rgb& background, const Split& without_object,
                            const Split& with_object, StimulusPixel& out) {
    out.uncovered_surfaces = uncovered_surfaces;
    out.background = background;
    out.without_object = without_object.total();
    out.with_object = with_object.total();
  }

  const ObjectTruth& truth_;
  const Recipe& recipe_;
  const Answers& answers_;
  const DepthAnswers& depth_;
  const ObjectOrder& order_;
  bool dark_layer_;
};

}  // namespace

namespace {

/// What all parts of a stimulus have in common; its pixels are empty.
StimulusSums empty_sums(const StimulusSources& sources) {
  const TruthSums& truth = sources.truth.truth_sums;
  StimulusSums out{.width_px = truth.width_px, .height_px = truth.height_px, .spp = truth.spp};
  out.wraps = sources.depth.grid.wraps;
  out.depth_lights_uncovered = depth_lights_uncovered(sources.recipe.answers) && !sources.dark_layer;
  out.compositing = sources.compositing;
  out.rays = sources.depth.counts.traced;
  return out;
}

/// Puts some tiles of a stimulus together, in the halves that it has; the others stay as they are.
class TilesAssembly {
 public:
  TilesAssembly(const StimulusSources& sources, const DepthFilters& filters, const TileSet& tiles,
                int threads, StimulusSums& out)
      : sources_(sources),
        filters_(filters),
        tiles_(tiles),
        threads_(threads),
        assembly_(sources),
        out_(out) {}

  void empty() {
    each_pixel(false, [&](std::size_t i, int, int, std::size_t half, bool) { out_.halves[half][i] = {}; });
  }
  /// A hundred bytes a pixel until it ends.
  void add_object() {
    FilteredBounce object;
    const bool on_object =
        sources_.recipe.answers.bounce == Who::depth && sources_.recipe.keep != Keep::all_but_object;
    if (on_object && filters_.object.levels > 0)
      object = filtered_object(sources_.truth, sources_.depth, filters_.object, tiles_, threads_);
    each_pixel(true, [&](std::size_t i, int x, int y, std::size_t half, bool is_filtered) {
      assembly_.add_object(x, y, half, is_filtered ? object : unfiltered_, out_.halves[half][i]);
    });
  }
  /// Likewise. With `guides_are_known` those of the sums are let be.
  void add_uncovered(bool guides_are_known) {
    FilteredBounce uncovered;
    if (!sources_.depth.guides.empty() && !(guides_are_known && filters_.ratio.levels == 0))
      uncovered = filtered_uncovered(sources_.truth, sources_.depth, filters_.ratio, lending(), tiles_,
                                     threads_, out_.guides);
    if (sources_.recipe.keep == Keep::object_only) return;
    const bool sealed_in = has_wells() && !uncovered.texels.empty();
    for (std::size_t half = 0; half < 2; ++half)
      if (sealed_in) out_.light_as_sampled[half].resize(out_.halves[half].size());
    each_pixel(false, [&](std::size_t i, int x, int y, std::size_t half, bool is_filtered) {
      assembly_.add_uncovered(x, y, half, is_filtered ? uncovered : unfiltered_, out_.halves[half][i],
                              sealed_in ? &out_.light_as_sampled[half][i] : nullptr);
    });
  }

 private:
  /// Sky alone, all that is filtered where the truth answers bounce light, does not gather in wells.
  [[nodiscard]] bool has_wells() const {
    return out_.depth_lights_uncovered && sources_.recipe.answers.bounce == Who::depth;
  }
  [[nodiscard]] TileSet lending() const { return has_wells() ? filters_.tiles : TileSet{}; }

  template <class Add>
  void each_pixel(bool object_only, const Add& add) const {
    const TileGrid& grid = sources_.depth.grid;
    parallel_for(grid.count(), threads_, [&](int number) {
      const auto tile = static_cast<std::size_t>(number);
      if (tiles_[tile] == 0 || (object_only && !assembly_.has_object(tile))) return;
      const bool is_filtered = filters_.tiles.empty() || filters_.tiles[tile] != 0;
      const TileGrid::Rectangle r = grid.rectangle(number);
      for (int y = r.top; y < r.bottom; ++y)
        for (int x = r.left; x < r.right; ++x)
          for (std::size_t half = 0; half < 2; ++half)
            if (!out_.halves[half].empty()) add(grid.index(x, y), x, y, half, is_filtered);
    });
  }

  const StimulusSources& sources_;
  const DepthFilters& filters_;
  const TileSet& tiles_;
  int threads_;
  Assembly assembly_;
  FilteredBounce unfiltered_;
  StimulusSums& out_;
};

TileSet all_tiles(const TileGrid& grid) {
  return TileSet(static_cast<std::size_t>(grid.count()), 1);
}

/// Whether a filter's light comes from the tile itself and the eight around it, with what it is divided by.
bool stays_beside(const FilterStrength& strength) {
  return 2 * filter_radius_px(strength) <= TileGrid::side_px;
}

}  // namespace

StimulusSums assemble_stimulus(const StimulusSources& sources, const DepthFilters& filters, int threads) {
  StimulusSums out = empty_sums(sources);
  const TruthSums& truth = sources.truth.truth_sums;
  for (auto& half : out.halves) half.resize(truth.guides.size());
  out.guides = truth.guides;
  const TileSet tiles = all_tiles(sources.depth.grid);
  TilesAssembly assembly(sources, filters, tiles, threads, out);
  assembly.add_object();
  assembly.add_uncovered(false);
  return out;
}

void assemble_again(const StimulusSources& sources, const DepthFilters& filters, const TileSet& changed,
                    int threads, StimulusSums& sums) {
  const TileGrid& grid = sources.depth.grid;
  const bool near = stays_beside(filters.ratio) && stays_beside(filters.object);
  // Light comes from a tile away, and whether a tile is filtered at all is asked of those a tile away from
  // it.
  const TileSet tiles = near ? with_neighbours(grid, with_neighbours(grid, changed)) : all_tiles(grid);
  sums.rays = sources.depth.counts.traced;
  TilesAssembly assembly(sources, filters, tiles, threads, sums);
  assembly.empty();
  assembly.add_object();
  assembly.add_uncovered(false);
}

StimulusSums assemble_half_as_sampled(const StimulusSources& sources, const StimulusSums& made,
                                      std::size_t half, int threads) {
  StimulusSums out = empty_sums(sources);
  out.halves[half].resize(made.halves[half].size());
  out.guides = made.guides;
  const TileSet tiles = all_tiles(sources.depth.grid);
  const DepthFilters none{.ratio = no_filter, .object = no_filter, .tiles = {}};
  TilesAssembly assembly(sources, none, tiles, threads, out);
  assembly.add_object();
  assembly.add_uncovered(true);
  return out;
}

}  // namespace seamline::renderer
