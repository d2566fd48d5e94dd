#pragma once
#include "laboratory/evidence/evidence_page.h"

namespace seamline::laboratory {

// Pages on what is computed from answers: thresholds, intervals, fits.

[[nodiscard]] EvidencePage coverage_page();
[[nodiscard]] EvidencePage replication_page();
[[nodiscard]] EvidencePage joint_model_page();
[[nodiscard]] EvidencePage statistics_page();

}  // namespace seamline::laboratory
