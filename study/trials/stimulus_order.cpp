#include "study/trials/stimulus_order.h"

#include <cassert>
#include <numeric>

#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

/// Keeps the numbers of the plan apart from those of the renderer, which start from the same study seed.
constexpr std::uint64_t plan_salt = 0x706c616e;  // "plan"

}  // namespace

std::vector<int> stimulus_order(int stimulus_count, const OrderKey& key) {
  assert(stimulus_count >= 0 && key.slot >= 0);
  std::vector<int> order(static_cast<std::size_t>(stimulus_count));
  std::iota(order.begin(), order.end(), 0);
  Random random(mix_bits(key.study_seed ^ plan_salt), static_cast<std::uint64_t>(key.slot));
  shuffle(std::span<int>(order), random);
  return order;
}

}  // namespace seamline::study
