#pragma once
#include <filesystem>

#include "sets/set_seams.h"

namespace seamline::renderer {

/// Writes `seams.csv`, a row a stimulus, and `seams.html`, one file that opens offline, without scripts, into
/// a folder. Without gnuplot the page says that there is no figure.
void write_seams_page(const std::filesystem::path& folder, const SetSeams& seams);

}  // namespace seamline::renderer
