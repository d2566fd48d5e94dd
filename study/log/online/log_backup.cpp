#include "study/log/online/log_backup.h"

#include "study/log/log_database.h"
#include "study/log/online/recruits.h"
#include "study/log/recovery/new_log.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

void copy_database(SQLite::Database& database, const fs::path& copy) {
  const TemporaryFolder scratch(copy);
  const fs::path made = scratch / "copy.sqlite";
  write_file_atomically(made, "", Readers::owner);  // SQLite would make it for everybody
  SQLite::Statement into(database, "VACUUM INTO ?");
  SQLite::bind(into, made.string());
  while (into.executeStep()) {
  }
  take_name(made, copy);
}

}  // namespace

void back_up_log(const fs::path& log, const fs::path& copy) {
  check_is_free(copy);
  check_is_free(recruits_file(copy));
  SQLite::Database database = open_log_database(log, LogAccess::write);
  const fs::path recruits = recruits_file(log);
  if (std::error_code error; fs::exists(recruits, error))
    with_log_errors(recruits, [&] {
      SQLite::Database people = open_warily(recruits, SQLite::OPEN_READWRITE);
      copy_database(people, recruits_file(copy));
    });
  with_log_errors(log, [&] { copy_database(database, copy); });
}

}  // namespace seamline::study
