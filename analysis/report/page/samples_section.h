#pragma once
#include <string>

#include "analysis/report/figures/stimulus_samples.h"

namespace seamline::analysis {

/// Sample stimuli as pictures inside the page, or the sentence that says why there are none.
[[nodiscard]] std::string samples_html(const StimulusSamples& samples, const LevelAxis& axis = {});

}  // namespace seamline::analysis
