#pragma once
#include <cstdint>
#include <vector>

namespace seamline::study {

/// What decides a participant's order. Two participants in the same slot see the same order, so a slot that
/// an excluded participant frees can be given to another one, and orders stay balanced.
struct OrderKey {
  std::uint64_t study_seed = 1;  ///< `seed` of the study file
  int slot = 0;                  ///< 0-based
};

/// The order in which a participant sees a set: every index 0..stimulus_count-1 once, every order equally
/// likely, and the same for the same key on every machine. The log keeps the planned order, so a resumed
/// session never plans again.
[[nodiscard]] std::vector<int> stimulus_order(int stimulus_count, const OrderKey& key);

}  // namespace seamline::study
