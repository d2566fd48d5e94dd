#pragma once
#include <filesystem>

// Inside the log only: a log that is made in a temporary folder, and then is there, whole.
namespace seamline::study {

/// Throws InputError unless a new log can have this name. Nor may a write-ahead log or journal lie there:
/// SQLite would take it for the new log's.
void check_is_free(const std::filesystem::path& out);

/// Gives a closed log without write-ahead log its name, on the same file system; after a power cut too it is
/// there whole or not at all. Throws InputError when another file has the name by now, and takes nothing from
/// it.
void take_name(const std::filesystem::path& made, const std::filesystem::path& out);

}  // namespace seamline::study
