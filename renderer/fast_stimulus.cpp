#include "renderer/fast_stimulus.h"

#include <algorithm>
#include <limits>
#include <span>

#include "renderer/composite.h"
#include "renderer/stimulus_assembly.h"

namespace seamline {
namespace {

/// Renders one stimulus in rounds.
class StimulusRounds {
 public:
  StimulusRounds(const ObjectTruth& truth, const Geometry* depth, const Recipe& recipe,
                 const FastStimulusOptions& options)
      : truth_(truth),
        recipe_(recipe),
        options_(options),
        sampler_(truth.scene, truth.geometry, depth, recipe, options.seed, {true, options.tail_every}),
        depth_(empty_answers(truth.scene.camera, recipe.answers)),
        shows_object_(pixels_with_object()),
        filtered_(static_cast<std::size_t>(depth_.grid.count()), 1) {
    const bool order_differs = recipe.answers.occlusion == Who::depth;
    if (order_differs)
      order_ = ask_order(truth.scene, truth.sums, truth.object_index, *depth, options.seed, options.threads);
  }

  FastStimulus run() {
    FastStimulus out;
    DepthSamples wanted = first_samples();
    for (int round = 0;; ++round) {
      ask_depth(sampler_, wanted, shows_object_, options_.threads, round == 0 ? options_.progress : nullptr,
                depth_);
      out.layers = {};  // the round before's: one at a time in memory
      out.layers = layers(filters());
      Judgement judged = judge(out.layers);
      out.error = judged.error;
      if (good_enough(out.error)) break;
      if (plan_more(judged, wanted)) continue;
      if (looks_for_bias_) break;
      looks_for_bias_ = true;
    }
    out.saved = savings();
    if (!options_.omit.untouched_tiles) out.layers = with_untouched_tiles();
    return out;
  }

 private:
  /// Whether the depth mesh decides how an object in the block is lit.
  [[nodiscard]] bool lights_object(std::size_t block) const {
    const Answers& answers = recipe_.answers;
    if (recipe_.keep == Keep::rest_layer) return false;
    if (answers.object_lit == Who::truth && answers.bounce == Who::truth) return false;
    const BlockGrid::Rectangle r = truth_.sums.blocks().rectangle(static_cast<int>(block));
    if (answers.occlusion == Who::depth)  // where it may show is not known beforehand
      return truth_.sums.objects[static_cast<std::size_t>(truth_.object_index - 1)][static_cast<std::size_t>(
                 truth_.sums.grid.square_of(r.left, r.top))] != nullptr;
    for (int y = r.top; y < r.bottom; ++y)
      for (int x = r.left; x < r.right; ++x)
        if (shows_object_[truth_.layers.index(x, y)] != 0) return true;
    return false;
  }

  /// A flag a pixel: whether the object is seen through it, in the truth or in the depth mesh.
  [[nodiscard]] std::vector<char> pixels_with_object() const {
    const TruthLayers& layers = truth_.layers;
    const bool also_hidden = recipe_.answers.occlusion == Who::depth;
    const auto& tiles = truth_.sums.objects[static_cast<std::size_t>(truth_.object_index - 1)];
    std::vector<char> flags(layers.guides.size(), 0);
    for (int y = 0; y < layers.height_px; ++y)
      for (int x = 0; x < layers.width_px; ++x) {
        const ObjectTile* tile = tiles[static_cast<std::size_t>(truth_.sums.grid.square_of(x, y))].get();
        if (tile == nullptr) continue;
        const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
        for (const auto& half : tile->halves)
          if (half[place].covered > 0.0F || (also_hidden && half[place].hidden_samples > 0.0F))
            flags[layers.index(x, y)] = 1;
      }
    return flags;
  }

  /// Whether the depth mesh has anything to say about the light off the object.
  [[nodiscard]] bool lights_rest() const {
    return recipe_.keep != Keep::object_layer && asks_depth_for_rest(recipe_.answers);
  }

  static constexpr int pilot = 4;
  /// A few where only a ratio is asked for; on the object as many as the truth has, because its noise must
  /// not give it away.
  [[nodiscard]] int first_rest_samples(std::size_t block) const {
    const int all = truth_.sums.spp[block];
    return options_.target && options_.omit.ratio_samples ? std::min(pilot, all) : all;
  }

  /// The picture with the omission turned off: the same, because nothing in these tiles uses the answers.
  /// They are asked last, so that they do not change how the other tiles are sampled.
  StimulusLayers with_untouched_tiles() {
    DepthSamples wanted = depth_.spp;
    for (std::size_t b = 0; b < wanted.rest.size(); ++b) {
      if (wanted.rest[b] == 0) wanted.rest[b] = first_rest_samples(b);
      if (wanted.object[b] == 0) wanted.object[b] = truth_.sums.spp[b];
    }
    ask_depth(sampler_, wanted, shows_object_, options_.threads, nullptr, depth_);
    return layers(filters());
  }

  [[nodiscard]] Savings savings() const {
    Savings saved{.omitted = depth_.omitted, .depth_rays = depth_.rays, .stimuli = 1};
    std::int64_t asked = 0;
    for (std::size_t b = 0; b < depth_.spp.rest.size(); ++b) {
      const std::int64_t pixels = depth_.blocks().pixels(static_cast<int>(b));
      asked += pixels * depth_.spp.rest[b];
      if (depth_.spp.rest[b] > 0) {
        saved.ratio_samples += pixels * std::max(0, truth_.sums.spp[b] - depth_.spp.rest[b]);
      } else if (depth_.spp.object[b] == 0 && options_.omit.untouched_tiles) {
        constexpr int geometries = 3;  // truth, object and depth mesh, a camera ray each
        ++saved.untouched_blocks;
        saved.untouched_rays += geometries * pixels * first_rest_samples(b);
      }
    }
    if (asked > 0)
      saved.ratio_rays = static_cast<double>(saved.ratio_samples) * static_cast<double>(depth_.rays) /
                         static_cast<double>(asked);
    return saved;
  }

  [[nodiscard]] DepthSamples first_samples() const {
    DepthSamples wanted = depth_.spp;
    for (std::size_t b = 0; b < wanted.rest.size(); ++b) {
      if (lights_rest()) wanted.rest[b] = first_rest_samples(b);
      if (lights_object(b)) wanted.object[b] = truth_.sums.spp[b];
    }
    return wanted;
  }

  [[nodiscard]] bool good_enough(const ErrorEstimate& error) const {
    return !options_.target || options_.target->met_by(error);
  }

  /// The picture's error as it is, and as it would be if no light of the depth mesh were filtered.
  struct Judgement {
    ErrorEstimate error;
    std::optional<ErrorEstimate> unfiltered;
  };

  /// What each block should have next, and which tiles go without the filter; false when nothing can
  /// be gained. Samples are added to the rest, and to the object where nothing else is asked for.
  bool plan_more(const Judgement& judged, DepthSamples& wanted) {
    const std::vector<std::size_t> biased = biased_tiles(judged);
    SamplingPlan best = plan_samples(state(judged, {}), *options_.target);
    std::size_t unfiltered = 0;
    // As many as make the fewest samples, of those that it pays for most.
    for (std::size_t some = 1; some <= biased.size(); some += (some + 1) / 2) {
      SamplingPlan plan = plan_samples(state(judged, std::span(biased).first(some)), *options_.target);
      if (best.suffices && (!plan.suffices || plan.samples >= best.samples)) continue;
      best = std::move(plan);
      unfiltered = some;
    }
    for (std::size_t i = 0; i < unfiltered; ++i) filtered_[biased[i]] = 0;
    for (std::size_t b = 0; b < best.next.size(); ++b) {
      if (lights_rest()) wanted.rest[b] = std::max(wanted.rest[b], best.next[b]);
      if (wanted.object[b] > 0) wanted.object[b] = std::max(wanted.object[b], best.next[b]);
    }
    return unfiltered > 0 || wanted.rest != depth_.spp.rest || wanted.object != depth_.spp.object;
  }

  /// A tile's bias is known to a fifteenth of its unfiltered noise (the product of two halves' changes, over
  /// a thousand pixels): what is less than three times that may be none, and is left alone in a tile that is
  /// good enough.
  static constexpr double surely = 0.2;

  /// Tiles that the filter makes worse, those first whose bias costs fewest samples to be rid of.
  [[nodiscard]] std::vector<std::size_t> biased_tiles(const Judgement& judged) const {
    if (!judged.unfiltered) return {};
    std::vector<std::pair<double, std::size_t>> gains;
    for (std::size_t t = 0; t < filtered_.size(); ++t) {
      const SquaredError &photograph = truth_.error.tiles[t], &error = judged.error.tiles[t];
      const double bias = error.bias - std::max(0.0, photograph.bias);
      const bool too_wrong = error.total() + rounding_square > options_.target->square_in_a_tile();
      const double least = too_wrong ? 0 : surely * judged.unfiltered->tiles[t].noise;
      if (filtered_[t] == 0 || !(bias > least)) continue;
      gains.emplace_back(
          too_wrong ? -std::numeric_limits<double>::infinity() : -bias / samples_without_filter(judged, t),
          t);
    }
    std::sort(gains.begin(), gains.end());
    std::vector<std::size_t> tiles;
    for (const auto& [gain, tile] : gains) tiles.push_back(tile);
    return tiles;
  }

  /// Samples that a tile needs without the filter to be as free of noise as it is with it.
  [[nodiscard]] double samples_without_filter(const Judgement& judged, std::size_t tile) const {
    const double photograph = truth_.error.tiles[tile].noise;
    const double unfiltered = std::max(judged.unfiltered->tiles[tile].noise - photograph, 0.0);
    const double filtered = std::max(judged.error.tiles[tile].noise - photograph, 1e-3 * unfiltered);
    double samples = 0;
    for (const int block : blocks_of(depth_.grid, static_cast<int>(tile))) {
      const auto b = static_cast<std::size_t>(block);
      const int spp = asked_of(b);
      samples += depth_.blocks().pixels(block) * std::max({1.0, static_cast<double>(truth_.sums.spp[b] - spp),
                                                           spp * (unfiltered / filtered - 1)});
    }
    return samples;
  }

  /// What there is to plan with when some tiles go without the filter. The photograph's own noise is there
  /// already. Samples have to do what the filter did: as many as the photograph has, or the tile's noise
  /// would show as a patch.
  [[nodiscard]] SamplingState state(const Judgement& judged, std::span<const std::size_t> unfiltered) const {
    TileSet without(filtered_.size(), 0);
    for (const std::size_t tile : unfiltered) without[tile] = 1;
    SamplingState state{
        .grid = depth_.blocks(), .blocks = {}, .tile_rest = {}, .image_square = judged.error.image.total()};
    for (std::size_t t = 0; t < without.size(); ++t) {
      const ErrorEstimate& error = without[t] == 0 ? judged.error : *judged.unfiltered;
      state.tile_rest.push_back(std::max(0.0, error.tiles[t].bias));
      state.image_square +=
          depth_.grid.share(static_cast<int>(t)) * (error.tiles[t].total() - judged.error.tiles[t].total());
    }
    for (std::size_t b = 0; b < judged.error.blocks.size(); ++b) {
      const BlockGrid::Rectangle r = depth_.blocks().rectangle(static_cast<int>(b));
      const int tile = depth_.grid.square_of(r.left, r.top);
      const bool is_without = without[static_cast<std::size_t>(tile)] != 0;
      const double all = (is_without ? *judged.unfiltered : judged.error).blocks[b].noise;
      const double photograph = std::min(truth_.error.blocks[b].noise, all);
      const int spp = asked_of(b);
      state.blocks.push_back({.noise = all - photograph,
                              .spp = spp,
                              .least_spp = is_without && spp > 0 ? truth_.sums.spp[b] : 0,
                              .most_spp = spp > 0 ? most_samples(b) : 0});
      state.tile_rest[static_cast<std::size_t>(tile)] +=
          photograph * depth_.blocks().pixels(static_cast<int>(b)) / depth_.grid.pixels(tile);
    }
    return state;
  }

  [[nodiscard]] int asked_of(std::size_t block) const {
    return lights_rest() ? depth_.spp.rest[block] : depth_.spp.object[block];
  }
  /// How often a block is asked at most: where a photograph needs few samples, the ratio may need more.
  [[nodiscard]] int most_samples(std::size_t block) const { return 16 * truth_.sums.spp[block]; }

  [[nodiscard]] DepthFilters filters() const {
    return {.ratio = options_.ratio_filter, .object = options_.filter, .tiles = filtered_};
  }
  [[nodiscard]] static DepthFilters no_filters() {
    return {.ratio = {.levels = 0}, .object = {.levels = 0}, .tiles = {}};
  }

  [[nodiscard]] StimulusLayers layers(const DepthFilters& filters,
                                      std::optional<std::size_t> only_half = {}) const {
    return assemble_stimulus({truth_, recipe_, depth_, order_}, filters, options_.threads, only_half);
  }

  /// Noise from the picture's halves; bias of the photograph's filter, and of the depth mesh's own. That one
  /// is not looked for before the noise is low enough: a ratio of very few samples is biased itself, and the
  /// filter would be blamed for it.
  [[nodiscard]] Judgement judge(const StimulusLayers& made) {
    HalfPictures pictures;
    for (std::size_t half = 0; half < 2; ++half)
      pictures.filtered[half] = compose_half(made, half, options_.threads).picture;
    pictures.sampled = pictures.filtered;
    ErrorEstimate noise = with_bias_of_truth(pictures);
    looks_for_bias_ = looks_for_bias_ || good_enough(noise);
    const bool filtered = !depth_.guides.empty() || recipe_.answers.bounce == Who::depth;
    if (!filtered || !looks_for_bias_) return {std::move(noise), {}};
    for (std::size_t half = 0; half < 2; ++half)  // one at a time in memory
      pictures.sampled[half] = compose_half(layers(no_filters(), half), half, options_.threads).picture;
    ErrorEstimate error = with_bias_of_truth(pictures);
    pictures.filtered = pictures.sampled;
    return {std::move(error), with_bias_of_truth(pictures)};
  }

  [[nodiscard]] ErrorEstimate with_bias_of_truth(const HalfPictures& pictures) const {
    ErrorEstimate error = estimate_error(pictures, truth_.scene.definition.exposure_ev, options_.threads);
    error.image.bias = std::max(0.0, error.image.bias) + std::max(0.0, truth_.error.image.bias);
    for (std::size_t t = 0; t < error.tiles.size(); ++t)
      error.tiles[t].bias = std::max(0.0, error.tiles[t].bias) + std::max(0.0, truth_.error.tiles[t].bias);
    return error;
  }

  const ObjectTruth& truth_;
  const Recipe& recipe_;
  const FastStimulusOptions& options_;
  StimulusSampler sampler_;
  DepthAnswers depth_;
  ObjectOrder order_;
  std::vector<char> shows_object_;  ///< a flag a pixel
  TileSet filtered_;                ///< tiles where light of the depth mesh is filtered
  bool looks_for_bias_ = false;
};

}  // namespace

FastStimulus render_fast_stimulus(const ObjectTruth& truth, const Geometry* depth, const Recipe& recipe,
                                  const FastStimulusOptions& options) {
  return StimulusRounds(truth, depth, recipe, options).run();
}

}  // namespace seamline
