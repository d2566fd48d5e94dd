#include "study/trials/stimulus_order.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <set>
#include <utility>

#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

/// Keeps the numbers of the order apart from those of the renderer, which start from the same study seed.
constexpr std::uint64_t order_salt = 0x706c616e;  // "plan", which it was called when studies first ran

int lowest_free(std::span<const HeldSlot> held) {
  std::set<int> taken;
  for (const HeldSlot& one : held) taken.insert(one.slot);
  int slot = 0;
  while (taken.contains(slot)) ++slot;
  return slot;
}

int least_shared(int orders, std::span<const HeldSlot> held) {
  std::vector<std::pair<int, int>> participants(orders);  // completed, unfinished
  for (const HeldSlot& one : held) {
    if (one.slot >= orders) continue;
    auto& [completed, unfinished] = participants[one.slot];
    ++(one.completed ? completed : unfinished);
  }
  return static_cast<int>(std::min_element(participants.begin(), participants.end()) - participants.begin());
}

}  // namespace

int newcomer_slot(int orders, std::span<const HeldSlot> held) {
  assert(orders >= 0 && std::ranges::all_of(held, [](const HeldSlot& one) { return one.slot >= 0; }));
  return orders > 0 ? least_shared(orders, held) : lowest_free(held);
}

int slot_in_turn(int orders, int number) {
  assert(orders >= 0 && number >= 0);
  return orders > 0 ? number % orders : number;
}

std::vector<int> stimulus_order(int stimulus_count, const OrderKey& key) {
  assert(stimulus_count >= 0 && key.slot >= 0);
  std::vector<int> order(stimulus_count);
  std::iota(order.begin(), order.end(), 0);
  Random random(mix_bits(key.study_seed ^ order_salt), key.slot);
  shuffle(std::span<int>(order), random);
  return order;
}

}  // namespace seamline::study
