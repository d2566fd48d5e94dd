#pragma once
#include <span>
#include <vector>

#include "stimuli/definition/instructions_definition.h"
#include "stimuli/definition/stimulus.h"
#include "study/trials/stimulus_order.h"
#include "study/trials/trial_sequence.h"

namespace seamline::study {

/// The catch trials of a participant among `stimulus_trials` others: one in each of as many equal stretches
/// of the session as there are catch trials, at a place drawn from the stretch. None is the first trial or
/// the last, and two never stand next to each other, unless there are too few other trials to keep them
/// apart. The kinds are mixed at random; attention trials go through truths (a scene in one light) and
/// objects, reference trials through truths, in a random order, each as often as the others. The same for the
/// same key on every machine.
[[nodiscard]] std::vector<CatchTrial> draw_catch_trials(const CatchDefinition& definition,
                                                        std::span<const Stimulus> set, int stimulus_trials,
                                                        const OrderKey& key);

/// A fixed order of stimuli with catch trials in their places.
[[nodiscard]] std::vector<Trial> interleave(std::span<const int> order, std::span<const CatchTrial> catches);

/// The catch trials among others, in their places: the inverse of `interleave`.
[[nodiscard]] std::vector<CatchTrial> catch_trials_of(std::span<const Trial> trials);

}  // namespace seamline::study
