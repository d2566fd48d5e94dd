#pragma once
#include <string>

#include "stimuli/definition/parts/task_definition.h"

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
/// artifact, so that the logs of all others are what they were. Versions 5 and 6 are 3 and 4 with the tables
/// of people who take part in a browser (`online_tables_sql`): a log becomes one when the first of them is
/// entered, and goes on being one for the window too. Versions 7 to 10 are 3 to 6 of a study that names its
/// task: a trial says which alternative is right in it. Versions 15 to 18 are 7 to 10 of a study whose scenes
/// have more than three objects; 11 to 14 are not made, because such a study names its task.
inline constexpr int newest_log_schema_version = 18;
inline constexpr int oldest_log_schema_version = 2;

/// Whether a version since `log_schema_version` has tables of people in browsers, knows the artifact
/// `reflection`, and says of each trial what is right; the version that has them as asked.
[[nodiscard]] constexpr bool has_online_tables(int version) {
  return version >= log_schema_version && ((version - log_schema_version) & 2) != 0;
}
[[nodiscard]] constexpr bool knows_reflection(int version) {
  return version >= log_schema_version && ((version - log_schema_version) & 1) != 0;
}
[[nodiscard]] constexpr bool knows_tasks(int version) {
  return version >= log_schema_version && ((version - log_schema_version) & 4) != 0;
}
[[nodiscard]] constexpr bool knows_many_objects(int version) {
  return version >= log_schema_version && ((version - log_schema_version) & 8) != 0;
}
[[nodiscard]] constexpr int log_schema_version_with(bool online, bool reflection, bool task = false,
                                                    bool many_objects = false) {
  return log_schema_version + (many_objects ? 8 : 0) + (task ? 4 : 0) + (online ? 2 : 0) +
         (reflection ? 1 : 0);
}
/// Objects, and alternatives, that a version has room for.
[[nodiscard]] constexpr int most_choices(int version) {
  return knows_many_objects(version) ? most_objects_of_scene : usual_objects;
}

/// The tables that version 5 adds to those of version 3, and 6 to those of version 4, as SQL.
[[nodiscard]] std::string online_tables_sql();

/// The tables of a schema version since `oldest_log_schema_version`, as SQL: word for word what logs of that
/// version were made with.
[[nodiscard]] std::string log_schema_sql(int version = log_schema_version);

}  // namespace seamline::study
