#pragma once
#include <filesystem>

#include "laboratory/evidence/evidence_page.h"

namespace seamline::laboratory {

/// Draws the figure of a table in `folder` beside it, as .svg and the .gnuplot script that makes it. Rows
/// without a number are left out. Throws InputError where the table has not the columns, or there is no
/// gnuplot.
void draw_evidence(const std::filesystem::path& folder, const EvidenceFigure& figure);

}  // namespace seamline::laboratory
