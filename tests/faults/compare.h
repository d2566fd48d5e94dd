#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace seamline::faults {

/// Of SQLite's files and of small disks.
inline constexpr std::uint64_t page_bytes = 4096;

[[nodiscard]] std::string bytes_of(const std::filesystem::path& file);

/// The files of a set or report under their final names, with their bytes; without those that tell how long a
/// run took (timings, errors page) and without temporary ones.
using Files = std::map<std::string, std::string>;
[[nodiscard]] Files files_of(const std::filesystem::path& folder);

/// Temporary files that were left behind.
[[nodiscard]] int leftovers(const std::filesystem::path& folder);

/// How many of `files` are in `whole` with other bytes, or not at all.
[[nodiscard]] int files_not_in(const Files& files, const Files& whole);

/// Every row of every table of a log as text, without times; table by table in the order of their keys.
[[nodiscard]] std::vector<std::string> rows_of(const std::filesystem::path& log);

/// The answers alone, as participant code, trial, stimulus, choice and rating; none when there is no log yet.
[[nodiscard]] std::vector<std::string> answers_of(const std::filesystem::path& log);

/// How many of `some` are not in `all`; both in any order.
[[nodiscard]] std::int64_t missing(std::vector<std::string> some, std::vector<std::string> all);

/// SQLite finds nothing wrong with the file, and no row refers to one that is not there.
[[nodiscard]] bool is_sound(const std::filesystem::path& log);

/// A log with what stands beside it.
void remove_log(const std::filesystem::path& log);
void copy_log(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace seamline::faults
