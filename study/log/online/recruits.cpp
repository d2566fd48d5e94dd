#include "study/log/online/recruits.h"

#include <set>
#include <utility>

#include "study/log/log_database.h"
#include "study/log/log_place.h"
#include "support/files/atomic_file.h"
#include "support/text/csv.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

constexpr int recruits_application_id = 0x5345414e;  // "SEAN"
constexpr int recruits_schema_version = 1;

constexpr const char* recruits_schema = R"sql(
CREATE TABLE recruits (
  code            TEXT PRIMARY KEY CHECK (length(code) > 0),
  person          TEXT UNIQUE CHECK (length(person) > 0),   -- NULL: came without, or forgotten
  outcome         TEXT CHECK (length(outcome) > 0),         -- NULL: not at the end
  completion_code TEXT NOT NULL DEFAULT ''
) STRICT, WITHOUT ROWID;
CREATE TABLE identifiers (
  code            TEXT NOT NULL REFERENCES recruits ON DELETE CASCADE,
  name            TEXT NOT NULL CHECK (length(name) > 0),
  value           TEXT NOT NULL,
  PRIMARY KEY (code, name)
) STRICT, WITHOUT ROWID;
)sql";

InputError not_recruits(const fs::path& file, const std::string& found) {
  return input_error({.file = file.string(), .wanted = "the file of recruits beside a log", .found = found});
}

SQLite::Database open_recruits(const fs::path& file) {
  if (std::error_code error; !fs::exists(file, error))
    write_file_atomically(file, "", Readers::owner);  // SQLite would make it for everybody
  SQLite::Database database = open_warily(file, SQLite::OPEN_READWRITE);
  make_durable(database);
  if (is_blank(database)) {
    SQLite::Transaction making(database, SQLite::TransactionBehavior::IMMEDIATE);
    database.exec(recruits_schema);
    database.exec("PRAGMA application_id = " + std::to_string(recruits_application_id));
    database.exec("PRAGMA user_version = " + std::to_string(recruits_schema_version));
    making.commit();
  }
  if (database.execAndGet("PRAGMA application_id").getInt() != recruits_application_id)
    throw not_recruits(file, "another program's");
  if (database.execAndGet("PRAGMA user_version").getInt() != recruits_schema_version)
    throw not_recruits(file, "one of another version of seamline");
  return database;
}

Recruit recruit_of(SQLite::Database& database, SQLite::Statement& row) {
  Recruit recruit{.code = row.getColumn(0).getString(),
                  .person = row.getColumn(1).getString(),
                  .outcome = visit_outcome_from_word(row.getColumn(2).getString()),
                  .completion_code = row.getColumn(3).getString()};
  SQLite::Statement identifier(database, "SELECT name, value FROM identifiers WHERE code = ?");
  SQLite::bind(identifier, recruit.code);
  while (identifier.executeStep())
    recruit.identifiers[identifier.getColumn(0).getString()] = identifier.getColumn(1).getString();
  return recruit;
}

/// With no file there is nobody, and none is made.
template <class Work>
int with_recruits(const fs::path& log, Work&& work) {
  const fs::path file = recruits_file(log);
  std::error_code error;
  if (!fs::exists(file, error)) return 0;
  return with_log_errors(file, [&] {
    SQLite::Database database = open_recruits(file);
    return work(database);
  });
}

}  // namespace

struct Recruits::Tables {
  fs::path file;
  SQLite::Database database;
};

Recruits::Recruits(const fs::path& log) {
  const fs::path file = recruits_file(log);
  with_log_errors(file, [&] {
    tables_ = std::make_unique<Tables>(Tables{.file = file, .database = open_recruits(file)});
  });
}

Recruits::~Recruits() = default;

std::optional<Recruit> Recruits::of_person(const std::string& person) {
  return with_log_errors(tables_->file, [&]() -> std::optional<Recruit> {
    SQLite::Statement row(tables_->database,
                          "SELECT code, person, outcome, completion_code FROM recruits WHERE person = ?");
    SQLite::bind(row, person);
    if (!row.executeStep()) return std::nullopt;
    return recruit_of(tables_->database, row);
  });
}

std::optional<Recruit> Recruits::of_code(const std::string& code) {
  return with_log_errors(tables_->file, [&]() -> std::optional<Recruit> {
    SQLite::Statement row(tables_->database,
                          "SELECT code, person, outcome, completion_code FROM recruits WHERE code = ?");
    SQLite::bind(row, code);
    if (!row.executeStep()) return std::nullopt;
    return recruit_of(tables_->database, row);
  });
}

void Recruits::enter(const Recruit& recruit) {
  with_log_errors(tables_->file, [&] {
    SQLite::Transaction entering(tables_->database, SQLite::TransactionBehavior::IMMEDIATE);
    SQLite::Statement before(tables_->database, "DELETE FROM recruits WHERE person = ? OR code = ?");
    run(before, recruit.person, recruit.code);
    SQLite::Statement row(tables_->database, "INSERT INTO recruits VALUES (?, nullif(?, ''), ?, ?)");
    SQLite::bind(row, recruit.code, recruit.person);
    if (recruit.outcome) row.bind(3, std::string(word(*recruit.outcome)));
    row.bind(4, recruit.completion_code);
    row.exec();
    SQLite::Statement identifier(tables_->database, "INSERT INTO identifiers VALUES (?, ?, ?)");
    for (const auto& [name, value] : recruit.identifiers) run(identifier, recruit.code, name, value);
    entering.commit();
  });
}

void Recruits::end(const std::string& code, VisitOutcome outcome, const std::string& completion_code) {
  with_log_errors(tables_->file, [&] {
    SQLite::Statement row(tables_->database, R"sql(
        INSERT INTO recruits (code, outcome, completion_code) VALUES (?, ?, ?)
        ON CONFLICT (code) DO UPDATE SET outcome = excluded.outcome, completion_code = excluded.completion_code)sql");
    run(row, code, std::string(word(outcome)), completion_code);
  });
}

std::vector<Recruit> Recruits::everybody() {
  return with_log_errors(tables_->file, [&] {
    std::vector<Recruit> all;
    SQLite::Statement row(tables_->database,
                          "SELECT code, person, outcome, completion_code FROM recruits ORDER BY code");
    while (row.executeStep()) all.push_back(recruit_of(tables_->database, row));
    return all;
  });
}

fs::path recruits_file(const fs::path& log) {
  return log_place(log).string() + "-recruits";
}

bool forget_recruit(const fs::path& log, const std::string& code) {
  return with_recruits(log, [&](SQLite::Database& database) {
           SQLite::Statement row(database, "DELETE FROM recruits WHERE code = ?");
           run(row, code);
           const int gone = row.getChanges();
           if (gone > 0) database.exec("VACUUM");
           return gone;
         }) > 0;
}

int forget_identifiers(const fs::path& log) {
  return with_recruits(log, [&](SQLite::Database& database) {
    SQLite::Transaction forgetting(database, SQLite::TransactionBehavior::IMMEDIATE);
    const int people = database.execAndGet("SELECT count(DISTINCT code) FROM identifiers").getInt();
    database.exec("DELETE FROM identifiers");
    database.exec("UPDATE recruits SET person = NULL");
    forgetting.commit();
    database.exec("VACUUM");
    return people;
  });
}

int write_recruits(const fs::path& log, const fs::path& csv) {
  std::error_code error;
  if (!fs::exists(recruits_file(log), error))
    throw input_error({.file = recruits_file(log).string(),
                       .wanted = "what a server keeps of people from a panel ([recruitment] in the study)",
                       .found = "no file"});
  const std::vector<Recruit> all = Recruits(log).everybody();
  std::set<std::string> names;
  for (const Recruit& recruit : all)
    for (const auto& [name, value] : recruit.identifiers) names.insert(name);
  CsvTable table{.name = "identifiers", .columns = {}, .rows = {}};
  for (const char* name : {"participant", "outcome", "completion_code"})
    table.columns.push_back({name, "", ""});
  for (const std::string& name : names) table.columns.push_back({name, "", ""});
  for (const Recruit& recruit : all) {
    std::vector<CsvValue> row = {recruit.code,
                                 recruit.outcome ? CsvValue(std::string(word(*recruit.outcome))) : CsvValue(),
                                 recruit.completion_code};
    for (const std::string& name : names) {
      const auto value = recruit.identifiers.find(name);
      row.push_back(value == recruit.identifiers.end() ? CsvValue() : CsvValue(value->second));
    }
    table.rows.push_back(std::move(row));
  }
  write_file_atomically(csv, csv_text(table), Readers::owner);
  return static_cast<int>(all.size());
}

}  // namespace seamline::study
