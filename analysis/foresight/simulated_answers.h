#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/foresight/assumed_people.h"

namespace seamline::analysis {

/// All answers of a simulated study of constant stimuli. A smaller study is its first people.
struct SimulatedAnswers {
  std::vector<double> level_x;  ///< rising: x of LevelAxis of the levels shown
  PlannedTask task = {};
  /// People x (curves x levels x 2K): how often each answer was given, right ones rated 1..K, then wrong
  /// ones.
  Eigen::MatrixXd counts;
  /// People x K: ratings of the reference trials, where only they tell what chance is; else zeros.
  Eigen::MatrixXd references = {};
  Eigen::VectorXd false_alarms = {};  ///< of each person's reference trials; empty where there are none

  [[nodiscard]] Eigen::Index cell_counts() const { return 2 * Eigen::Index{task.ratings()}; }

  [[nodiscard]] Eigen::Index first_count(std::size_t curve, std::size_t level) const {
    return static_cast<Eigen::Index>(curve * level_x.size() + level) * cell_counts();
  }
};

/// `levels` in the order of `comes_before`, each on the axis. Person p draws from stream `first_stream` + p.
[[nodiscard]] SimulatedAnswers simulate_answers(const PlannedPopulation& population,
                                                const std::vector<PlannedCurve>& curves,
                                                const std::vector<double>& levels, int people,
                                                std::uint64_t seed, std::uint64_t first_stream);

/// How often somebody who sees nothing is right: the task's, or as the analysis takes it from the reference
/// trials of the first people, (false alarms + 1/2) / (trials + 1).
[[nodiscard]] double chance_of(const SimulatedAnswers& answers, int people);

/// Mean noticeability of the first people at each level of a curve, people x levels; with `guess_rating`, the
/// mean rating of guesses, of formula scores instead, in which a guesser's mean is 0: the rating when right,
/// minus b / (1 - b) times the mean rating of a guess when wrong, b being the chance.
[[nodiscard]] Eigen::MatrixXd scores_of(const SimulatedAnswers& answers, std::size_t curve, int people,
                                        std::optional<double> guess_rating);

/// The mean rating of the first people's wrong answers, which can only be guesses; 1 where there is none.
[[nodiscard]] double mean_guess_rating(const SimulatedAnswers& answers, int people);

}  // namespace seamline::analysis
