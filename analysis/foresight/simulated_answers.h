#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/foresight/assumed_people.h"

namespace seamline::analysis {

inline constexpr Eigen::Index counts_of_planned_cell = 8;  ///< right answers rated 1..4, then wrong ones

/// All answers of a simulated study of constant stimuli. A smaller study is its first people.
struct SimulatedAnswers {
  std::vector<double> level_x;  ///< rising: x of LevelAxis of the levels shown
  /// People x (curves x levels x `counts_of_planned_cell`): how often each answer was given.
  Eigen::MatrixXd counts;

  [[nodiscard]] Eigen::Index first_count(std::size_t curve, std::size_t level) const {
    return static_cast<Eigen::Index>(curve * level_x.size() + level) * counts_of_planned_cell;
  }
};

/// `levels` in the order of `comes_before`, each on the axis. Person p draws from stream `first_stream` + p.
[[nodiscard]] SimulatedAnswers simulate_answers(const PlannedPopulation& population,
                                                const std::vector<PlannedCurve>& curves,
                                                const std::vector<double>& levels, int people,
                                                std::uint64_t seed, std::uint64_t first_stream);

/// Mean noticeability of the first people at each level of a curve, people x levels; with `guess_rating`, the
/// mean rating of guesses, of formula scores instead, in which a guesser's mean is 0: the rating when right,
/// minus half the mean rating of a guess when wrong.
[[nodiscard]] Eigen::MatrixXd scores_of(const SimulatedAnswers& answers, std::size_t curve, int people,
                                        std::optional<double> guess_rating);

/// The mean rating of the first people's wrong answers, which can only be guesses; 1 where there is none.
[[nodiscard]] double mean_guess_rating(const SimulatedAnswers& answers, int people);

}  // namespace seamline::analysis
