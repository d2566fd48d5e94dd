#pragma once
#include "analysis/ordinal/likelihood/ordinal_fit.h"

namespace seamline::analysis {

/// Maximum likelihood with a random intercept a participant (R: ordinal::clmm). Throws InputError as
/// check_ordinal_data, and when `data.participant` is empty or `request.nodes` is out of range.
[[nodiscard]] OrdinalFit fit_cumulative_link_mixed(const OrdinalData& data, const OrdinalRequest& request);

}  // namespace seamline::analysis
