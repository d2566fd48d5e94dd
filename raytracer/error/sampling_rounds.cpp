#include "raytracer/error/sampling_rounds.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace seamline::renderer {
namespace {

/// Powers of two and one and a half times them, so that points stay well distributed.
int next_step(int spp) {
  int power = 2;
  while (2 * power <= spp) power *= 2;
  return spp < power + power / 2 && power >= 4 ? power + power / 2 : 2 * power;
}

struct Step {
  double gain_per_sample = 0;
  std::size_t block = 0;
  bool operator<(const Step& other) const {
    return gain_per_sample != other.gain_per_sample ? gain_per_sample < other.gain_per_sample
                                                    : block > other.block;
  }
};
using Steps = std::priority_queue<Step>;

class SampleAllocator {
 public:
  SampleAllocator(const SamplingState& state, const ErrorTarget& target)
      : state_(state),
        blocks_(state.blocks),
        square_in_a_tile_(target.square_in_a_tile()),
        square_(target.rmse * target.rmse - rounding_square),
        expected_(state.image_square) {
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      wanted_.push_back(blocks_[i].spp);
      had_ += blocks_[i].spp;
      if (blocks_[i].spp > 0) ++sampled_blocks_;
      if (blocks_[i].least_spp > blocks_[i].spp) grow_to(i, blocks_[i].least_spp);
    }
  }

  NextSamples plan() {
    NextSamples out{.next = {}, .samples = 0, .suffices = true};
    for (int tile = 0; tile < static_cast<int>(state_.tile_residual.size()); ++tile)
      if (!grow_tile(tile)) out.suffices = false;
    Steps steps;
    for (std::size_t i = 0; i < blocks_.size(); ++i) push(i, steps);
    const bool not_yet = expected_ > square_;
    while (!steps.empty() &&
           (expected_ > square_ || (not_yet && static_cast<double>(added_) < least_added())))
      grow_best(steps);
    out.suffices = out.suffices && expected_ <= square_;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      out.samples +=
          static_cast<double>(wanted_[i] - blocks_[i].spp) * state_.grid.pixels(static_cast<int>(i));
      wanted_[i] = std::min(wanted_[i], most_next(i));
    }
    out.next = std::move(wanted_);
    return out;
  }

 private:
  /// Of the error allowed, what a tile that has more is sampled for: or a few samples would be missing again.
  static constexpr double aim = 0.9;

  /// Until the tile is good enough; false when it does not get there.
  bool grow_tile(int tile) {
    const TileGrid grid{state_.grid.width_px, state_.grid.height_px, state_.grid.wraps};
    Steps steps;
    double square = state_.tile_residual[tile] + rounding_square;
    const auto share = [&](std::size_t block) {
      return state_.grid.weight(static_cast<int>(block)) / grid.weight(tile);
    };
    for (const int block : blocks_of(grid, tile)) {
      const auto i = static_cast<std::size_t>(block);
      square += share(i) * noise(i);
      push(i, steps);
    }
    if (square <= square_in_a_tile_) return true;
    while (square > aim * square_in_a_tile_ && !steps.empty()) {
      const std::size_t i = steps.top().block;
      const double before = noise(i);
      grow_best(steps);
      square -= share(i) * (before - noise(i));
    }
    return square <= square_in_a_tile_;
  }

  void grow_best(Steps& steps) {
    const std::size_t i = steps.top().block;
    steps.pop();
    grow(i);
    push(i, steps);
  }

  [[nodiscard]] double least_added() const {
    return std::max(state_.least_growth * static_cast<double>(had_),
                    0.5 * static_cast<double>(sampled_blocks_));
  }

  [[nodiscard]] double noise(std::size_t i) const { return noise_with(i, wanted_[i]); }
  [[nodiscard]] double noise_with(std::size_t i, int spp) const {
    return blocks_[i].spp > 0 ? blocks_[i].noise * std::pow(static_cast<double>(blocks_[i].spp) / spp, 1.1)
                              : 0.0;
  }
  [[nodiscard]] bool can_grow(std::size_t i) const {
    return blocks_[i].noise > 0 && next_step(wanted_[i]) <= blocks_[i].most_spp;
  }
  /// Four times what a block has: two steps of two each, and no need to round.
  [[nodiscard]] int most_next(std::size_t i) const {
    return std::max(4 * blocks_[i].spp, blocks_[i].least_spp);
  }
  void grow(std::size_t i) { grow_to(i, next_step(wanted_[i])); }
  void grow_to(std::size_t i, int next) {
    expected_ -= state_.grid.share(static_cast<int>(i)) * (noise(i) - noise_with(i, next));
    added_ += next - wanted_[i];
    wanted_[i] = next;
  }
  void push(std::size_t i, Steps& steps) const {
    if (!can_grow(i)) return;
    const int next = next_step(wanted_[i]);
    steps.push({(noise(i) - noise_with(i, next)) / (next - wanted_[i]), i});
  }

  const SamplingState& state_;
  const std::vector<BlockState>& blocks_;
  const double square_in_a_tile_;
  const double square_;  ///< what noise and bias may be
  double expected_;
  std::vector<int> wanted_;
  long had_ = 0, sampled_blocks_ = 0, added_ = 0;
};

}  // namespace

NextSamples next_samples(const SamplingState& state, const ErrorTarget& target) {
  return SampleAllocator(state, target).plan();
}

}  // namespace seamline::renderer
