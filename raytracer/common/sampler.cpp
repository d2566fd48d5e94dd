#include "raytracer/common/sampler.h"

#include "support/arithmetic/random.h"

namespace seamline::renderer {
namespace {

std::uint32_t reverse_bits(std::uint32_t x) {
  x = __builtin_bswap32(x);
  x = ((x & 0x0f0f0f0fU) << 4) | ((x >> 4) & 0x0f0f0f0fU);
  x = ((x & 0x33333333U) << 2) | ((x >> 2) & 0x33333333U);
  return ((x & 0x55555555U) << 1) | ((x >> 1) & 0x55555555U);
}

/// Laine-Karras permutation with Burley's improved constants: each bit is flipped depending on lower bits
/// only.
std::uint32_t permute(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeaU;
  x += seed;
  x *= (seed >> 16) | 1U;
  x ^= x * 0x05526c56U;
  x ^= x * 0x53a22864U;
  return x;
}

std::uint32_t owen_scramble_reversed(std::uint32_t reversed, std::uint32_t seed) {
  return reverse_bits(permute(reversed, seed));
}

std::uint32_t hash(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint32_t>(mix_bits((std::uint64_t{a} << 32) | b) >> 32);
}

float unit_float(std::uint32_t bits) {
  return static_cast<float>(bits >> 8) * 0x1.0p-24F;
}

/// Sobol' dimension 2, bits reversed: the Pascal triangle modulo 2 as a superset sum over bit positions.
std::uint32_t second_dimension_reversed(std::uint32_t x) {
  x ^= (x >> 1) & 0x55555555U;
  x ^= (x >> 2) & 0x33333333U;
  x ^= (x >> 4) & 0x0f0f0f0fU;
  x ^= (x >> 8) & 0x00ff00ffU;
  return x ^ ((x >> 16) & 0x0000ffffU);
}

}  // namespace

std::uint32_t sobol_second_dimension(std::uint32_t index) {
  return reverse_bits(second_dimension_reversed(index));
}

Sampler::Sampler(std::uint64_t seed, int x, int y, int sample) {
  const std::uint64_t place = (static_cast<std::uint64_t>(y) << 32) | static_cast<std::uint32_t>(x);
  const std::uint64_t half = static_cast<std::uint64_t>(sample & 1) << 31;
  pixel_hash_ = static_cast<std::uint32_t>(mix_bits(mix_bits(seed) ^ place ^ half) >> 32);
  sample_ = static_cast<std::uint32_t>(sample) >> 1;
}

Eigen::Array2f Sampler::point(int dimension) const {
  const std::uint32_t base = hash(pixel_hash_, static_cast<std::uint32_t>(dimension));
  const std::uint32_t index = owen_scramble_reversed(reverse_bits(sample_), base);
  // Dimension 1 is the index with its bits reversed, so scrambling it starts from the index itself.
  return {unit_float(owen_scramble_reversed(index, base * 0x9e3779b1U + 1U)),
          unit_float(owen_scramble_reversed(second_dimension_reversed(index), base * 0x85ebca6bU + 2U))};
}

}  // namespace seamline::renderer
