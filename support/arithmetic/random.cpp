#include "support/arithmetic/random.h"

#include <bit>
#include <cmath>

namespace seamline {

Random::Random(std::uint64_t seed, std::uint64_t stream) {
  std::uint64_t word = mix_bits(seed) ^ mix_bits(~stream);
  for (std::uint64_t& part : state_) part = word = mix_bits(word);
}

std::uint64_t Random::bits() {
  const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
  const std::uint64_t shifted = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double Random::uniform() {
  return static_cast<double>(bits() >> 11) * 0x1.0p-53;
}

std::uint64_t Random::below(std::uint64_t bound) {
  const std::uint64_t rejected_below =
      (0 - bound) % bound;  // 2^64 mod bound values would be over-represented
  for (;;)
    if (const std::uint64_t word = bits(); word >= rejected_below) return word % bound;
}

double Random::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_normal_;
  }
  double x = 0, y = 0, square = 0;
  do {
    x = 2 * uniform() - 1;
    y = 2 * uniform() - 1;
    square = x * x + y * y;
  } while (square >= 1 || square == 0);
  const double scale = std::sqrt(-2 * std::log(square) / square);
  spare_normal_ = y * scale;
  has_spare_ = true;
  return x * scale;
}

int Random::binomial(int trials, double probability) {
  int successes = 0;
  for (int trial = 0; trial < trials; ++trial) successes += uniform() < probability ? 1 : 0;
  return successes;
}

}  // namespace seamline
