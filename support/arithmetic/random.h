#pragma once
#include <cstdint>
#include <span>
#include <utility>

namespace seamline {

/// Mixes 64 bits so that every input bit changes every output bit (splitmix64 finaliser).
[[nodiscard]] constexpr std::uint64_t mix_bits(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15ULL;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9ULL;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebULL;
  return bits ^ (bits >> 31);
}

/// Seamline's own generator (xoshiro256**, seeded by splitmix64): the same numbers on every platform and
/// library. `std::*_distribution` and `std::shuffle` are not used anywhere, because they differ between
/// libraries.
class Random {
 public:
  /// Streams of the same seed are independent of each other.
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0);

  std::uint64_t bits();  ///< 64 uniform bits
  double uniform();      ///< uniform in [0, 1), 53 bits
  std::uint64_t below(
      std::uint64_t bound);  ///< uniform integer in [0, bound), without modulo bias; bound > 0
  double normal();           ///< standard normal (polar method)
  int binomial(int trials, double probability);  ///< number of successes, by counting; trials >= 0

 private:
  std::uint64_t state_[4];
  double spare_normal_ = 0.0;
  bool has_spare_ = false;
};

/// Fisher-Yates with our own generator: every order equally likely, the same for the same seed everywhere.
template <class T>
void shuffle(std::span<T> items, Random& random) {
  for (std::size_t i = items.size(); i > 1; --i) {
    const std::size_t j = static_cast<std::size_t>(random.below(i));
    std::swap(items[i - 1], items[j]);
  }
}

}  // namespace seamline
