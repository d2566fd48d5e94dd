#pragma once
#include <cstdint>

namespace seamline {

inline constexpr int objects_per_stimulus = 3;
inline constexpr int highest_rating = 4;

/// What a participant did in one trial: chose one of the three objects, then rated how noticeable the
/// insertion was.
struct TrialAnswer {
  int trial_index = 0;         ///< 0-based place in the participant's order
  int chosen_index = 0;        ///< 1 left, 2 middle, 3 right
  int rating = 0;              ///< 1 slightly .. 4 extremely noticeable
  std::int64_t choice_ns = 0;  ///< from the image's onset to the choice that counted
  std::int64_t rating_ns = 0;  ///< from the image's onset to the rating; at least choice_ns
  bool operator==(const TrialAnswer&) const = default;
};

}  // namespace seamline
