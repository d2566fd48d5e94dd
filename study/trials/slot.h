#pragma once
#include <span>

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

}  // namespace seamline::study
