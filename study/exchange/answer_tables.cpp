#include "study/exchange/answer_tables.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "stimuli/definition/parts/task_definition.h"
#include "study/exchange/clip_records.h"
#include "study/exchange/exposure_records.h"
#include "study/exchange/look_records.h"
#include "study/exchange/match_records.h"
#include "study/exchange/slider_records.h"
#include "study/log/log.h"
#include "study/log/online/reading_languages.h"
#include "support/text/csv.h"

namespace seamline::study {

std::string place_words(const LogContents& log) {
  const int objects = facts_of(log.task.get()).objects;
  return objects == usual_objects ? "1 left, 2 middle, 3 right"
                                  : fmt::format("1 to {} from the left", objects);
}

std::string choice_words(const LogContents& log) {
  if (!log.own_tasks.empty()) return "which alternative of the condition's task was chosen, from 1";
  const TaskFacts task = facts_of(log.task.get());
  return fmt::format(
      "{}, 1 to {}",
      task.kind == TaskKind::object ? "which object was said to be inserted" : "which alternative was chosen",
      task.alternatives);
}

std::string correct_words(const LogContents& log) {
  if (!log.own_tasks.empty()) return "1 where that was the right one";
  return facts_of(log.task.get()).kind == TaskKind::object ? "1 where that is object_index"
                                                           : "1 where that was the right one";
}

namespace {

CsvTable table_of_poses(const std::vector<LookedTrial>& looks) {
  CsvTable table{.name = "poses",
                 .columns = {{"participant", "", "code of the participant"},
                             {"trial_index", "", "place in the participant's order, catch trials counted"},
                             {"time_s", "s", "from the picture's onset"},
                             {"yaw_deg", "degrees", "to the right of the scene camera's direction"},
                             {"pitch_deg", "degrees", "up from the horizon"}},
                 .rows = {}};
  const bool has_field = std::any_of(looks.begin(), looks.end(), [](const LookedTrial& one) {
    return std::any_of(one.poses.begin(), one.poses.end(),
                       [](const PoseAt& at) { return at.fov_deg.has_value(); });
  });
  if (has_field)
    table.columns.push_back(
        {"fov_deg", "degrees", "horizontal field of view; empty where keys cannot change it"});
  for (const LookedTrial& one : looks)
    for (const PoseAt& at : one.poses) {
      table.rows.push_back(
          {one.participant, std::int64_t{one.trial_index}, 1e-3 * at.ms, at.pose.yaw_deg, at.pose.pitch_deg});
      if (has_field)
        table.rows.back().push_back(at.fov_deg ? CsvValue(*at.fov_deg) : CsvValue(std::string()));
    }
  return table;
}

CsvTable table_of_comfort(const std::vector<ComfortAnswer>& answers) {
  CsvTable table{
      .name = "comfort",
      .columns = {{"participant", "", "code of the participant"},
                  {"answered", "trials", "answered before the break"},
                  {"comfort", "1 to 5", "the answer to comfort_question, its place in comfort_labels"}},
      .rows = {}};
  for (const ComfortAnswer& one : answers)
    table.rows.push_back({one.participant, std::int64_t{one.answered}, std::int64_t{one.comfort}});
  return table;
}

/// Of a study with panoramas two tables: `looks`, a row for each answer to a stimulus (degrees turned, first
/// look at the inserted object, share of time facing it), and `poses`, a row for each pose. Of others none.
std::vector<CsvTable> look_tables(const LogContents& log) {
  const std::vector<LookedTrial> looks = read_looks(log);
  if (looks.empty()) return {};
  CsvTable table{
      .name = "looks",
      .columns = {{"participant", "", "code of the participant"},
                  {"trial_index", "", "place in the participant's order, catch trials counted"},
                  {"stimulus_id", "", "as in the set's manifest"},
                  {"condition", "", "name of the condition; empty where the study has one"},
                  {"object_yaw_deg", "degrees",
                   "where the inserted object stands, to the right of the start"},
                  {"degrees_turned", "degrees", "sum of the angles between one pose and the next"},
                  {"first_look_s", "s",
                   "until the view first faced the object (15 degrees to either side); empty: never"},
                  {"share_facing", "", "share of the time until the rating in which it did"}},
      .rows = {}};
  for (const auto& [place, yaw_deg, made] : measured_looks(log, looks)) {
    const Answer& answer = log.answers[place];
    table.rows.push_back({answer.participant, std::int64_t{answer.trial_index}, answer.stimulus_id,
                          answer.condition, yaw_deg, made.degrees_turned,
                          made.first_look_s ? CsvValue(*made.first_look_s) : CsvValue(std::string()),
                          made.share_facing});
  }
  std::vector<CsvTable> tables = {std::move(table), table_of_poses(looks)};
  if (const std::vector<ComfortAnswer> answers = read_comfort(log); !answers.empty())
    tables.push_back(table_of_comfort(answers));
  return tables;
}

CsvValue whole(std::int64_t value) {
  return value;
}
CsvValue yes_or_no(bool value) {
  return std::int64_t{value ? 1 : 0};
}
CsvValue as_text(std::string_view value) {
  return std::string(value);
}
CsvValue in_seconds(std::int64_t time_ns) {
  return 1e-9 * time_ns;
}

CsvTable table_of_answers(const LogContents& log) {
  CsvTable table{
      .name = "answers",
      .columns = {{"participant", "", "code of the participant, as in the table of participants"},
                  {"trial_index", "", "place in the participant's order, catch trials counted, from 0"},
                  {"stimulus_id", "", "as in the set's manifest"},
                  {"scene", "", "name of the scene"},
                  {"artifact", "", "which question the depth mesh answered wrongly"},
                  {"object", "", "name of the object that was inserted"},
                  {"object_index", "", "where it stood: " + place_words(log)},
                  {"condition", "", "name of the condition; empty where the study has one"},
                  {"level", std::string(facts(log.quantity).unit), std::string(facts(log.quantity).name)},
                  {"chosen_index", "", choice_words(log)},
                  {"correct", "", correct_words(log)},
                  {"rating", "", "how noticeable, 1 slightly to 4 extremely"},
                  {"noticeability", "", "0 where the choice is wrong, else the rating"},
                  {"choice_s", "s", "from the picture's onset to the choice"},
                  {"rating_s", "s", "from the picture's onset to the rating"},
                  {"image_scale", "", "screen pixels a picture pixel"}},
      .rows = {}};
  for (const Answer& a : log.answers)
    table.rows.push_back({as_text(a.participant), whole(a.trial_index), as_text(a.stimulus_id),
                          as_text(a.scene), as_text(word(a.artifact)), as_text(a.object),
                          whole(a.object_index), as_text(a.condition), a.level, whole(a.chosen_index),
                          yes_or_no(a.correct()), whole(a.rating), whole(a.noticeability()),
                          in_seconds(a.choice_ns), in_seconds(a.rating_ns), a.image_scale});
  if (log.own_tasks.empty()) return table;
  table.columns.push_back({"task", "", "what the condition asks: a kind of task"});
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    table.rows[row].push_back(as_text(word(facts_of(task_of(log, log.answers[row].condition).get()).kind)));
  return table;
}

CsvTable table_of_catches(const LogContents& log) {
  CsvTable table{
      .name = "catch_answers",
      .columns = {{"participant", "", "code of the participant, as in the table of participants"},
                  {"trial_index", "", "place in the participant's order, from 0"},
                  {"kind", "", "attention: an insertion nobody can miss; reference: nothing inserted"},
                  {"scene", "", "name of the scene"},
                  {"right_index", "",
                   log.own_tasks.empty() ? fmt::format("1 to {}; 0 where nothing is right",
                                                       facts_of(log.task.get()).alternatives)
                                         : "from 1; 0 where nothing is right"},
                  {"chosen_index", "", choice_words(log)},
                  {"correct", "", "1 where that is right_index"},
                  {"rating", "", "how noticeable, 1 slightly to 4 extremely"},
                  {"choice_s", "s", "from the picture's onset to the choice"},
                  {"rating_s", "s", "from the picture's onset to the rating"}},
      .rows = {}};
  for (const CatchTrialAnswer& c : log.catches)
    table.rows.push_back({as_text(c.participant), whole(c.trial_index), as_text(word(c.kind)),
                          as_text(c.scene), whole(c.right_index), whole(c.chosen_index), yes_or_no(c.right()),
                          whole(c.rating), in_seconds(c.choice_ns), in_seconds(c.rating_ns)});
  return table;
}

CsvTable table_of_participants(const LogContents& log) {
  CsvTable table{.name = "participants",
                 .columns = {{"participant", "", "code of the participant"},
                             {"origin", "", "window, serve, static or jatos"},
                             {"completed", "", "1: all trials are answered"},
                             {"excluded", "", "1: marked as excluded in the log"},
                             {"pilot", "", "1: a trial run"},
                             {"simulated", "", "1: no person"},
                             {"observer", "", "kind of the simulated observer; empty for a person"},
                             {"slot", "", "which order of trials"},
                             {"restarts", "", "how often earlier answers were set aside"}},
                 .rows = {}};
  std::set<std::string> fields;
  for (const ParticipantRecord& participant : log.participants)
    for (const FormAnswer& answer : participant.form) fields.insert(answer.field);
  for (const std::string& field : fields)
    table.columns.push_back({"form_" + field, "", "answer to this question of the form; empty: none"});
  for (const ParticipantRecord& p : log.participants) {
    std::vector<CsvValue> row = {as_text(p.code),       as_text(word(p.origin)), yes_or_no(p.completed),
                                 yes_or_no(p.excluded), yes_or_no(p.pilot),      yes_or_no(p.simulated),
                                 as_text(p.observer),   whole(p.slot),           whole(p.restarts)};
    for (const std::string& field : fields) {
      std::string value;
      for (const FormAnswer& answer : p.form)
        if (answer.field == field) value = answer.value;
      row.emplace_back(value);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

CsvTable without_order(CsvTable table, const Anonymity& anonymity) {
  // Which catch trials somebody had follows from their order, as `trial_index` does from `slot`.
  std::set<std::string> hidden = {"slot", "restarts", "trial_index", "image_scale"};
  if (!anonymity.keeps_origin) hidden.insert("origin");
  if (table.name == "catch_answers") hidden.insert({"scene", "right_index", "chosen_index"});
  for (std::size_t i = table.columns.size(); i-- > 0;) {
    if (!hidden.contains(table.columns[i].name)) continue;
    const auto at = static_cast<std::ptrdiff_t>(i);
    table.columns.erase(table.columns.begin() + at);
    for (std::vector<CsvValue>& row : table.rows) row.erase(row.begin() + at);
  }
  return table;
}

namespace {

/// A column only where the study has several languages. Few people may share one, so that it is in no
/// anonymised table.
void add_languages(const LogContents& log, CsvTable& participants) {
  std::error_code error;
  if (!std::filesystem::exists(log.file, error)) return;
  const std::map<std::string, std::string> languages = reading_languages(log.file);
  if (languages.empty()) return;
  participants.columns.push_back(
      {"language", "", "in which the study was read, as a tag of BCP 47; empty: not said"});
  for (std::size_t i = 0; i < log.participants.size(); ++i) {
    const auto found = languages.find(log.participants[i].code);
    participants.rows[i].push_back(found == languages.end() ? CsvValue() : CsvValue(found->second));
  }
}

/// To the tables of answers and of catch answers.
void add_slider_column(const LogContents& log, const std::optional<Anonymity>& anonymity,
                       std::vector<CsvTable>& tables) {
  const SliderColumn slider = slider_column(log, anonymity);
  if (slider.columns.empty()) return;
  const auto add = [&](CsvTable& table, const std::vector<CsvValue>& cells) {
    table.columns.push_back(slider.columns.front());
    for (std::size_t i = 0; i < cells.size(); ++i) table.rows[i].push_back(cells[i]);
  };
  add(tables[0], slider.of_answers);
  add(tables[1], slider.of_catches);
}

}  // namespace

std::vector<CsvTable> answer_tables(const LogContents& log, const std::optional<Anonymity>& anonymity) {
  std::vector<CsvTable> tables = {table_of_answers(log), table_of_catches(log), table_of_participants(log)};
  if (!anonymity) add_languages(log, tables.back());
  add_clip_columns(log, anonymity, tables.front());
  if (!anonymity)
    add_exposure_columns(log, tables.front());  // how a computer shows pictures may tell whose it is
  add_slider_column(log, anonymity, tables);
  if (anonymity)
    for (CsvTable& table : tables) table = without_order(std::move(table), *anonymity);
  else  // how somebody moves may tell who it is
    for (CsvTable& table : look_tables(log)) tables.push_back(std::move(table));
  if (!anonymity)
    if (std::optional<CsvTable> matches = match_table(log)) tables.push_back(*std::move(matches));
  tables.push_back(data_dictionary(tables));
  return tables;
}

}  // namespace seamline::study
