#pragma once
#include <filesystem>

namespace seamline::study {

/// Copies a log as it is at one moment, also while a server or sessions write to it, to `copy`, for its owner
/// alone; with it the file of recruits, if there is one (first, so that it lacks nobody of the log's but who
/// came meanwhile). Throws InputError, and leaves no copy, when there is something of that name or it cannot
/// be written.
void back_up_log(const std::filesystem::path& log, const std::filesystem::path& copy);

}  // namespace seamline::study
