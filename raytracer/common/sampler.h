#pragma once
#include <Eigen/Core>
#include <cstdint>

namespace seamline::renderer {

/// Points of one sample of one pixel: Owen-scrambled Sobol' (the first two dimensions, padded: every use of a
/// `dimension` is its own scrambled and shuffled set), decorrelated between pixels by hashing. Even and odd
/// samples are two sets that know nothing of each other, so that half their difference estimates the noise of
/// their mean. The same
/// pixel, sample, dimension and seed always give the same point, which is how background, reference and
/// composite share their sample points. Construction: Burley, "Practical Hash-based Owen Scrambling", JCGT
/// 9(4), 2020.
class Sampler {
 public:
  Sampler(std::uint64_t seed, int x, int y, int sample);

  /// A point in [0, 1)^2.
  [[nodiscard]] Eigen::Array2f point(int dimension) const;

  /// 0 to `of` - 1: the samples of a pixel's half take turns, and which of them begins differs from pixel to
  /// pixel and half to half. Where only those whose turn is 0 do something, as many times as the others leave
  /// it out, nothing is biased by how few samples there are.
  [[nodiscard]] int turn(int of) const {
    return static_cast<int>((sample_ + (pixel_hash_ >> 8)) % static_cast<std::uint32_t>(of));
  }

 private:
  std::uint32_t pixel_hash_;
  std::uint32_t sample_;
};

/// From the seed of a picture to that of its reference, which shares no sample with it.
inline constexpr std::uint64_t reference_seed_offset = 1000;

/// One sample of one pixel.
struct SampleId {
  int x = 0, y = 0;
  int number = 0;
};

/// Which dimension serves what, so that paths that share a vertex share its numbers.
namespace dimension {
inline constexpr int pixel = 0;
[[nodiscard]] inline constexpr int direction(int vertex) {
  return 1 + 2 * vertex;
}
[[nodiscard]] inline constexpr int sun(int vertex) {
  return 2 + 2 * vertex;
}
// A path has at most 1025 surfaces.
[[nodiscard]] inline constexpr int lamp(int vertex) {
  return 4096 + 4 * vertex;
}
[[nodiscard]] inline constexpr int emission_choice(int vertex) {
  return 4097 + 4 * vertex;
}
[[nodiscard]] inline constexpr int emission(int vertex) {
  return 4098 + 4 * vertex;
}
[[nodiscard]] inline constexpr int environment(int vertex) {
  return 4099 + 4 * vertex;
}
}  // namespace dimension

/// The second dimension of the Sobol' sequence before scrambling (the first is the reversed index); for
/// tests.
[[nodiscard]] std::uint32_t sobol_second_dimension(std::uint32_t index);

}  // namespace seamline::renderer
