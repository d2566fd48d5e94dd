#pragma once
#include "laboratory/evidence/evidence_page.h"

namespace seamline::laboratory {

// Pages on what surrounds the pictures: plans of studies, depth cameras and things that rest, contact sheets.

[[nodiscard]] EvidencePage planning_page();
[[nodiscard]] EvidencePage depth_cameras_page();
[[nodiscard]] EvidencePage pictures_page();

}  // namespace seamline::laboratory
