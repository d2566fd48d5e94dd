#pragma once
#include <filesystem>

namespace seamline::faults {

/// Prints how time and memory grow: analyses of 12,500 to 100,000 answers in one log, and sets of 84 and
/// 5,000 stimuli (rendered in three shards) rendered, verified and opened. 0 when every command ended well
/// and none took more than 1 GB.
int measure_load(const std::filesystem::path& program, const std::filesystem::path& folder);

}  // namespace seamline::faults
