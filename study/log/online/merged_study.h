#pragma once
#include <filesystem>
#include <string>

#include "study/log/log_database.h"

namespace seamline::study {

// Inside the log only.

/// Throws InputError, naming `path`, unless both logs show people the same: the same study and set, or
/// studies that differ in [observer] alone, of which only simulated people know, and stimuli whose pictures
/// are the same to the byte.
void check_same_study(SQLite::Database& into, SQLite::Database& from, const std::filesystem::path& path);

/// What the simulated people of `from` are made of where the text of the study in `into` says otherwise: the
/// lines of the study that differ, - of `into`, + of `from`. Empty: nothing differs. A log without simulated
/// people of its own takes the text of the other instead, and nothing differs any more.
[[nodiscard]] std::string other_observer(SQLite::Database& into, SQLite::Database& from);

/// Notes it with a simulated participant, as an event `observer` of each session. Who has one keeps it.
void note_observer(SQLite::Database& into, std::int64_t participant, const std::string& difference);

}  // namespace seamline::study
