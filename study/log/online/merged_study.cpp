#include "study/log/online/merged_study.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>

#include "stimuli/set/set_study.h"
#include "stimuli/study_file/study_file.h"
#include "study/log/recovery/log_rows.h"

namespace seamline::study {
namespace {

std::string study_text_at(SQLite::Database& database, const char* question) {
  return database.execAndGet(question).getString();
}

/// None: a text of another program's time.
std::optional<StudyDefinition> study_of_log(SQLite::Database& database) {
  try {
    return read_study_text(study_text_at(database, "SELECT study_text FROM study"), "the log's study");
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::vector<LogRow> stimuli_of(SQLite::Database& database) {
  SQLite::Statement statement(database, "SELECT * FROM stimuli ORDER BY stimulus");
  std::vector<LogRow> rows;
  while (statement.executeStep()) rows.push_back(row_of(statement));
  return rows;
}

bool has_simulated_people(SQLite::Database& database) {
  return SQLite::Statement(database, "SELECT 1 FROM participants WHERE observer IS NOT NULL").executeStep();
}

std::multiset<std::string> canonical_lines(const StudyDefinition& study) {
  std::multiset<std::string> lines;
  std::istringstream text(canonical_text(study));
  for (std::string line; std::getline(text, line);) lines.insert(line);
  return lines;
}

/// The lines of one that the other has not, each behind a sign.
std::string lines_without(const std::multiset<std::string>& lines, const std::multiset<std::string>& others,
                          const std::string& sign) {
  std::vector<std::string> own;
  std::set_difference(lines.begin(), lines.end(), others.begin(), others.end(), std::back_inserter(own));
  std::string text;
  for (const std::string& line : own) text += sign + " " + line + "\n";
  return text;
}

}  // namespace

void check_same_study(SQLite::Database& into, SQLite::Database& from, const std::filesystem::path& path) {
  bool shows_the_same = false;  // though its hashes are others
  for (const auto& [field, question] : {std::pair("study_hash", "SELECT study_hash FROM study"),
                                        std::pair("set_hash", "SELECT set_hash FROM study")}) {
    const std::string wanted = study_text_at(into, question), found = study_text_at(from, question);
    if (wanted == found || shows_the_same) continue;
    const std::optional<StudyDefinition> own = study_of_log(into), other = study_of_log(from);
    shows_the_same = field == std::string("study_hash") && own && other && same_but_observer(*own, *other);
    if (!shows_the_same)
      throw input_error({.file = path.string(),
                         .field = field,
                         .wanted = wanted + ", of the log that it is merged into (nothing was merged)",
                         .found = found});
  }
  if (stimuli_of(into) != stimuli_of(from))
    throw input_error({.file = path.string(),
                       .field = "stimuli",
                       .wanted = "those of the log that it is merged into (nothing was merged)",
                       .found = "others"});
}

std::string other_observer(SQLite::Database& into, SQLite::Database& from) {
  if (!has_simulated_people(from)) return {};
  const std::optional<StudyDefinition> own = study_of_log(into), other = study_of_log(from);
  if (!own || !other) return {};
  const std::multiset<std::string> own_lines = canonical_lines(*own), other_lines = canonical_lines(*other);
  if (own_lines == other_lines) return {};
  if (!has_simulated_people(into)) {
    SQLite::Statement taken(into, "UPDATE study SET study_text = ?");
    SQLite::bind(taken, study_text_at(from, "SELECT study_text FROM study"));
    taken.exec();
    return {};
  }
  return lines_without(own_lines, other_lines, "-") + lines_without(other_lines, own_lines, "+");
}

void note_observer(SQLite::Database& into, std::int64_t participant, const std::string& difference) {
  SQLite::Statement note(into, R"sql(
      INSERT INTO events (session, monotonic_ns, kind, detail)
      SELECT session, 0, 'observer', ? FROM sessions JOIN participants USING (participant)
      WHERE participant = ? AND observer IS NOT NULL
        AND NOT EXISTS (SELECT 1 FROM events WHERE events.session = sessions.session AND kind = 'observer'))sql");
  SQLite::bind(note, difference, participant);
  note.exec();
}

}  // namespace seamline::study
