#include "study/exchange/look_tables.h"

#include <algorithm>
#include <utility>

#include "study/exchange/look_records.h"

namespace seamline::study {
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

}  // namespace

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

}  // namespace seamline::study
