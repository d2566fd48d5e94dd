// What the log keeps of a session besides answers: consent, form, display, practice, events.
#include "study/log/log_tables.h"
#include "support/files/hash.h"

namespace seamline::study {
namespace {

constexpr const char* display_columns =
    "machine, monitor, renderer, mode_width_px, mode_height_px, refresh_hz, content_scale, "
    "framebuffer_width_px, framebuffer_height_px, mm_per_px, viewing_distance_mm, pixels_per_degree, "
    "gamma_confirmed, read_back_bytes, read_back_different, scaling_allowed, image_scale";

DisplayFacts read_display(SQLite::Statement& row) {
  int column = 0;
  const auto next = [&] { return row.getColumn(column++); };
  DisplayFacts facts;
  facts.machine = next().getString();
  facts.monitor = next().getString();
  facts.renderer = next().getString();
  facts.mode_width_px = next().getInt();
  facts.mode_height_px = next().getInt();
  facts.refresh_hz = next().getDouble();
  facts.content_scale = next().getDouble();
  facts.framebuffer_width_px = next().getInt();
  facts.framebuffer_height_px = next().getInt();
  facts.mm_per_px = next().getDouble();
  facts.viewing_distance_mm = next().getDouble();
  facts.pixels_per_degree = next().getDouble();
  facts.gamma_confirmed = next().getInt() != 0;
  facts.read_back_bytes = next().getInt64();
  facts.read_back_different = next().getInt64();
  facts.scaling_allowed = next().getInt() != 0;
  facts.image_scale = next().getDouble();
  return facts;
}

}  // namespace

void LogWriter::record_decline() {
  transaction([&] {
    SQLite::Statement decline(tables_->database, "INSERT INTO declines (declined_unix_s) VALUES (?)");
    run(decline, now_unix_s());
  });
}

void LogWriter::record_consent(OpenSession& session, const std::string& consent_text,
                               std::int64_t accepted_unix_s) {
  const std::string hash = sha256(consent_text);
  transaction([&] {
    SQLite::Statement text(tables_->database, "INSERT OR IGNORE INTO consent_texts VALUES (?, ?)");
    run(text, hash, consent_text);
    SQLite::Statement consent(tables_->database, "INSERT OR REPLACE INTO consents VALUES (?, ?, ?)");
    run(consent, session.participant, accepted_unix_s, hash);
  });
  session.consented = true;
}

void LogWriter::record_form(OpenSession& session, std::span<const FormAnswer> answers) {
  transaction([&] {
    SQLite::Statement before(tables_->database, "DELETE FROM form_answers WHERE participant = ?");
    run(before, session.participant);
    SQLite::Statement insert(tables_->database, "INSERT INTO form_answers VALUES (?, ?, ?)");
    for (const FormAnswer& answer : answers)
      if (!answer.value.empty()) run(insert, session.participant, answer.field, answer.value);
  });
  session.form_done = true;
}

void LogWriter::record_display(OpenSession& session, const DisplayFacts& facts) {
  transaction([&] {
    SQLite::Statement insert(tables_->database,
                             std::string("INSERT OR REPLACE INTO displays (session, ") + display_columns +
                                 ") VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    run(insert, session.session, facts.machine, facts.monitor, facts.renderer, facts.mode_width_px,
        facts.mode_height_px, facts.refresh_hz, facts.content_scale, facts.framebuffer_width_px,
        facts.framebuffer_height_px, facts.mm_per_px, facts.viewing_distance_mm, facts.pixels_per_degree,
        facts.gamma_confirmed ? 1 : 0, facts.read_back_bytes, facts.read_back_different,
        facts.scaling_allowed ? 1 : 0, facts.image_scale);
  });
  session.image_scale = facts.image_scale;
}

std::optional<DisplayFacts> LogWriter::latest_display(const std::string& machine,
                                                      const std::string& monitor) {
  return with_log_errors(path_, [&]() -> std::optional<DisplayFacts> {
    SQLite::Statement row(
        tables_->database,
        std::string("SELECT ") + display_columns +
            " FROM displays WHERE machine = ? AND monitor = ? ORDER BY session DESC LIMIT 1");
    SQLite::bind(row, machine, monitor);
    if (!row.executeStep()) return std::nullopt;
    return read_display(row);
  });
}

void LogWriter::add_frames(const OpenSession& session, const FrameCounts& frames) {
  transaction([&] {
    SQLite::Statement add(
        tables_->database,
        "UPDATE sessions SET frames = frames + ?, late_frames = late_frames + ? WHERE session = ?");
    run(add, frames.shown, frames.late, session.session);
  });
}

void LogWriter::append_training(const OpenSession& session, const TrainingAnswer& training) {
  transaction([&] {
    SQLite::Statement insert(tables_->database,
                             "INSERT INTO training_answers VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
    const TrialAnswer& answer = training.answer;
    run(insert, session.session, answer.trial_index, std::string(word(training.trial.kind)),
        training.trial.stimulus, answer.chosen_index, answer.rating, answer.choice_ns, answer.rating_ns);
  });
}

void LogWriter::append_events(const OpenSession& session, std::span<const RawEvent> events) {
  transaction([&] {
    for (const RawEvent& event : events) {
      SQLite::Statement& insert = tables_->event;
      insert.tryReset();
      insert.clearBindings();
      SQLite::bind(insert, session.session, event.monotonic_ns, event.kind);
      if (event.trial_index) insert.bind(4, *event.trial_index);
      insert.bind(5, event.detail);
      if (event.swap) insert.bind(6, *event.swap);
      insert.exec();
      insert.tryReset();
    }
  });
}

}  // namespace seamline::study
