#pragma once
#include <cstddef>
#include <vector>

namespace seamline::renderer {

/// What more samples did to the noise of a picture's blocks, from round to round. Noise that is not of these
/// samples does not fall with them, and asking for more of it is endless.
class SampleResponse {
 public:
  /// Of a round: samples that each block has, and squared noise beyond what is known not to be theirs. From
  /// at least four times as many samples as when it was last looked at, and no fewer than `least_spp`, the
  /// part of a block's noise that falls like samples^-1.1 is told from the part that stays.
  void learn(const std::vector<int>& spp, const std::vector<double>& noise,
             const std::vector<int>& least_spp);

  /// Of each block: squared noise that stayed; 0 where most of it fell, or nobody knows yet.
  [[nodiscard]] const std::vector<double>& stays() const { return stays_; }

  /// How light is put together has changed in a block: what was learnt of it is no longer true.
  void forget(std::size_t block);

 private:
  std::vector<int> spp_;       ///< when a block was last looked at; 0: not yet
  std::vector<double> noise_;  ///< then
  std::vector<double> stays_;
};

}  // namespace seamline::renderer
