#pragma once
#include <string>

namespace seamline::study {

// Inside the log only.

/// The log's format: a SQLite database with this application_id and, in user_version, this schema version.
/// Raise the version with every change of the tables in log_schema.cpp. Version 2 has kinds of trials,
/// consents, forms, displays and training; version 3 the quantity of the study and the conditions and levels
/// of its stimuli. A log of version 2 is of depth widths alone: it is read, and participants are excluded and
/// forgotten in it, but sessions go on in a log of today's version only (`upgrade_log`).
inline constexpr int log_application_id = 0x5345414d;  // "SEAM"
inline constexpr int log_schema_version = 3;
inline constexpr int oldest_log_schema_version = 2;

/// The tables of a schema version since `oldest_log_schema_version`, as SQL: word for word what logs of that
/// version were made with.
[[nodiscard]] std::string log_schema_sql(int version = log_schema_version);

}  // namespace seamline::study
