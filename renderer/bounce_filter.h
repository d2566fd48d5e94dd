#pragma once
#include <vector>

#include "renderer/layers.h"

namespace seamline {

/// Mean bounce light a sample without the object, filtered by two a-trous levels (Dammertz et al., HPG 2010) whose weights
/// fall with the difference in normal and in depth, never with colour. `sums` and `guides` are row by row.
[[nodiscard]] std::vector<Rgb> filtered_bounce(const std::vector<StimulusSums>& sums, const std::vector<Guide>& guides,
                                               int width_px, int height_px);

}  // namespace seamline
