#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace seamline::study {

/// A slot that a participant of the same kind (person, pilot, simulated) holds who is not excluded. A slot
/// decides the order of trials (`OrderKey`).
struct HeldSlot {
  int slot = 0;  ///< 0-based
  bool completed = false;
};

/// The slot of the next participant. Where everybody has an order of their own (`orders` is 0), the lowest
/// that nobody holds; where people share `orders` orders, the one with the fewest completed participants,
/// then the fewest unfinished ones, then the lowest.
[[nodiscard]] int newcomer_slot(int orders, std::span<const HeldSlot> held);

/// The slot of participant `number` (0-based) where numbers are handed out in turn, as to simulated people.
[[nodiscard]] int slot_in_turn(int orders, int number);

/// What decides a participant's order. Two participants in the same slot see the same order, so a slot that
/// an excluded participant frees can be given to another one, and orders stay balanced.
struct OrderKey {
  std::uint64_t study_seed = 1;  ///< `seed` of the study file
  int slot = 0;                  ///< 0-based
};

/// The order in which a participant sees a set: every index 0..stimulus_count-1 once, every order equally
/// likely, and the same for the same key on every machine. The log keeps the order, so a resumed
/// session never draws again.
[[nodiscard]] std::vector<int> stimulus_order(int stimulus_count, const OrderKey& key);

}  // namespace seamline::study
