#include "study/exchange/match_records.h"

#include <map>
#include <utility>

#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/study_file/study_file.h"
#include "study/exchange/trial_events.h"
#include "study/log/log_database.h"
#include "study/log/log_values.h"
#include "study/trials/level_ladders.h"

namespace seamline::study {
namespace {

/// The stimulus at which each match stopped, of the session in which it was answered.
std::map<TrialOfPerson, std::string> matched_stimuli(SQLite::Database& database,
                                                     const std::filesystem::path& file) {
  SQLite::Statement row(database, R"sql(
      SELECT participants.code, events.trial_index, events.detail
      FROM events JOIN sessions USING (session) JOIN participants USING (participant)
      JOIN answers ON answers.session = events.session AND answers.trial_index = events.trial_index
      WHERE events.kind = 'matched' ORDER BY events.event)sql");
  const LogValues values(row, file, "events");
  std::map<TrialOfPerson, std::string> stimuli;
  while (row.executeStep()) stimuli[{values.code(0), values.number(1, 0)}] = values.text(2);
  return stimuli;
}

/// How often each trial was moved by a step: choices 1 and 2 among the raw events.
std::map<TrialOfPerson, int> steps_made(SQLite::Database& database, const std::filesystem::path& file) {
  SQLite::Statement row(database, R"sql(
      SELECT participants.code, events.trial_index, count(*)
      FROM events JOIN sessions USING (session) JOIN participants USING (participant)
      JOIN answers ON answers.session = events.session AND answers.trial_index = events.trial_index
      WHERE events.kind = 'choice' AND events.detail IN ('1', '2') GROUP BY 1, 2)sql");
  const LogValues values(row, file, "events");
  std::map<TrialOfPerson, int> steps;
  while (row.executeStep()) steps[{values.code(0), values.number(1, 0)}] = values.number(2, 0);
  return steps;
}

/// The study's stimuli, and where they stand.
struct KnownStimuli {
  std::vector<Stimulus> stimuli;
  LevelLadders ladders;
  std::map<std::string, int> number_of;
};

KnownStimuli known_stimuli(const LogContents& log) {
  const StudyDefinition study = read_study_text(log.study_text, log.file);
  KnownStimuli known{.stimuli = list_stimuli(study), .ladders = {}, .number_of = {}};
  known.ladders = make_level_ladders(known.stimuli, study.level.noticeability);
  for (std::size_t i = 0; i < known.stimuli.size(); ++i)
    known.number_of[stimulus_id(known.stimuli[i])] = static_cast<int>(i);
  return known;
}

int number_of_stimulus(const KnownStimuli& known, const LogContents& log, const Answer& answer,
                       const std::string& id) {
  const auto found = known.number_of.find(id);
  if (found != known.number_of.end() && known.ladders.places[found->second].ladder >= 0) return found->second;
  throw input_error({.file = log.file.string(),
                     .field = "events.detail",
                     .wanted = "a level for the match of trial " + std::to_string(answer.trial_index) +
                               " of " + answer.participant,
                     .found = id.empty() ? "none" : "\"" + id + "\""});
}

MatchRecord match_of(const KnownStimuli& known, const LogContents& log, const Answer& answer,
                     const std::string& id) {
  const int start = number_of_stimulus(known, log, answer, answer.stimulus_id);
  const int stopped = number_of_stimulus(known, log, answer, id);
  return {.participant = answer.participant,
          .trial_index = answer.trial_index,
          .scene = answer.scene,
          .artifact = answer.artifact,
          .object = answer.object,
          .condition = answer.condition,
          .start_level = answer.level,
          .level = known.stimuli[stopped].level,
          .began_clear = begins_clear(known.ladders, start),
          .at_end = !next_rung(known.ladders, stopped, 1) || !next_rung(known.ladders, stopped, -1),
          .answer_s = 1e-9 * answer.choice_ns};
}

}  // namespace

std::vector<MatchRecord> read_matches(const LogContents& log) {
  if (!facts_of(log.task.get()).adjusts()) return {};
  const KnownStimuli known = known_stimuli(log);
  return with_log_errors(log.file, [&] {
    SQLite::Database database = open_log_database(log.file, LogAccess::read);
    const auto stopped = matched_stimuli(database, log.file);
    const auto steps = steps_made(database, log.file);
    std::vector<MatchRecord> matches;
    for (const Answer& answer : log.answers) {
      const TrialOfPerson trial{answer.participant, answer.trial_index};
      const auto found = stopped.find(trial);
      matches.push_back(match_of(known, log, answer, found == stopped.end() ? "" : found->second));
      if (const auto made = steps.find(trial); made != steps.end()) matches.back().steps = made->second;
    }
    return matches;
  });
}

std::optional<CsvTable> match_table(const LogContents& log) {
  const std::vector<MatchRecord> matches = read_matches(log);
  if (matches.empty()) return std::nullopt;
  const std::string unit(facts(log.quantity).unit), quantity(facts(log.quantity).name);
  CsvTable table{
      .name = "matches",
      .columns = {{"participant", "", "code of the participant"},
                  {"trial_index", "", "place in the participant's order"},
                  {"scene", "", "name of the scene"},
                  {"artifact", "", "which question the depth mesh answered wrongly"},
                  {"object", "", "name of the object that was inserted"},
                  {"condition", "", "name of the condition; empty where the study has one"},
                  {"start_level", unit, quantity + " with which the match began"},
                  {"matched_level", unit, quantity + " at which the seam was just seen"},
                  {"began_clear", "", "1 where it began in the half of the levels that shows more"},
                  {"at_end", "", "1 where it ended at the first or the last level"},
                  {"steps", "", "presses towards clearer or fainter; 0 of simulated people"},
                  {"answer_s", "s", "from the picture's onset to the answer"}},
      .rows = {}};
  for (const MatchRecord& m : matches)
    table.rows.push_back({m.participant, std::int64_t{m.trial_index}, m.scene, std::string(word(m.artifact)),
                          m.object, m.condition, m.start_level, m.level, std::int64_t{m.began_clear ? 1 : 0},
                          std::int64_t{m.at_end ? 1 : 0}, std::int64_t{m.steps}, m.answer_s});
  return table;
}

}  // namespace seamline::study
