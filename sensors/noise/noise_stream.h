#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>

#include "support/arithmetic/random.h"

namespace seamline::sensors {

/// Which noise: another seed is another sensor or another study, another frame the next moment of the same.
struct NoiseKey {
  std::uint64_t seed = 0;
  std::uint64_t frame = 0;
};

/// The random numbers of one pixel of one frame, by number and without state: `uniform(k)` is always the same
/// for the same (seed, frame, pixel, k). So pixels can be computed in any order and on any threads, and one
/// effect that is switched off leaves the numbers of the others as they are. The k-th number is that of
/// splitmix64 begun at a place which seed, frame and pixel choose one to one.
class NoiseStream {
 public:
  NoiseStream(const NoiseKey& key, std::uint64_t pixel)
      : start_(mix_bits(mix_bits(mix_bits(key.seed) ^ key.frame) ^ pixel)) {}

  [[nodiscard]] std::uint64_t bits(std::uint64_t number) const {
    return mix_bits(start_ + number * 0x9e3779b97f4a7c15ULL);
  }
  /// Uniform in [0, 1), 53 bits.
  [[nodiscard]] double uniform(std::uint64_t number) const {
    return static_cast<double>(bits(number) >> 11) * 0x1.0p-53;
  }

  struct Pair {
    double first = 0, second = 0;
  };
  /// Two independent standard normals, from the numbers `number` and `number + 1` (Box and Muller 1958).
  [[nodiscard]] Pair normals(std::uint64_t number) const {
    const double radius = std::sqrt(-2 * std::log(1 - uniform(number)));
    const double angle = 2 * std::numbers::pi * uniform(number + 1);
    return {radius * std::cos(angle), radius * std::sin(angle)};
  }

 private:
  std::uint64_t start_;
};

/// Which number serves what, the same in every model.
namespace noise_number {
inline constexpr std::uint64_t normals = 0;  ///< and 1
inline constexpr std::uint64_t dropout = 2;
inline constexpr std::uint64_t outlier = 3;
inline constexpr std::uint64_t outlier_value = 4;
}  // namespace noise_number

}  // namespace seamline::sensors
