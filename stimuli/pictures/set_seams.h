#pragma once
#include <filesystem>
#include <functional>
#include <vector>

#include "stimuli/pictures/seam_measure.h"
#include "stimuli/set/manifest.h"

namespace seamline::inline stimuli {

/// The seams of all stimuli of a set, in the manifest's order: each stimulus against its own reference, the
/// same scene in the light of its condition. Only pictures that are what the manifest says are looked at:
/// throws InputError naming the first that is missing, unreadable, of another size or of other bytes. The
/// same for any number of threads (0: as many as the machine has). `tick` is told now and then how many are
/// finished; it may be empty.
[[nodiscard]] std::vector<SeamMeasure> measure_seams(const std::filesystem::path& set_folder,
                                                     const Manifest& manifest, int threads = 0,
                                                     const std::function<void(int finished)>& tick = {});

}  // namespace seamline::inline stimuli
