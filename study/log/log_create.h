#pragma once
#include <filesystem>
#include <functional>

#include "study/log/log_database.h"

#include "study/log/log_schema.h"

namespace seamline::study {

// Inside the log only.

/// Opens a log in which sessions go on (`log_schema_version` or later), made durable; where there is no file,
/// or an empty one, a log is made: its tables and what `fill` enters are one transaction, so no other program
/// ever sees a log that belongs to no set. When that fails no file is left. Complaints say `called`, where a
/// log is made under a name of our own. `version`: what a new log is made of.
[[nodiscard]] SQLite::Database open_or_create_log_database(const std::filesystem::path& path,
                                                           const std::function<void(SQLite::Database&)>& fill,
                                                           const std::filesystem::path& called = {},
                                                           int version = log_schema_version);

/// Removes a log that holds nothing but its study and its stimuli, and the files beside it. Returns false,
/// and leaves everything, where it holds more, another program has it open, or it is no sound log.
[[nodiscard]] bool remove_log_of_nobody(const std::filesystem::path& path);

}  // namespace seamline::study
