#include "renderer/sampling_rounds.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace seamline {
namespace {

/// Powers of two and one and a half times them, so that points stay well distributed.
int next_step(int spp) {
  int power = 2;
  while (2 * power <= spp) power *= 2;
  return spp < power + power / 2 && power >= 4 ? power + power / 2 : 2 * power;
}

struct Step {
  double gain_per_sample = 0;
  std::size_t tile = 0;
  bool operator<(const Step& other) const {
    return gain_per_sample != other.gain_per_sample ? gain_per_sample < other.gain_per_sample
                                                    : tile > other.tile;
  }
};

class RoundPlanner {
 public:
  RoundPlanner(const std::vector<TileState>& tiles, double image_square, const ErrorTarget& target)
      : tiles_(tiles),
        target_square_(target.rmse * target.rmse),
        square_(target.rmse * target.rmse - rounding_square),
        expected_(image_square) {
    for (const TileState& tile : tiles) {
      wanted_.push_back(tile.spp);
      had_ += tile.spp;
    }
  }

  std::vector<int> plan() {
    for (std::size_t i = 0; i < tiles_.size(); ++i)
      while (noise(i) + tiles_[i].rest + rounding_square > 9 * target_square_ && can_grow(i)) grow(i);
    std::priority_queue<Step> steps;
    for (std::size_t i = 0; i < tiles_.size(); ++i) push(i, steps);
    const bool not_yet = expected_ > square_;
    while (!steps.empty() && (expected_ > square_ || (not_yet && added_ < had_ / 16))) {
      const std::size_t i = steps.top().tile;
      steps.pop();
      grow(i);
      push(i, steps);
    }
    for (std::size_t i = 0; i < tiles_.size(); ++i) wanted_[i] = std::min(wanted_[i], most_next(i));
    return wanted_;
  }

 private:
  [[nodiscard]] double noise(std::size_t i) const { return noise_with(i, wanted_[i]); }
  [[nodiscard]] double noise_with(std::size_t i, int spp) const {
    return tiles_[i].spp > 0 ? tiles_[i].noise * std::pow(static_cast<double>(tiles_[i].spp) / spp, 1.1)
                             : 0.0;
  }
  [[nodiscard]] bool can_grow(std::size_t i) const {
    return tiles_[i].noise > 0 && next_step(wanted_[i]) <= tiles_[i].most_spp;
  }
  /// Four times what a tile has: two steps of two each, and no need to round.
  [[nodiscard]] int most_next(std::size_t i) const { return 4 * tiles_[i].spp; }
  void grow(std::size_t i) {
    const int next = next_step(wanted_[i]);
    expected_ -= tiles_[i].share * (noise(i) - noise_with(i, next));
    added_ += next - wanted_[i];
    wanted_[i] = next;
  }
  void push(std::size_t i, std::priority_queue<Step>& steps) const {
    if (!can_grow(i)) return;
    const int next = next_step(wanted_[i]);
    steps.push({(noise(i) - noise_with(i, next)) / (next - wanted_[i]), i});
  }

  const std::vector<TileState>& tiles_;
  const double target_square_;
  const double square_;  ///< what noise and bias may be
  double expected_;
  std::vector<int> wanted_;
  long had_ = 0, added_ = 0;
};

}  // namespace

std::vector<int> next_samples(const std::vector<TileState>& tiles, double image_square,
                              const ErrorTarget& target) {
  return RoundPlanner(tiles, image_square, target).plan();
}

}  // namespace seamline
