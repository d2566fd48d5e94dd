#include "study/log/online/log_merge.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "study/log/log_database.h"
#include "study/log/log_place.h"
#include "study/log/online/merged_study.h"
#include "study/log/online/online_tables.h"
#include "study/log/recovery/log_rows.h"
#include "study/log/session_claims.h"
#include "support/files/hash.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t most_named = 5;  ///< conflicts in the sentence

/// Rows that hang on a participant, in the order in which they can be entered. Columns count from 0; -1:
/// none.
struct HangingTable {
  const char* name;
  const char* of_participant;  ///< a condition on one parameter, the participant
  int participant_column, session_column;
  bool own_key;  ///< column 0 is a number that the log gives
  bool online;
};
constexpr const char* by_participant = "participant = ?";
constexpr const char* by_session = "session IN (SELECT session FROM sessions WHERE participant = ?)";
constexpr std::array<HangingTable, 12> hanging_tables = {
    {{"online_participants", by_participant, 0, -1, false, true},
     {"consents", by_participant, 0, -1, false, false},
     {"form_answers", by_participant, 0, -1, false, false},
     {"sessions", by_participant, 1, 0, true, false},
     {"displays", by_session, -1, 0, false, false},
     {"trials", by_participant, 0, -1, false, false},
     {"answers", by_participant, 0, 2, false, false},
     {"training_answers", by_session, -1, 0, false, false},
     {"set_aside_answers", by_participant, 0, 5, false, false},
     {"events", by_session, -1, 1, true, false},
     {"online_messages", by_participant, 1, -1, false, true},
     {"online_sittings", by_session, -1, 0, false, true}}};

/// A log that rows are entered into; each table's statement is prepared once.
class EnteredLog {
 public:
  explicit EnteredLog(SQLite::Database& log) : database(log) {}
  SQLite::Database& database;

  void insert(const char* table, const LogRow& row, const char* how = "INSERT") {
    std::string places = "?";
    for (std::size_t i = 1; i < row.size(); ++i) places += ", ?";
    const std::string text = fmt::format("{} INTO {} VALUES ({})", how, table, places);
    SQLite::Statement& statement = statements_.try_emplace(text, database, text).first->second;
    bind_row(statement, row);
    statement.exec();
    statement.reset();
  }

 private:
  std::map<std::string, SQLite::Statement> statements_;
};

std::vector<LogRow> rows_of(SQLite::Database& database, const char* table, const std::string& condition = "1",
                            std::optional<std::int64_t> participant = {}) {
  SQLite::Statement statement(database, fmt::format("SELECT * FROM {} WHERE {}", table, condition));
  if (participant) statement.bind(1, *participant);
  std::vector<LogRow> rows;
  while (statement.executeStep()) rows.push_back(row_of(statement));
  return rows;
}

std::string text_of(const LogValue& value) {
  return std::visit(
      [](const auto& one) -> std::string {
        if constexpr (std::is_same_v<std::decay_t<decltype(one)>, std::monostate>)
          return "-";
        else
          return fmt::format("{}", one);
      },
      value);
}

std::string text_of(const LogRow& row, std::size_t first) {
  std::string text;
  for (std::size_t i = first; i < row.size(); ++i) text += text_of(row[i]) + "\n";
  return text;
}

/// What a log says of somebody, each thing under a name that is the same in every log.
struct PersonFacts {
  std::int64_t participant = 0;
  LogRow row;  ///< of `participants`
  std::map<std::string, std::string> said;
};

bool is_within(const PersonFacts& one, const PersonFacts& other) {
  return std::all_of(one.said.begin(), one.said.end(), [&](const auto& entry) {
    const auto found = other.said.find(entry.first);
    return found != other.said.end() && found->second == entry.second;
  });
}

constexpr std::size_t code_at = 1, excluded_at = 4, completed_at = 5, observer_at = 6, seed_at = 7;

PersonFacts facts_of(SQLite::Database& database, const LogRow& row) {
  PersonFacts facts{.participant = std::get<std::int64_t>(row[0]), .row = row, .said = {}};
  const std::string code = text_of(row[code_at]);
  LogRow fixed = row;
  fixed[0] = fixed[excluded_at] = fixed[completed_at] = {};
  facts.said["who"] = text_of(fixed, 0);
  const bool simulated = !std::holds_alternative<std::monostate>(row[observer_at]);
  std::map<int, std::string> message_of;
  if (has_online_tables(schema_version_of(database)))
    for (const LogRow& message : rows_of(database, "online_messages", by_participant, facts.participant)) {
      facts.said["message " + text_of(message[2])] = text_of(message[0]) + text_of(message[5]);
      if (const auto* trial = std::get_if<std::int64_t>(&message[4]))
        message_of[static_cast<int>(*trial)] = text_of(message[0]);
    }
  SQLite::Statement answer(database, R"sql(
      SELECT trial_index, started_unix_s, kind, stimulus, chosen_index, rating, choice_ns, rating_ns, image_scale
      FROM answers JOIN trials USING (participant, trial_index) JOIN sessions USING (session)
      WHERE answers.participant = ?)sql");
  SQLite::bind(answer, facts.participant);
  while (answer.executeStep()) {
    const int trial = answer.getColumn(0).getInt();
    const auto message = message_of.find(trial);
    const std::string id =
        message != message_of.end()
            ? message->second
            : window_answer_id(code, trial,
                               simulated ? text_of(row[seed_at]) : answer.getColumn(1).getString());
    facts.said[fmt::format("answer {}", trial)] = id + "\n" + text_of(row_of(answer), 2);
  }
  return facts;
}

std::optional<PersonFacts> find_person(SQLite::Database& database, const LogValue& code) {
  SQLite::Statement found(database, "SELECT * FROM participants WHERE code = ?");
  SQLite::bind(found, std::get<std::string>(code));
  if (!found.executeStep()) return std::nullopt;
  return facts_of(database, row_of(found));
}

/// Enters somebody with everything that hangs on them, under a number of this log's.
std::int64_t copy_person(SQLite::Database& from, EnteredLog& into, const PersonFacts& person,
                         std::optional<std::int64_t> number) {
  LogRow row = person.row;
  row[0] = number ? LogValue(*number) : LogValue();
  into.insert("participants", row);
  const std::int64_t participant = into.database.getLastInsertRowid();
  const bool online = has_online_tables(schema_version_of(from));
  std::map<std::int64_t, std::int64_t> session_of;
  for (const LogRow& consent : rows_of(from, "consents", by_participant, person.participant)) {
    SQLite::Statement text(from, "SELECT * FROM consent_texts WHERE text_sha256 = ?");
    SQLite::bind(text, std::get<std::string>(consent[2]));
    if (text.executeStep()) into.insert("consent_texts", row_of(text), "INSERT OR IGNORE");
  }
  for (const HangingTable& table : hanging_tables) {
    if (table.online && !online) continue;
    for (LogRow copied : rows_of(from, table.name, table.of_participant, person.participant)) {
      stop_if_interrupted();
      const std::int64_t old_key = table.own_key ? std::get<std::int64_t>(copied[0]) : 0;
      const bool is_session = table.session_column == 0 && table.own_key;
      if (table.participant_column >= 0) copied[table.participant_column] = participant;
      if (table.session_column >= 0 && !is_session) {
        LogValue& session = copied[table.session_column];
        session = session_of.at(std::get<std::int64_t>(session));
      }
      if (table.own_key) copied[0] = {};
      into.insert(table.name, copied);
      if (is_session) session_of[old_key] = into.database.getLastInsertRowid();
    }
  }
  return participant;
}

/// Rows that say when something happened and not to whom: as many of each as the log that has more.
void merge_anonymous(SQLite::Database& from, EnteredLog& into, const char* table) {
  std::map<std::string, int> there;
  for (const LogRow& row : rows_of(into.database, table)) ++there[text_of(row, 1)];
  for (LogRow row : rows_of(from, table)) {
    if (there[text_of(row, 1)]-- > 0) continue;
    row[0] = {};
    into.insert(table, row);
  }
}

void merge_one(SQLite::Database& from, SQLite::Database& into, MergedLog& merged,
               std::vector<std::string>& conflicts) {
  if (has_online_tables(schema_version_of(from))) add_online_tables(into);
  const std::string observer = other_observer(into, from);
  EnteredLog entered(into);
  const auto enter = [&](const PersonFacts& person, std::optional<std::int64_t> number) {
    const std::int64_t participant = copy_person(from, entered, person, number);
    if (observer.empty() || std::holds_alternative<std::monostate>(person.row[observer_at])) return;
    note_observer(into, participant, observer);
    ++merged.other_observer;
  };
  for (const LogRow& row : rows_of(from, "participants", "1 ORDER BY participant")) {
    const PersonFacts person = facts_of(from, row);
    const std::string code = text_of(person.row[code_at]);
    const std::optional<PersonFacts> known = find_person(into, person.row[code_at]);
    if (!known) {
      enter(person, {});
      merged.added.push_back(code);
      continue;
    }
    const bool completed = std::get<std::int64_t>(person.row[completed_at]) != 0;
    const bool known_completed = std::get<std::int64_t>(known->row[completed_at]) != 0;
    if (is_within(person, *known) && (known_completed || !completed)) {
      ++merged.known;
    } else if (is_within(*known, person)) {
      SQLite::Statement remove(into, "DELETE FROM participants WHERE participant = ?");
      run(remove, known->participant);
      enter(person, known->participant);
      merged.extended.push_back(code);
    } else {
      const auto different = std::find_if(person.said.begin(), person.said.end(), [&](const auto& entry) {
        const auto other = known->said.find(entry.first);
        return other != known->said.end() && other->second != entry.second;
      });
      conflicts.push_back(fmt::format("{} of {} ({})", code, merged.from.string(),
                                      different == person.said.end() ? "each log has answers the other lacks"
                                                                     : different->first + " differs"));
      continue;
    }
    if (std::get<std::int64_t>(person.row[excluded_at]) != 0 ||
        std::get<std::int64_t>(known->row[excluded_at]) != 0) {
      SQLite::Statement exclude(into, "UPDATE participants SET excluded = 1 WHERE code = ?");
      run(exclude, code);
    }
  }
  for (const char* table : {"declines", "deletions"}) merge_anonymous(from, entered, table);
  if (!has_online_tables(schema_version_of(from))) return;
  for (const LogRow& row : rows_of(from, "online_tokens"))
    entered.insert("online_tokens", row, "INSERT OR IGNORE");
  for (const LogRow& row : rows_of(from, "online_messages", "participant IS NULL"))
    entered.insert("online_messages", row, "INSERT OR IGNORE");
}

void check_version(SQLite::Database& database, const fs::path& path) {
  if (const int version = schema_version_of(database); version < log_schema_version)
    throw input_error({.file = path.string(),
                       .field = "user_version",
                       .wanted = fmt::format("a log of schema version {} (`seamline log upgrade LOG NEW`)",
                                             log_schema_version),
                       .found = fmt::format("version {}", version)});
}

void check_no_session_is_open(SQLite::Database& database, const fs::path& path) {
  for (SQLite::Statement row(database, "SELECT participant FROM participants"); row.executeStep();)
    if (is_claimed(path, row.getColumn(0).getInt64()))
      throw input_error({.file = path.string(),
                         .wanted = "a log in which nobody is in a session",
                         .found = "somebody who is (or a server that has it open)"});
}

}  // namespace

std::string window_answer_id(const std::string& code, int trial_index, const std::string& begun) {
  std::string hex = sha256(fmt::format("seamline window answer\n{}\n{}\n{}", code, trial_index, begun));
  hex[12] = '8';  // a UUID of a form of our own
  hex[16] = "89ab"[hex[16] % 4];
  return fmt::format("{}-{}-{}-{}-{}", hex.substr(0, 8), hex.substr(8, 4), hex.substr(12, 4),
                     hex.substr(16, 4), hex.substr(20, 12));
}

std::vector<MergedLog> merge_logs(const fs::path& into, const std::vector<fs::path>& from) {
  std::vector<MergedLog> merged;
  SQLite::Database target = open_log_database(into, LogAccess::alone);
  with_log_errors(into, [&] {
    check_version(target, into);
    check_undamaged(target, into);
    check_no_session_is_open(target, into);
    SQLite::Transaction transaction(target, SQLite::TransactionBehavior::IMMEDIATE);
    std::vector<std::string> conflicts;
    for (const fs::path& path : from) {
      if (file_identity(path) && file_identity(path) == file_identity(into))
        throw input_error(
            {.file = path.string(), .wanted = "another log than the one merged into", .found = "it"});
      SQLite::Database source = open_log_database(path, LogAccess::read);
      merged.push_back({.from = path, .added = {}, .extended = {}});
      with_log_errors(path, [&] {
        const SQLite::Transaction one_moment(source);
        check_version(source, path);
        check_undamaged(source, path);
        check_same_study(target, source, path);
        check_no_session_is_open(source, path);
        merge_one(source, target, merged.back(), conflicts);
      });
    }
    if (!conflicts.empty()) {
      std::string named;
      for (std::size_t i = 0; i < std::min(most_named, conflicts.size()); ++i)
        named += (named.empty() ? "" : "; ") + conflicts[i];
      if (conflicts.size() > most_named) named += fmt::format("; and {} more", conflicts.size() - most_named);
      throw input_error({.file = into.string(),
                         .wanted = "participants of whom all logs say the same (nothing was merged)",
                         .found = named});
    }
    transaction.commit();
    check_undamaged(target, into);
  });
  return merged;
}

std::string merge_text(const std::vector<MergedLog>& merged, const fs::path& into) {
  std::string text;
  for (const MergedLog& one : merged)
    text += fmt::format("{}: {} participant{} added, {} extended, {} known before, into {}\n",
                        one.from.string(), one.added.size(), one.added.size() == 1 ? "" : "s",
                        one.extended.size(), one.known, into.string());
  for (const MergedLog& one : merged)
    if (one.other_observer > 0)
      text += fmt::format(
          "{}: {} of them are simulated with another [observer] than the study in {} says; an event "
          "\"observer\" of each keeps how it differs\n",
          one.from.string(), one.other_observer, into.string());
  return text;
}

}  // namespace seamline::study
