#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/scores/guess_trials.h"
#include "analysis/scores/level_axis.h"
#include "analysis/thresholds/guess_model.h"

namespace seamline::analysis {

/// One point of a curve as the joint model sees it.
struct JointCell {
  int curve = 0;
  /// Place of the level on the axis on which curves fall (LevelAxis). Infinite: there was nothing to see.
  double x = 0;
  double chance = 1.0 / 3;  ///< probability that somebody who sees nothing is right there
};

inline constexpr int most_joint_ratings = 4;

/// What the joint model is fitted to: how often each person gave each answer. The answers themselves are not
/// needed, so a million of them cost no more than the table.
struct JointData {
  std::vector<std::string> curves;  ///< names: an artifact in a condition
  std::vector<std::string> people;
  std::vector<JointCell> cells;      ///< curves in order, levels of each from easy to hard to see
  int ratings = most_joint_ratings;  ///< K, 1 to 4; 1: nobody was asked for a rating
  /// People x (cells x 2K): of each cell right answers rated 1..K, then wrong ones rated 1..K.
  Eigen::MatrixXd answers;
  /// People x K: ratings where nothing was inserted. They say how guessers rate.
  Eigen::MatrixXd references;

  [[nodiscard]] Eigen::Index cell_counts() const { return 2 * static_cast<Eigen::Index>(ratings); }
};

/// Throws InputError, naming what differs, where sizes do not fit each other, a curve has no cell, a count is
/// negative or not finite, a chance lies outside (0, 1), or K outside 1..4.
void check_joint_data(const JointData& data);

/// The table of a log. The chance of a cell is the mean of the guessers' `position` over its right answers'
/// places, which is one in three where objects are balanced. `trials` are of the same log.
[[nodiscard]] JointData joint_data(const GuessTrials& trials, const LevelAxis& axis,
                                   const Guessers& guessers);

/// The same data of some of the people, by their rows.
[[nodiscard]] JointData of_people(const JointData& data, const std::vector<Eigen::Index>& rows);

/// x of a curve's levels, without one where there was nothing to see.
[[nodiscard]] std::vector<double> levels_of_curve(const JointData& data, int curve);

}  // namespace seamline::analysis
