#pragma once
#include "laboratory/evidence/evidence_page.h"

namespace seamline::laboratory {

// Pages on pictures: their errors, told and true, and what is predicted from them.

[[nodiscard]] EvidencePage convergence_page();
[[nodiscard]] EvidencePage predictions_page();
[[nodiscard]] EvidencePage real_time_page();
[[nodiscard]] EvidencePage true_errors_page();

}  // namespace seamline::laboratory
