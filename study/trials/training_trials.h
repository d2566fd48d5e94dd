#pragma once
#include <vector>

#include "study/placement/trial.h"
#include "study/trials/rendered_set.h"

namespace seamline::study {

/// The practice of every visit: the stimuli that the study names, or the coarsest ones, one artifact after
/// the other. Throws InputError when a stimulus that the study names is not in the set.
[[nodiscard]] std::vector<Trial> training_trials(const RenderedSet& set);

}  // namespace seamline::study
