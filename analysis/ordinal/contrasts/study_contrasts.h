#pragma once
#include <array>
#include <vector>

#include "analysis/ordinal/contrasts/contrasts.h"
#include "analysis/ordinal/contrasts/study_design.h"

namespace seamline::analysis {

/// The questions that the design can answer, in link units. `participants` gives groups their degrees of
/// freedom (participants less groups), everything else has one less than the participants; infinite when
/// `robust` is false.
[[nodiscard]] std::vector<ContrastFamily> study_contrasts(const StudyDesign& design, bool robust);

/// Of those the two about conditions: levels, then slopes. Either may be without contrasts.
[[nodiscard]] std::array<ContrastFamily, 2> condition_contrasts(const StudyDesign& design, bool robust);

}  // namespace seamline::analysis
