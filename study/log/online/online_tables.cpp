#include "study/log/online/online_tables.h"

#include <string>

#include "study/log/log_schema.h"

namespace seamline::study {

void add_online_tables(SQLite::Database& database) {
  const int version = schema_version_of(database);
  if (has_online_tables(version)) return;
  database.exec(online_tables_sql());
  database.exec("PRAGMA user_version = " +
                std::to_string(log_schema_version_with(true, knows_reflection(version), knows_tasks(version),
                                                       knows_many_objects(version))));
}

}  // namespace seamline::study
