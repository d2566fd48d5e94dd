#include "study/trials/slot.h"

#include <algorithm>
#include <cassert>
#include <set>
#include <utility>
#include <vector>

namespace seamline::study {
namespace {

int lowest_free(std::span<const HeldSlot> held) {
  std::set<int> taken;
  for (const HeldSlot& one : held) taken.insert(one.slot);
  int slot = 0;
  while (taken.contains(slot)) ++slot;
  return slot;
}

int least_shared(int orders, std::span<const HeldSlot> held) {
  std::vector<std::pair<int, int>> participants(static_cast<std::size_t>(orders));  // completed, unfinished
  for (const HeldSlot& one : held) {
    if (one.slot >= orders) continue;
    auto& [completed, unfinished] = participants[static_cast<std::size_t>(one.slot)];
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

}  // namespace seamline::study
