#pragma once
#include "study/log/log_database.h"

namespace seamline::study {

// Inside the log only.

/// A log of the window becomes one of browsers too: tables are added, and nothing that is there is touched. A
/// log that has them stays as it is.
void add_online_tables(SQLite::Database& database);

}  // namespace seamline::study
