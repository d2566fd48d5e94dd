#include "study/log/online/online_tables.h"

#include "study/log/log_schema.h"

namespace seamline::study {

void add_online_tables(SQLite::Database& database) {
  const int version = schema_version_of(database);
  if (has_online_tables(version)) return;
  database.exec(online_tables_sql());
  const int grown = log_schema_version_with(true, knows_reflection(version));
  database.exec(grown == newest_log_schema_version ? "PRAGMA user_version = 6" : "PRAGMA user_version = 5");
}

}  // namespace seamline::study
