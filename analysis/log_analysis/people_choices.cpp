#include "analysis/log_analysis/people_choices.h"

#include <cmath>

#include "analysis/psychometric/intervals/fit_intervals.h"
#include "analysis/psychometric/intervals/pooled_fit.h"
#include "stimuli/definition/parts/task_definition.h"

namespace seamline::analysis {
namespace {

OwnThreshold own_threshold(const PooledChoices& choices, Eigen::Index row, const FitOptions& options,
                           const std::string& unit) {
  OwnThreshold own;
  own.participant = choices.people[row];
  std::vector<LevelCounts> counts;
  double right = 0;
  for (std::size_t i = 0; i < choices.level.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    counts.push_back({.level = choices.level[i],
                      .correct = std::llround(choices.correct(row, column)),
                      .trials = std::llround(choices.trials(row, column))});
    own.answers += static_cast<int>(counts.back().trials);
    right += choices.correct(row, column);
  }
  own.right_share = own.answers > 0 ? right / own.answers : 0;
  const PsychometricFit fit = fit_psychometric(counts, options);
  const ThresholdFinding found =
      judge_threshold(fit, fit.levels.size() >= 2 ? threshold_interval(fit) : Interval{}, unit);
  own.threshold = found.estimate;
  own.ci95 = found.ci95;
  own.verdict = found.verdict;
  return own;
}

}  // namespace

FitOptions options_of_choices(const Analysis& analysis) {
  FitOptions options;
  options.guess = fixed_rate(analysis.scores.guess_rate);
  options.axis = facts(analysis.data.axis.quantity).axis;
  options.direction = analysis.data.axis.noticeability;
  return options;
}

std::vector<OwnThreshold> own_thresholds(const Analysis& analysis) {
  std::vector<OwnThreshold> rows;
  const TaskDefinition* task = analysis.log.task.get();
  if (task == nullptr || (task->repetitions < 2 && !task->staircase)) return rows;
  std::vector<std::string> codes;
  for (const ParticipantUse& person : analysis.people)
    if (person.use == Use::used) codes.push_back(person.record.code);
  const LevelAxis& axis = analysis.data.axis;
  const std::string unit(facts(axis.quantity).unit);
  const FitOptions options = options_of_choices(analysis);
  for (const ArtifactScores& scores : analysis.data.artifacts) {
    const PooledChoices choices = pooled_choices(analysis.log, codes, scores.artifact, scores.condition);
    for (Eigen::Index row = 0; row < choices.correct.rows(); ++row) {
      rows.push_back(own_threshold(choices, row, options, unit));
      rows.back().artifact = scores.artifact;
      rows.back().condition = scores.condition;
    }
  }
  return rows;
}

}  // namespace seamline::analysis
