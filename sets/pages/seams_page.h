#pragma once
#include <filesystem>
#include <vector>

#include "sets/set_seams.h"
#include "stimuli/pictures/clip_seam.h"

namespace seamline::renderer {

/// Writes `seams.csv`, a row a stimulus, and `seams.html`, one file that opens offline, without scripts, into
/// a folder, and of a set of clips `clip_seams.csv`. Without gnuplot the page says that there is no figure.
void write_seams_page(const std::filesystem::path& folder, const SetSeams& seams,
                      const std::vector<ClipSeam>& clips = {});

}  // namespace seamline::renderer
