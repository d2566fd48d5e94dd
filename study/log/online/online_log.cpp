#include "study/log/online/online_log.h"

#include <algorithm>

#include "study/log/log_tables.h"
#include "study/log/log_values.h"
#include "study/log/online/online_tables.h"
#include "support/files/assets.h"

namespace seamline::study {
struct OnlineLog::Statements {
  explicit Statements(SQLite::Database& opened) : database(opened) {}

  SQLite::Database& database;
  SQLite::Statement message{
      database,
      "SELECT coalesce((SELECT code FROM participants WHERE participants.participant = "
      "online_messages.participant), ''), content_sha256 FROM online_messages WHERE id = ?"};
  SQLite::Statement sequence{database,
                             "SELECT 1 FROM online_messages WHERE participant = ? AND sequence = ?"};
  SQLite::Statement note{database, "INSERT INTO online_messages VALUES (?, ?, ?, ?, ?, ?)"};
};

OnlineLog::OnlineLog(const std::filesystem::path& path, const RenderedSet& set) : log_(path, set) {
  log_.tables_->claims.open();
  with_log_errors(path, [&] {
    SQLite::Transaction transaction(log_.tables_->database, SQLite::TransactionBehavior::IMMEDIATE);
    add_online_tables(log_.tables_->database);
    transaction.commit();
    sql_ = std::make_unique<Statements>(log_.tables_->database);
  });
}

OnlineLog::~OnlineLog() = default;

void OnlineLog::transaction(const std::function<void()>& work) {
  log_.transaction(work);
}

std::optional<OnlinePerson> OnlineLog::find(const std::string& code) {
  LogWriter::Tables& tables = *log_.tables_;
  SQLite::Statement row(tables.database, R"sql(
      SELECT participant, slot, excluded, completed,
             (SELECT origin FROM online_participants WHERE online_participants.participant = participants.participant),
             EXISTS (SELECT 1 FROM consents WHERE consents.participant = participants.participant),
             EXISTS (SELECT 1 FROM form_answers WHERE form_answers.participant = participants.participant),
             (SELECT coalesce(max(session), 0) FROM sessions WHERE sessions.participant = participants.participant),
             (SELECT coalesce(max(sequence) + 1, 0) FROM online_messages
              WHERE online_messages.participant = participants.participant),
             (SELECT coalesce(max(training_index) + 1, 0) FROM training_answers JOIN sessions USING (session)
              WHERE sessions.participant = participants.participant),
             EXISTS (SELECT 1 FROM online_messages
                     WHERE online_messages.participant = participants.participant AND kind = 'form'),
             (SELECT coalesce(max(accepted_unix_s), 0) FROM consents WHERE consents.participant = participants.participant),
             (SELECT count(*) FROM online_messages WHERE online_messages.participant = participants.participant),
             (SELECT coalesce(sum(length(CAST(kind AS BLOB)) + length(CAST(detail AS BLOB))), 0) FROM events JOIN sessions USING (session)
              WHERE sessions.participant = participants.participant)
             + (SELECT coalesce(sum(length(CAST(user_agent AS BLOB))), 0) FROM online_sittings JOIN sessions USING (session)
                WHERE sessions.participant = participants.participant)
      FROM participants WHERE code = ?)sql");
  SQLite::bind(row, code);
  if (!row.executeStep()) return std::nullopt;
  const std::optional<Origin> origin = origin_from_word(row.getColumn(4).getString());
  if (row.getColumn(4).isNull() || !origin)
    throw input_error({.file = tables.path.string(),
                       .field = "participant " + code,
                       .wanted = "one who takes part in a browser",
                       .found = "one of the window"});
  OnlinePerson person{
      .place = {.participant = row.getColumn(0).getInt64(),
                .session = row.getColumn(7).getInt64(),
                .slot = row.getColumn(1).getInt(),
                .completed = row.getColumn(3).getInt() != 0,
                .excluded = row.getColumn(2).getInt() != 0,
                .consented = row.getColumn(5).getInt() != 0,
                .form_done = row.getColumn(6).getInt() != 0 || row.getColumn(10).getInt() != 0},
      .code = code,
      .origin = *origin,
      .accepted_unix_s = row.getColumn(11).getInt64(),
      .training_done = row.getColumn(9).getInt(),
      .next_sequence = row.getColumn(8).getInt64(),
      .stored_bytes = row.getColumn(12).getInt64() * stored_bytes_of(0) + row.getColumn(13).getInt64()};
  if (!tables.claims.claim(person.place.participant))
    throw input_error({.file = tables.path.string(),
                       .field = "participant " + code,
                       .wanted = "a participant whom no other program serves",
                       .found = "one of another program that has the log open"});
  tables.read_trials(person.place);
  SQLite::Statement answer(tables.database, R"sql(
      SELECT trial_index, chosen_index, rating, choice_ns, rating_ns FROM answers
      WHERE participant = ? ORDER BY trial_index)sql");
  SQLite::bind(answer, person.place.participant);
  const LogValues values(answer, tables.path, "answers");
  while (answer.executeStep()) {
    person.answered.insert(values.number(0, 0));
    person.place.answers.push_back({.trial_index = values.number(0, 0),
                                    .chosen_index = values.number(1, 1, most_objects_of_scene),
                                    .rating = values.number(2, 1, 4),
                                    .choice_ns = values.time(3),
                                    .rating_ns = values.time(4)});
  }
  person.place.answered = static_cast<int>(person.answered.size());
  return person;
}

std::optional<std::set<std::string>> OnlineLog::excluded_since() {
  SQLite::Database& database = log_.tables_->database;
  const std::int64_t version = database.execAndGet("PRAGMA data_version").getInt64();
  if (version == seen_version_) return std::nullopt;
  seen_version_ = version;
  std::set<std::string> codes;
  for (SQLite::Statement row(database, "SELECT code FROM participants WHERE excluded = 1");
       row.executeStep();)
    codes.insert(row.getColumn(0).getString());
  return codes;
}

std::vector<HeldSlot> OnlineLog::held_slots(bool pilot) {
  return log_.held_slots({.pilot = pilot});
}

OnlinePerson OnlineLog::enter(const OnlineNewcomer& newcomer) {
  LogWriter::Tables& tables = *log_.tables_;
  check_participant_code(newcomer.code);
  OnlinePerson person{.place = tables.enter_participant(
                          {.code = newcomer.code, .pilot = newcomer.pilot, .slot = newcomer.slot}),
                      .code = newcomer.code,
                      .origin = newcomer.origin};
  SQLite::Statement enter(tables.database, "INSERT INTO online_participants VALUES (?, ?, ?)");
  SQLite::bind(enter, person.place.participant, std::string(word(newcomer.origin)));
  if (!newcomer.secret_sha256.empty()) enter.bind(3, newcomer.secret_sha256);
  enter.exec();
  if (!tables.claims.claim(person.place.participant))
    throw input_error({.file = tables.path.string(),
                       .field = "participant " + newcomer.code,
                       .wanted = "a participant whom no other program serves",
                       .found = "one of another program that has the log open"});
  return person;
}

void OnlineLog::set_secret(const OnlinePerson& person, const std::string& secret_sha256) {
  SQLite::Statement update(log_.tables_->database,
                           "UPDATE online_participants SET secret_sha256 = ? WHERE participant = ?");
  run(update, secret_sha256, person.place.participant);
}

std::map<std::string, std::string> OnlineLog::secrets() {
  SQLite::Statement row(
      log_.tables_->database,
      "SELECT secret_sha256, code FROM online_participants JOIN participants USING (participant) "
      "WHERE secret_sha256 IS NOT NULL");
  std::map<std::string, std::string> codes;
  while (row.executeStep()) codes[row.getColumn(0).getString()] = row.getColumn(1).getString();
  return codes;
}

bool OnlineLog::use_token(const std::string& token_sha256) {
  SQLite::Statement use(log_.tables_->database, "INSERT OR IGNORE INTO online_tokens VALUES (?)");
  run(use, token_sha256);
  return use.getChanges() == 1;
}

std::optional<KnownMessage> OnlineLog::message(const std::string& id) {
  SQLite::Statement& row = sql_->message;
  row.tryReset();
  SQLite::bind(row, id);
  if (!row.executeStep()) {
    row.tryReset();
    return std::nullopt;
  }
  KnownMessage known{.participant = row.getColumn(0).getString(),
                     .content_sha256 = row.getColumn(1).getString()};
  row.tryReset();
  return known;
}

bool OnlineLog::has_sequence(const OnlinePerson& person, std::int64_t sequence) {
  if (sequence >= person.next_sequence) return false;
  SQLite::Statement& row = sql_->sequence;
  row.tryReset();
  SQLite::bind(row, person.place.participant, sequence);
  const bool found = row.executeStep();
  row.tryReset();
  return found;
}

std::vector<std::int64_t> OnlineLog::sequences(const OnlinePerson& person) {
  SQLite::Statement row(log_.tables_->database,
                        "SELECT sequence FROM online_messages WHERE participant = ? ORDER BY sequence");
  SQLite::bind(row, person.place.participant);
  std::vector<std::int64_t> found;
  while (row.executeStep()) found.push_back(row.getColumn(0).getInt64());
  return found;
}

void OnlineLog::note_message(OnlinePerson& person, const MessageNote& note) {
  SQLite::Statement& insert = sql_->note;
  insert.tryReset();
  insert.clearBindings();
  SQLite::bind(insert, note.id, person.place.participant, note.sequence, note.kind);
  if (note.trial_index) insert.bind(5, *note.trial_index);
  insert.bind(6, note.content_sha256);
  insert.exec();
  insert.tryReset();
  person.next_sequence = std::max(person.next_sequence, note.sequence + 1);
  person.stored_bytes += stored_bytes_of(note.free_text_bytes);
}

void OnlineLog::note_decline(const MessageNote& note) {
  log_.record_decline();
  SQLite::Statement& insert = sql_->note;
  insert.tryReset();
  insert.clearBindings();
  insert.bind(1, note.id);
  insert.bind(3, note.sequence);
  insert.bind(4, note.kind);
  insert.bind(6, note.content_sha256);
  insert.exec();
  insert.tryReset();
}

void OnlineLog::begin_sitting(OnlinePerson& person, const std::string& user_agent, std::int64_t unix_s) {
  LogWriter::Tables& tables = *log_.tables_;
  run(tables.begin, person.place.participant, unix_s, program_version());
  person.place.session = tables.database.getLastInsertRowid();
  SQLite::Statement sitting(tables.database, "INSERT INTO online_sittings VALUES (?, ?)");
  run(sitting, person.place.session, user_agent);
}

void OnlineLog::record_consent(OnlinePerson& person, const std::string& text, std::int64_t accepted_unix_s) {
  log_.record_consent(person.place, text, accepted_unix_s);
  person.accepted_unix_s = accepted_unix_s;
}

void OnlineLog::record_form(OnlinePerson& person, std::span<const FormAnswer> answers) {
  log_.record_form(person.place, answers);
}

void OnlineLog::record_display(OnlinePerson& person, const DisplayFacts& facts) {
  log_.record_display(person.place, facts);
}

void OnlineLog::append_trials(OnlinePerson& person, std::span<const Trial> trials) {
  log_.append_trials(person.place, trials);
}

bool OnlineLog::append_training(OnlinePerson& person, const TrainingAnswer& answer) {
  SQLite::Statement there(log_.tables_->database,
                          "SELECT 1 FROM training_answers WHERE session = ? AND training_index = ?");
  SQLite::bind(there, person.place.session, answer.answer.trial_index);
  if (there.executeStep()) return false;
  log_.append_training(person.place, answer);
  person.training_done = std::max(person.training_done, answer.answer.trial_index + 1);
  return true;
}

void OnlineLog::append_answer(OnlinePerson& person, const TrialAnswer& answer, double image_scale,
                              std::int64_t seen_unix_s) {
  LogWriter::Tables& tables = *log_.tables_;
  run(tables.answer, person.place.participant, answer.trial_index, person.place.session, answer.chosen_index,
      answer.rating, answer.choice_ns, answer.rating_ns, image_scale);
  tables.note_where(person.place.session, answer);
  run(tables.seen, seen_unix_s, person.place.session);
  person.answered.insert(answer.trial_index);
  person.place.answers.push_back(answer);
  person.place.answered = static_cast<int>(person.answered.size());
}

void OnlineLog::append_events(const OnlinePerson& person, std::span<const RawEvent> events) {
  log_.append_events(person.place, events);
}

void OnlineLog::complete(OnlinePerson& person) {
  log_.complete(person.place);
}

OnlineLog::Counts OnlineLog::counts() {
  SQLite::Database& database = log_.tables_->database;
  return {.participants = database.execAndGet("SELECT count(*) FROM online_participants").getInt64(),
          .answers = database.execAndGet("SELECT count(*) FROM answers").getInt64(),
          .deletions = database.execAndGet("SELECT count(*) FROM deletions").getInt64()};
}

std::vector<OnlineStanding> OnlineLog::standings() {
  SQLite::Database& database = log_.tables_->database;
  std::vector<OnlineStanding> all;
  std::map<std::int64_t, std::size_t> place_of;
  SQLite::Statement row(database, R"sql(
      SELECT participant, code, pilot, excluded, completed,
             (SELECT count(*) FROM answers WHERE answers.participant = participants.participant),
             (SELECT count(*) FROM trials WHERE trials.participant = participants.participant),
             (SELECT coalesce(min(started_unix_s), 0) FROM sessions WHERE sessions.participant = participants.participant),
             (SELECT coalesce(max(last_unix_s), 0) FROM sessions WHERE sessions.participant = participants.participant)
      FROM participants JOIN online_participants USING (participant) ORDER BY participant)sql");
  while (row.executeStep()) {
    place_of[row.getColumn(0).getInt64()] = all.size();
    all.push_back({.code = row.getColumn(1).getString(),
                   .pilot = row.getColumn(2).getInt() != 0,
                   .excluded = row.getColumn(3).getInt() != 0,
                   .completed = row.getColumn(4).getInt() != 0,
                   .answered = row.getColumn(5).getInt(),
                   .trials = row.getColumn(6).getInt(),
                   .began_unix_s = row.getColumn(7).getInt64(),
                   .last_unix_s = row.getColumn(8).getInt64()});
  }
  SQLite::Statement form(database, "SELECT participant, field, value FROM form_answers ORDER BY participant");
  while (form.executeStep())
    if (const auto place = place_of.find(form.getColumn(0).getInt64()); place != place_of.end())
      all[place->second].form.push_back(
          {.field = form.getColumn(1).getString(), .value = form.getColumn(2).getString()});
  return all;
}

std::int64_t OnlineLog::declines() {
  return log_.tables_->database.execAndGet("SELECT count(*) FROM declines").getInt64();
}

std::set<std::string> used_invitations(const std::filesystem::path& log) {
  std::error_code error;
  if (!std::filesystem::exists(log, error)) return {};
  SQLite::Database database = open_log_database(log, LogAccess::read);
  return with_log_errors(log, [&] {
    std::set<std::string> used;
    if (!has_online_tables(schema_version_of(database))) return used;
    for (SQLite::Statement row(database, "SELECT token_sha256 FROM online_tokens"); row.executeStep();)
      used.insert(row.getColumn(0).getString());
    return used;
  });
}

}  // namespace seamline::study
