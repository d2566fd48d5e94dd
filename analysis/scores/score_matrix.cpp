#include "analysis/scores/score_matrix.h"

#include <algorithm>
#include <map>

#include "analysis/scores/cells.h"
#include "stimuli/definition/parts/task_definition.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

ScoredStimulus stimulus_of(const study::Answer& answer, const std::vector<std::string>& conditions) {
  const auto condition = std::find(conditions.begin(), conditions.end(), answer.condition);
  return {.artifact = answer.artifact,
          .condition_index = static_cast<int>(condition - conditions.begin()),
          .condition = answer.condition,
          .level = answer.level,
          .scene = answer.scene,
          .object_index = answer.object_index,
          .object = answer.object};
}

/// Of a task that asks for yes or no, the share of false alarms.
double guess_rate_of(const study::LogContents& log) {
  const TaskFacts task = facts_of(log.task.get());
  if (!task.right_is_yes) return task.chance;
  double yes = 0.5, all = 1;
  for (const study::CatchTrialAnswer& answer : log.catches) {
    if (answer.kind != study::TrialKind::reference) continue;
    ++all;
    if (answer.chosen_index == 1) ++yes;
  }
  return yes / all;
}

}  // namespace

ScoreMatrix score_matrix(const study::LogContents& log, const std::vector<ParticipantUse>& people,
                         const std::vector<std::string>& order) {
  const std::vector<std::string> conditions = conditions_of(log, order);
  ScoreMatrix matrix;
  std::map<std::string, Eigen::Index> row_of;
  for (const ParticipantUse& person : people)
    if (person.use == Use::used) {
      row_of[person.record.code] = static_cast<Eigen::Index>(matrix.people.size());
      matrix.people.push_back(person.record.code);
    }
  std::map<ScoredStimulus, Eigen::Index> column_of;
  for (const study::Answer& answer : log.answers)
    if (row_of.contains(answer.participant)) column_of[stimulus_of(answer, conditions)] = 0;
  for (auto& [stimulus, column] : column_of) {
    column = static_cast<Eigen::Index>(matrix.stimuli.size());
    const bool same_cell = !matrix.stimuli.empty() && matrix.stimuli.back().artifact == stimulus.artifact &&
                           matrix.stimuli.back().condition_index == stimulus.condition_index &&
                           matrix.stimuli.back().level == stimulus.level;
    const int last = matrix.cell.empty() ? -1 : matrix.cell.back();
    matrix.cell.push_back(same_cell ? last : last + 1);
    matrix.stimuli.push_back(stimulus);
  }

  const auto rows = static_cast<Eigen::Index>(matrix.people.size()),
             columns = static_cast<Eigen::Index>(matrix.stimuli.size());
  Eigen::MatrixXd answers = Eigen::MatrixXd::Zero(rows, columns);
  matrix.score = Eigen::MatrixXd::Zero(rows, columns);
  for (const study::Answer& answer : log.answers) {
    const auto row = row_of.find(answer.participant);
    if (row == row_of.end()) continue;
    const Eigen::Index column = column_of.at(stimulus_of(answer, conditions));
    matrix.score(row->second, column) += answer.noticeability();
    answers(row->second, column) += 1;
    matrix.answers.push_back({.person = static_cast<int>(row->second),
                              .stimulus = static_cast<int>(column),
                              .score = answer.noticeability()});
  }
  matrix.guess_rate = guess_rate_of(log);
  matrix.score = (answers.array() > 0)
                     .select(matrix.score.array() / answers.array().max(1),
                             Eigen::ArrayXXd::Constant(rows, columns, nan));
  return matrix;
}

}  // namespace seamline::analysis
