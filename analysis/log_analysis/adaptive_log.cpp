#include "analysis/log_analysis/adaptive_log.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "analysis/joint/joint_placed.h"
#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/study_file/parts/study_file_task.h"
#include "study/running/staircase_results.h"
#include "support/text/numbers.h"

namespace seamline::analysis {
namespace {

void give_reason(CurveThresholds& estimates, NoThreshold reason) {
  for (ThresholdEstimate* width :
       {&estimates.perceptual, &estimates.slightly_noticeable, &estimates.inflection})
    width->reason = reason;
}

/// Answers as they were given: shares of objects that are evened out would be no likelihood.
JointData placed_data(const Analysis& analysis) {
  JointData data;
  const TaskFacts task = facts_of(analysis.log.task.get());
  data.ratings = task.rates ? most_joint_ratings : 1;
  const LevelAxis& axis = analysis.data.axis;
  std::map<std::string, Eigen::Index> row_of;
  for (const ParticipantUse& person : analysis.people) {
    if (person.use != Use::used) continue;
    row_of[person.record.code] = static_cast<Eigen::Index>(data.people.size());
    data.people.push_back(person.record.code);
  }
  std::map<std::tuple<Artifact, std::string, double>, Eigen::Index> cell_of;
  for (const ArtifactScores& scores : analysis.data.artifacts) {
    for (const double level : scores.level) {
      cell_of[{scores.artifact, scores.condition, level}] = static_cast<Eigen::Index>(data.cells.size());
      data.cells.push_back({.curve = static_cast<int>(data.curves.size()),
                            .x = stands_apart(axis, level) ? infinity : x_of(axis, level),
                            .chance = analysis.scores.guess_rate});
    }
    data.curves.push_back(std::string(word(scores.artifact)) + in_condition(scores.condition));
  }
  const auto people = static_cast<Eigen::Index>(data.people.size());
  data.answers =
      Eigen::MatrixXd::Zero(people, static_cast<Eigen::Index>(data.cells.size()) * data.cell_counts());
  data.references = Eigen::MatrixXd::Zero(people, data.ratings);
  for (const study::Answer& answer : analysis.log.answers) {
    const auto row = row_of.find(answer.participant);
    const auto cell = cell_of.find({answer.artifact, answer.condition, answer.level});
    if (row == row_of.end() || cell == cell_of.end()) continue;
    data.answers(row->second, cell->second * data.cell_counts() + (answer.correct() ? 0 : data.ratings) +
                                  std::min(answer.rating, data.ratings) - 1) += 1;
  }
  const bool says_something = task.rates || task.right_is_yes;  // as in `joint_data`
  for (const ReferenceAnswer& reference : analysis.options.references)
    if (const auto row = row_of.find(reference.participant); says_something && row != row_of.end())
      data.references(row->second, std::min(reference.rating, data.ratings) - 1) += 1;
  return data;
}

}  // namespace

JointAnalysis analyze_placed(const Analysis& analysis, const JointRequest& request) {
  JointAnalysis joint;
  joint.axis = analysis.data.axis;
  for (const ArtifactScores& scores : analysis.data.artifacts)
    joint.labels.push_back(
        {.artifact = std::string(word(scores.artifact)), .condition = scores.condition, .group = {}});
  joint.data = placed_data(analysis);
  SharedFit shared = fit_shared(joint.data, request.sharing, request.sharing_tested, fit_placed);
  joint.fit = std::move(shared.fit);
  joint.sharing = std::move(shared.tests);
  joint.refused_sharing = std::move(shared.refused);
  if (joint.fit.estimated())
    joint.left_out = leave_placed_people_out(joint.fit, joint.data, analysis.resampling.threads);
  joint.thresholds = joint_thresholds(joint.fit, joint.data, joint.left_out);
  for (JointThreshold& threshold : joint.thresholds)
    if (joint.fit.estimated() && threshold.quantity == JointQuantity::inflection)
      threshold.here.reason = NoThreshold::no_inflection;
  if (joint.fit.estimated()) joint.people.shift_sd = std::exp(joint.fit.theta[joint.fit.model.log_between()]);
  return joint;
}

bool is_adaptive(const std::optional<StudyDefinition>& study) {
  return study && is_placed_by_answers(*study);
}

std::string adaptive_note(const study::LogContents& log) {
  return std::string("Levels were placed by the answers (") +
         (study::has_staircases(log) ? "staircases" : "QUEST+") +
         "), so means at a level are over different people and only describe the answers: the paper's way has no "
         "numbers. Thresholds are of the joint model with each person's own thresholds, over participants. "
         "'seamline log tracks LOG' prints those of each person.";
}

void set_aside_adaptive(Analysis& analysis) {
  for (ArtifactScores& scores : analysis.data.artifacts) {
    scores = {.artifact = scores.artifact,
              .condition = scores.condition,
              .axis = scores.axis,
              .level = scores.level,
              .people = {},
              .noticeability = {},
              .cells = {},
              .incomplete = {}};
    analysis.thresholds.push_back(estimate_thresholds(scores, analysis.resampling));
    give_reason(analysis.thresholds.back().estimates, NoThreshold::placed_by_answers);
  }
  analysis.sos = {.a = nan, .ci95_low = nan, .ci95_high = nan, .stimuli = 0};
}

}  // namespace seamline::analysis
