#pragma once
#include <optional>
#include <vector>

#include "stimuli/definition/stimulus.h"
#include "study/placement/trial.h"
#include "study/trials/stimulus_order.h"

namespace seamline::study {

/// The pictures among which a participant moves in a match: those that differ in nothing but the level, from
/// where most is seen to where least is.
struct LevelLadders {
  struct Place {
    int ladder = -1;  ///< -1: the level stands apart ("none"), on no ladder
    int rung = 0;
  };
  std::vector<std::vector<int>> ladders;  ///< stimuli, indices into the set
  std::vector<int> curves;  ///< of each ladder: ladders of one artifact and condition have one number, from 0
  std::vector<Place> places;  ///< of each stimulus
};

/// `noticeability`: as the level grows.
[[nodiscard]] LevelLadders make_level_ladders(const std::vector<Stimulus>& stimuli, Direction noticeability);

/// The stimulus so many rungs on (negative: to where more is seen); none beyond the ends.
[[nodiscard]] std::optional<int> next_rung(const LevelLadders& ladders, int stimulus, int rungs);

/// The pictures of a trial's ladder, in its order.
[[nodiscard]] std::vector<Trial> pictures_of_ladder(const LevelLadders& ladders, const Trial& trial);

/// The stimuli with which a participant's matches begin: each ladder `repetitions` times, once in every
/// repetition, in a random order. A start lies in the half of the ladder where more is seen or in that where
/// less is (an odd ladder's middle is in neither), at a random rung of it. Of repetition r of ladder number l
/// of a curve, the half is that of (r + l + slot) mod 2: so the halves are balanced over the repetitions of
/// an object, over the objects of a curve, and over participants.
[[nodiscard]] std::vector<int> match_starts(const LevelLadders& ladders, int repetitions,
                                            const OrderKey& key);

/// Whether a start lies in the half of its ladder where more is seen.
[[nodiscard]] bool begins_clear(const LevelLadders& ladders, int stimulus);

}  // namespace seamline::study
