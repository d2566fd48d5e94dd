#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/scores/cells.h"
#include "stimuli/definition/parts/task_definition.h"
#include "study/log/log.h"
#include "study/placement/trial.h"

namespace seamline::analysis {

/// An answer to a reference trial: nothing was inserted, so there was nothing to see and no right choice.
struct ReferenceAnswer {
  std::string participant;
  int chosen_index = 0;  ///< 1 left, 2 middle, 3 right
  int rating = 0;        ///< 1..4
};

/// One point of a curve: an artifact at a level of a condition, all its objects.
struct GuessCell {
  Artifact artifact = Artifact::none;
  std::string condition;
  double level = 0;
};

inline constexpr int answers_of_trial =
    study::objects_per_stimulus * study::highest_rating;  ///< chosen x rating, rating running fastest
inline constexpr int counts_of_cell =
    study::objects_per_stimulus * answers_of_trial;  ///< right x chosen x rating, rating running fastest

/// Place of an answer within its cell's counts. Indices as in the log, from 1.
[[nodiscard]] constexpr int count_place(int right_index, int chosen_index, int rating) {
  return (right_index - 1) * answers_of_trial + (chosen_index - 1) * study::highest_rating + (rating - 1);
}

/// How often each participant gave each answer, which is all that the guessing model needs. Where objects or
/// repeats are not balanced an answer counts for less or more than 1, so that a person's objects weigh the
/// same within a cell and people weigh the same as each other, as in `average_answers`; the sum over a cell
/// is its number of answers. With balanced data every answer counts 1.
struct GuessTrials {
  std::vector<std::string> people;  ///< everybody on some artifact's curve, in the log's order
  std::vector<GuessCell> cells;     ///< artifacts in the order of the data, levels as on the curve
  Eigen::MatrixXd answers;          ///< people x (cells x counts_of_cell)
  Eigen::MatrixXd references;       ///< people x answers_of_trial
  TaskFacts task = {};              ///< what was asked
};

/// Counts the answers of the people on the curves of `data` (`average_answers` of the same log). References
/// of others are left out.
[[nodiscard]] GuessTrials count_guess_trials(const study::LogContents& log, const NoticeabilityData& data,
                                             const std::vector<ReferenceAnswer>& references);

}  // namespace seamline::analysis
