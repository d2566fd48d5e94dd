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
/// Version 4 is version 3 with the artifact `reflection`; a log is made of it when its study has that
/// artifact, so that the logs of all others are what they were.
inline constexpr int newest_log_schema_version = 4;
inline constexpr int oldest_log_schema_version = 2;

/// The tables of a schema version since `oldest_log_schema_version`, as SQL: word for word what logs of that
/// version were made with.
[[nodiscard]] std::string log_schema_sql(int version = log_schema_version);

}  // namespace seamline::study
