#include "renderer/fast_stimulus.h"

#include <algorithm>

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
        depth_(empty_answers(truth.scene.camera, recipe.answers)) {
    const bool order_differs = recipe.answers.occlusion == Who::depth;
    if (order_differs)
      order_ = ask_order(truth.scene, truth.sums, truth.object_index, *depth, options.seed, options.threads);
  }

  FastStimulus run() {
    FastStimulus out;
    std::vector<int> wanted = first_samples();
    for (int round = 0;; ++round) {
      ask_depth(sampler_, wanted, options_.threads, round == 0 ? options_.progress : nullptr, depth_);
      out.layers = layers(true);
      out.error = error_of(out.layers);
      if (!options_.target || options_.target->met_by(out.error)) break;
      const std::vector<TileState> tiles = states(out.error);
      wanted = next_samples(tiles, *options_.target);
      if (wanted == depth_.spp) {
        out.error = error_of(out.layers, LookForBias::always);
        break;
      }
    }
    out.saved = savings();
    if (!options_.omit.untouched_tiles) out.layers = with_untouched_tiles();
    return out;
  }

 private:
  /// Whether the depth mesh has anything to say about the light in a tile.
  [[nodiscard]] bool concerns(std::size_t tile) const {
    return lights_object(tile) ||
           (recipe_.keep != Keep::object_layer && asks_depth_for_rest(recipe_.answers));
  }

  /// Whether the depth mesh decides how an object in the tile is lit.
  [[nodiscard]] bool lights_object(std::size_t tile) const {
    const Answers& answers = recipe_.answers;
    if (recipe_.keep == Keep::rest_layer) return false;
    if (answers.object_lit == Who::truth && answers.bounce == Who::truth) return false;
    const auto& object = truth_.sums.objects[static_cast<std::size_t>(truth_.object_index - 1)][tile];
    if (object == nullptr || answers.occlusion == Who::depth) return object != nullptr;
    const auto covers = [](const ObjectSums& sums) { return sums.covered > 0.0F; };
    return std::any_of(object->halves[0].begin(), object->halves[0].end(), covers) ||
           std::any_of(object->halves[1].begin(), object->halves[1].end(), covers);
  }

  static constexpr int pilot = 4;
  /// A few where only a ratio is asked for; on the object as many as the truth has, because its noise must
  /// not give it away.
  [[nodiscard]] int first_samples_of(std::size_t tile) const {
    const int all = truth_.sums.spp[tile];
    return options_.target && options_.omit.ratio_samples && !lights_object(tile) ? std::min(pilot, all)
                                                                                  : all;
  }

  /// The picture with the omission turned off: the same, because nothing in these tiles uses the answers.
  /// They are asked last, so that they do not change how the other tiles are sampled.
  StimulusLayers with_untouched_tiles() {
    std::vector<int> wanted = depth_.spp;
    for (std::size_t t = 0; t < wanted.size(); ++t)
      if (wanted[t] == 0) wanted[t] = first_samples_of(t);
    ask_depth(sampler_, wanted, options_.threads, nullptr, depth_);
    return layers(true);
  }

  [[nodiscard]] Savings savings() const {
    Savings saved{.omitted = depth_.omitted, .depth_rays = depth_.rays, .stimuli = 1};
    std::int64_t asked = 0;
    for (std::size_t t = 0; t < depth_.spp.size(); ++t) {
      const std::int64_t pixels = depth_.grid.pixels(static_cast<int>(t));
      asked += pixels * depth_.spp[t];
      if (depth_.spp[t] > 0) {
        saved.ratio_samples += pixels * std::max(0, truth_.sums.spp[t] - depth_.spp[t]);
      } else if (options_.omit.untouched_tiles) {
        constexpr int geometries = 3;  // truth, object and depth mesh, a camera ray each
        ++saved.untouched_tiles;
        saved.untouched_rays += geometries * pixels * first_samples_of(t);
      }
    }
    if (asked > 0)
      saved.ratio_rays = static_cast<double>(saved.ratio_samples) * static_cast<double>(depth_.rays) /
                         static_cast<double>(asked);
    return saved;
  }

  [[nodiscard]] std::vector<int> first_samples() const {
    std::vector<int> wanted(truth_.sums.spp.size());
    for (std::size_t t = 0; t < wanted.size(); ++t)
      if (concerns(t)) wanted[t] = first_samples_of(t);
    return wanted;
  }

  [[nodiscard]] std::vector<TileState> states(const ErrorEstimate& error) const {
    std::vector<TileState> tiles(error.tiles.size());
    for (std::size_t t = 0; t < tiles.size(); ++t) {
      const double photograph = std::min(truth_.error.tiles[t].noise, error.tiles[t].noise);
      tiles[t] = {.noise = error.tiles[t].noise - photograph,
                  .rest = photograph + std::max(0.0, error.tiles[t].bias),
                  .spp = depth_.spp[t],
                  .share = depth_.grid.share(static_cast<int>(t)),
                  .most_spp = depth_.spp[t] > 0 ? 4 * truth_.sums.spp[t] : 0};
    }
    return tiles;
  }

  [[nodiscard]] StimulusLayers layers(bool filtered) const {
    constexpr FilterStrength as_sampled = {.levels = 0};
    return assemble_stimulus({truth_, recipe_, depth_, order_},
                             {.ratio = filtered ? options_.ratio_filter : as_sampled,
                              .object = filtered ? options_.filter : as_sampled},
                             options_.threads);
  }

  /// Noise from the picture's halves; bias of the photograph's filter, and of the depth mesh's own, which is
  /// only worth looking for when the noise is low enough.
  enum class LookForBias { when_noise_is_low, always };
  [[nodiscard]] ErrorEstimate error_of(const StimulusLayers& made,
                                       LookForBias look = LookForBias::when_noise_is_low) const {
    HalfPictures pictures;
    for (std::size_t half = 0; half < 2; ++half)
      pictures.filtered[half] = compose_half(made, half, options_.threads).picture;
    pictures.sampled = pictures.filtered;
    const ErrorEstimate noise = with_bias_of_truth(pictures);
    const bool filtered = !depth_.guides.empty() || recipe_.answers.bounce == Who::depth;
    const bool too_noisy = options_.target && !options_.target->met_by(noise);
    if (!filtered || (too_noisy && look == LookForBias::when_noise_is_low)) return noise;
    const StimulusLayers sampled = layers(false);
    for (std::size_t half = 0; half < 2; ++half)
      pictures.sampled[half] = compose_half(sampled, half, options_.threads).picture;
    return with_bias_of_truth(pictures);
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
};

}  // namespace

FastStimulus render_fast_stimulus(const ObjectTruth& truth, const Geometry* depth, const Recipe& recipe,
                                  const FastStimulusOptions& options) {
  return StimulusRounds(truth, depth, recipe, options).run();
}

}  // namespace seamline
