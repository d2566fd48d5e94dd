#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "stimuli/definition/parts/task_definition.h"
#include "study/exchange/answer_tables.h"
#include "study/exchange/clip_records.h"
#include "study/exchange/dataset.h"
#include "study/exchange/slider_records.h"
#include "support/files/assets.h"
#include "support/text/csv.h"
#include "support/text/printable.h"

namespace seamline::study {
namespace {

using BidsJson = nlohmann::ordered_json;
using BehRow = std::vector<CsvValue>;

std::string bids_json_text(const BidsJson& json) {
  return json.dump(2, ' ', false, BidsJson::error_handler_t::replace) + "\n";
}

CsvValue whole_cell(std::int64_t value) {
  return value;
}
CsvValue time_cell(std::int64_t time_ns) {
  return 1e-9 * time_ns;
}

/// What the column of places means.
std::string right_words(const LogContents& log) {
  if (log.own_tasks.empty() && facts_of(log.task.get()).kind == TaskKind::object)
    return "the right choice: " + place_words(log) + "; 0: nothing is right";
  return "the object's place: " + place_words(log) +
         "; of catch trials the right choice, 0: nothing is right";
}

std::string task_sentence(const LogContents& log) {
  if (!log.own_tasks.empty()) return "Say what the trial's condition asks for";
  const TaskFacts task = facts_of(log.task.get());
  if (task.kind != TaskKind::object) return usual_texts(*log.task).question;
  return fmt::format("Say which of {} objects was inserted{}", number_word(task.objects),
                     task.rates ? ", and how noticeable it is" : "");
}

CsvTable empty_beh_table(const LogContents& log) {
  return {.name = "beh",
          .columns = {{"trial_index", "", "place in the participant's order, from 0"},
                      {"trial_type", "",
                       "stimulus; attention: an insertion nobody can miss; reference: nothing inserted"},
                      {"stimulus_id", "", "as in the set's manifest"},
                      {"scene", "", "name of the scene"},
                      {"artifact", "", "which question the depth mesh answered wrongly"},
                      {"object", "", "name of the object that was inserted"},
                      {"object_index", "", right_words(log)},
                      {"condition", "", "name of the condition, where the study has several"},
                      {"level", std::string(facts(log.quantity).unit), std::string(facts(log.quantity).name)},
                      {"chosen_index", "", choice_words(log)},
                      {"correct", "", correct_words(log)},
                      {"rating", "", "how noticeable, 1 slightly to 4 extremely"},
                      {"noticeability", "", "0 where the choice is wrong, else the rating; of stimuli alone"},
                      {"response_time", "s", "from the picture's onset to the choice"},
                      {"rating_time", "s", "from the picture's onset to the rating"},
                      {"image_scale", "", "screen pixels a picture pixel"}},
          .rows = {}};
}

BehRow beh_row(const Answer& a) {
  return {whole_cell(a.trial_index),
          std::string("stimulus"),
          a.stimulus_id,
          a.scene,
          std::string(word(a.artifact)),
          a.object,
          whole_cell(a.object_index),
          a.condition,
          a.level,
          whole_cell(a.chosen_index),
          whole_cell(a.correct() ? 1 : 0),
          whole_cell(a.rating),
          whole_cell(a.noticeability()),
          time_cell(a.choice_ns),
          time_cell(a.rating_ns),
          a.image_scale};
}

BehRow beh_row(const CatchTrialAnswer& c, bool is_anonymous) {
  const CsvValue none;
  const auto unless_anonymous = [&](CsvValue value) { return is_anonymous ? none : std::move(value); };
  return {whole_cell(c.trial_index),
          std::string(word(c.kind)),
          none,
          unless_anonymous(c.scene),
          none,
          none,
          unless_anonymous(whole_cell(c.right_index)),
          none,
          none,
          unless_anonymous(whole_cell(c.chosen_index)),
          whole_cell(c.right() ? 1 : 0),
          whole_cell(c.rating),
          none,
          time_cell(c.choice_ns),
          time_cell(c.rating_ns),
          none};
}

/// The trials of each participant, in their order. `clips`: how the clips of answers were shown; `slider`:
/// where it stood.
std::map<std::string, std::vector<BehRow>> rows_by_participant(const LogContents& log,
                                                               const ClipColumns& clips,
                                                               const SliderColumn& slider,
                                                               bool is_anonymous) {
  std::map<std::string, std::vector<BehRow>> rows;
  for (std::size_t i = 0; i < log.answers.size(); ++i) {
    BehRow row = beh_row(log.answers[i]);
    if (!clips.rows.empty()) row.insert(row.end(), clips.rows[i].begin(), clips.rows[i].end());
    if (!slider.columns.empty()) row.push_back(slider.of_answers[i]);
    rows[log.answers[i].participant].push_back(std::move(row));
  }
  for (std::size_t i = 0; i < log.catches.size(); ++i) {
    const CatchTrialAnswer& answer = log.catches[i];
    BehRow row = beh_row(answer, is_anonymous);
    row.resize(row.size() + clips.columns.size());
    if (!slider.columns.empty()) row.push_back(slider.of_catches[i]);
    rows[answer.participant].push_back(std::move(row));
  }
  for (auto& [participant, trials] : rows)
    std::stable_sort(trials.begin(), trials.end(), [](const BehRow& a, const BehRow& b) {
      return std::get<std::int64_t>(a.front()) < std::get<std::int64_t>(b.front());
    });
  return rows;
}

BidsJson columns_json(const CsvTable& table) {
  BidsJson json = BidsJson::object();
  for (const CsvColumn& column : table.columns) {
    BidsJson& entry = json[clean_text(column.name)];
    entry["Description"] = column.meaning;
    if (!column.unit.empty()) entry["Units"] = column.unit;
  }
  return json;
}

CsvTable participants_table(const LogContents& log, const std::vector<std::string>& subjects,
                            const std::optional<Anonymity>& anonymity) {
  CsvTable table = std::move(answer_tables(log, anonymity)[2]);
  table.columns.front() = {"code", "", "code of the participant in the log"};
  table.columns.insert(table.columns.begin(), {"participant_id", "", "name of the participant's folder"});
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    table.rows[i].insert(table.rows[i].begin(), subjects[i]);
  return table;
}

}  // namespace

std::vector<DatasetFile> bids_files(const LogContents& log, const std::optional<Anonymity>& anonymity) {
  const std::string task = file_label(log.study_name);
  const auto digits = std::max<std::size_t>(3, std::to_string(log.participants.size()).size());
  std::vector<std::string> subjects;
  for (std::size_t i = 0; i < log.participants.size(); ++i)
    subjects.push_back(fmt::format("sub-{:0{}}", i + 1, digits));

  std::vector<DatasetFile> files;
  CsvTable beh = empty_beh_table(log);
  const ClipColumns clips = clip_columns(log, anonymity);
  beh.columns.insert(beh.columns.end(), clips.columns.begin(), clips.columns.end());
  const SliderColumn slider = slider_column(log, anonymity);
  beh.columns.insert(beh.columns.end(), slider.columns.begin(), slider.columns.end());
  std::map<std::string, std::vector<BehRow>> rows =
      rows_by_participant(log, clips, slider, anonymity.has_value());
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    beh.rows = std::move(rows[log.participants[i].code]);
    files.push_back({fmt::format("{0}/beh/{0}_task-{1}_beh.tsv", subjects[i], task),
                     tsv_text(anonymity ? without_order(beh, *anonymity) : beh)});
  }
  if (anonymity) beh = without_order(std::move(beh), *anonymity);
  BidsJson sidecar = {{"TaskName", task}, {"TaskDescription", task_sentence(log)}};
  sidecar.update(columns_json(beh));
  files.push_back({fmt::format("task-{}_beh.json", task), bids_json_text(sidecar)});

  const CsvTable people = participants_table(log, subjects, anonymity);
  files.push_back({"participants.tsv", tsv_text(people)});
  files.push_back({"participants.json", bids_json_text(columns_json(people))});
  files.push_back(
      {"dataset_description.json",
       bids_json_text({{"Name", clean_text(log.study_name)},
                       {"BIDSVersion", "1.9.0"},
                       {"DatasetType", "raw"},
                       {"GeneratedBy", {{{"Name", "Seamline"}, {"Version", program_version()}}}}})});
  files.push_back({"README", dataset_readme(log, "BIDS 1.9 (behaviour alone)", anonymity)});
  files.push_back({"CHANGES", fmt::format("1.0.0\n\n  - Written by Seamline {}.\n", program_version())});
  return files;
}

}  // namespace seamline::study
