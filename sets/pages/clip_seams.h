#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "sets/set_seams.h"
#include "stimuli/pictures/clip_seam.h"
#include "support/text/csv.h"

namespace seamline::renderer {

/// The seam of each clip of `seams.rows`, in their order, with progress on standard error; empty of a set of
/// stills. Throws InputError when a clip is missing or has other bytes than the set was rendered with.
[[nodiscard]] std::vector<ClipSeam> read_clip_seams(const std::filesystem::path& set_folder,
                                                    const SetSeams& seams);

/// `clip_seams`, a row a clip.
[[nodiscard]] CsvTable clip_seams_table(const SetSeams& seams, const std::vector<ClipSeam>& clips);

/// Means over the scenes and objects of one artifact at one level, for people.
[[nodiscard]] CsvTable clip_cells_table(const SetSeams& seams, const std::vector<ClipSeam>& clips);

/// What the numbers are, in two sentences.
[[nodiscard]] std::string clip_seams_meaning();

}  // namespace seamline::renderer
