#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/preregistration/archive.h"

namespace seamline::analysis {

/// The content of an archive, but for how many participants and why: the study file and its sets, read and
/// compared, and the analysis with the program's rules. Throws InputError when the study or a set cannot be
/// read, a set is of another study or stands twice, or a threshold is none of PT, SN and IP.
[[nodiscard]] Preregistration freeze_study(const std::filesystem::path& study_file,
                                           const std::vector<std::filesystem::path>& sets,
                                           FrozenAnalysis analysis);

}  // namespace seamline::analysis
