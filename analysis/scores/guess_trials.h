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
  int chosen_index = 0;  ///< from 1
  int rating = 0;        ///< 1..4
};

/// One point of a curve: an artifact at a level of a condition, all its objects.
struct GuessCell {
  Artifact artifact = Artifact::none;
  std::string condition;
  double level = 0;
};

/// How the counts of a cell lie in a row: right x chosen x rating, rating running fastest.
struct CellShape {
  int positions = usual_objects;  ///< to choose among, at least three; fewer leave counts of 0

  /// Chosen x rating.
  [[nodiscard]] constexpr int of_trial() const { return positions * study::highest_rating; }
  [[nodiscard]] constexpr int of_cell() const { return positions * of_trial(); }
  /// Place of an answer within its cell's counts. Indices as in the log, from 1.
  [[nodiscard]] constexpr int place(int right_index, int chosen_index, int rating) const {
    return (right_index - 1) * of_trial() + (chosen_index - 1) * study::highest_rating + (rating - 1);
  }
};
[[nodiscard]] constexpr CellShape cell_shape(const TaskFacts& task) {
  return {task.alternatives > usual_objects ? task.alternatives : usual_objects};
}

/// How often each participant gave each answer, which is all that the guessing model needs. Where objects or
/// repeats are not balanced an answer counts for less or more than 1, so that a person's objects weigh the
/// same within a cell and people weigh the same as each other, as in `average_answers`; the sum over a cell
/// is its number of answers. With balanced data every answer counts 1.
struct GuessTrials {
  std::vector<std::string> people;  ///< everybody on some artifact's curve, in the log's order
  std::vector<GuessCell> cells;     ///< artifacts in the order of the data, levels as on the curve
  Eigen::MatrixXd answers;          ///< people x (cells x `CellShape::of_cell`)
  Eigen::MatrixXd references;       ///< people x `CellShape::of_trial`
  TaskFacts task = {};              ///< what was asked

  [[nodiscard]] CellShape shape() const { return cell_shape(task); }
};

/// Counts the answers of the people on the curves of `data` (`average_answers` of the same log). References
/// of others are left out.
[[nodiscard]] GuessTrials count_guess_trials(const study::LogContents& log, const NoticeabilityData& data,
                                             const std::vector<ReferenceAnswer>& references);

}  // namespace seamline::analysis
