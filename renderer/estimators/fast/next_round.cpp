#include "renderer/estimators/fast/next_round.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace seamline::renderer {
namespace {

class RoundChooser {
 public:
  explicit RoundChooser(const StimulusState& state)
      : state_(state),
        blocks_{state.grid.width_px, state.grid.height_px, state.grid.wraps},
        photograph_(state.photograph),
        error_(state.judged.error) {}

  NextRound plan() const {
    const std::vector<std::size_t> biased = biased_tiles();
    NextSamples best = next_samples(without_filter({}), state_.target);
    std::size_t unfiltered = 0;
    for (std::size_t some = 1; some <= biased.size(); some += (some + 1) / 2) {
      NextSamples plan = next_samples(without_filter(std::span(biased).first(some)), state_.target);
      if (best.suffices && (!plan.suffices || plan.samples >= best.samples)) continue;
      best = std::move(plan);
      unfiltered = some;
    }
    return {std::move(best.next), {biased.begin(), biased.begin() + static_cast<std::ptrdiff_t>(unfiltered)}};
  }

 private:
  [[nodiscard]] const ErrorEstimate& unfiltered() const { return *state_.judged.unfiltered; }

  /// Tiles that the filter makes worse: first those that are not good enough, then those whose bias costs
  /// fewest samples to be rid of.
  [[nodiscard]] std::vector<std::size_t> biased_tiles() const {
    if (!state_.judged.unfiltered) return {};
    std::vector<std::pair<double, std::size_t>> gains;
    for (std::size_t t = 0; t < state_.filtered.size(); ++t) {
      const SquaredError& error = error_.tiles[t];
      const double bias = error.bias - std::max(0.0, photograph_.tiles[t].bias);
      const bool too_wrong = error.total() + rounding_square > state_.target.square_in_a_tile();
      const double least = too_wrong ? 0 : state_.choices.surely_biased * unfiltered().tiles[t].noise;
      if (state_.filtered[t] == 0 || !(bias > least)) continue;
      const double gain = too_wrong ? std::numeric_limits<double>::infinity() : bias / samples_instead(t);
      gains.emplace_back(-gain, t);
    }
    std::sort(gains.begin(), gains.end());
    std::vector<std::size_t> tiles;
    for (const auto& [gain, tile] : gains) tiles.push_back(tile);
    return tiles;
  }

  /// Samples that a tile needs without the filter to be as free of noise as it is with it.
  [[nodiscard]] double samples_instead(std::size_t tile) const {
    const double of_photograph = photograph_.tiles[tile].noise;
    const double without = std::max(unfiltered().tiles[tile].noise - of_photograph, 0.0);
    const double with = std::max(error_.tiles[tile].noise - of_photograph, 1e-3 * without);
    double samples = 0;
    for (const int block : blocks_of(state_.grid, static_cast<int>(tile))) {
      const auto b = static_cast<std::size_t>(block);
      const int spp = state_.asked_spp[b];
      samples += blocks_.pixels(block) * std::max({1.0, static_cast<double>(state_.photograph_spp[b] - spp),
                                                   spp * (without / with - 1)});
    }
    return samples;
  }

  /// Where the picture would stand if these tiles went without the filter. The photograph's noise is there
  /// already.
  [[nodiscard]] SamplingState without_filter(std::span<const std::size_t> tiles) const {
    TileSet without(state_.filtered.size(), 0);
    for (const std::size_t tile : tiles) without[tile] = 1;
    SamplingState out{.grid = blocks_,
                      .blocks = {},
                      .tile_residual = {},
                      .image_square = error_.image.total(),
                      .least_growth = std::min(0.5, std::ldexp(1.0 / 16, state_.round))};
    for (std::size_t t = 0; t < without.size(); ++t) {
      const SquaredError& expected = without[t] == 0 ? error_.tiles[t] : unfiltered().tiles[t];
      out.tile_residual.push_back(std::max(0.0, expected.bias));
      out.image_square +=
          state_.grid.share(static_cast<int>(t)) * (expected.total() - error_.tiles[t].total());
    }
    for (std::size_t b = 0; b < error_.blocks.size(); ++b) {
      const int tile = tile_of_block(state_.grid, static_cast<int>(b));
      const bool is_without = without[tile] != 0;
      const double noise = (is_without ? unfiltered() : error_).blocks[b].noise;
      const double of_photograph =
          std::min(photograph_.blocks[b].noise + (state_.stays != nullptr ? (*state_.stays)[b] : 0), noise);
      const int spp = state_.asked_spp[b], photograph_spp = state_.photograph_spp[b];
      out.blocks.push_back(
          {.noise = noise - of_photograph,
           .spp = spp,
           .least_spp = is_without && spp > 0 ? photograph_spp : 0,
           .most_spp = spp > 0 ? state_.choices.most_times_photograph_spp * photograph_spp : 0});
      out.tile_residual[tile] +=
          of_photograph * blocks_.weight(static_cast<int>(b)) / state_.grid.weight(tile);
    }
    return out;
  }

  const StimulusState& state_;
  const BlockGrid blocks_;
  const ErrorEstimate& photograph_;
  const ErrorEstimate& error_;
};

}  // namespace

NextRound next_round(const StimulusState& state) {
  return RoundChooser(state).plan();
}

}  // namespace seamline::renderer
