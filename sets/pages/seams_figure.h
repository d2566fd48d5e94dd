#pragma once
#include <string>

#include "sets/set_seams.h"

namespace seamline::renderer {

/// Area (a row of panels) and widest band (a second row) against the level, a panel an artifact, a line for
/// each of `seam_steps`; two rows a condition; as SVG text to put into a page. Axes are alike along a row.
/// Throws InputError when there is no gnuplot.
[[nodiscard]] std::string seams_figure(const SetSeams& seams);

}  // namespace seamline::renderer
