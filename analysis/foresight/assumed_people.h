#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/foresight/planned_task.h"
#include "analysis/joint/joint_mean_curve.h"
#include "analysis/scores/level_axis.h"
#include "stimuli/definition/study_definition.h"
#include "support/arithmetic/random.h"

namespace seamline::analysis {

/// What a plan assumes of people beyond the `threshold` observers of the study file. All 0: nothing, and the
/// answers are those observers', draw for draw. Lengths along the axis are octaves on log2 axes, and else in
/// the level's unit.
struct AssumedPeople {
  double lapse = 0;         ///< share of the trials in which a person does not look, and guesses
  double slope_sd = 0;      ///< standard deviation over people of ln of their scale
  double criteria_sd = 0;   ///< of how far a person's rating curve lies from their seeing curve
  double artifact_sd = 0;   ///< of a shift that each person has for each curve, beside their own
  double high_guesses = 0;  ///< share of the guesses rated 2 instead of 1
  /// How often people who see nothing say yes, in tasks that ask for that; none: as simulated people do.
  std::optional<double> false_alarms = {};

  bool operator==(const AssumedPeople&) const = default;
};

/// One curve of a plan: an artifact in a condition.
struct PlannedCurve {
  Artifact artifact = Artifact::none;
  std::string condition;  ///< empty where the study has one
  int objects = 0;        ///< shown at each level, each as often as the task repeats it
  double midpoint = 0;    ///< level at which the average person sees it half of the time
};

/// "overlap", "overlap in soft".
[[nodiscard]] std::string name_of(const PlannedCurve& curve);

/// Everybody who could be asked.
struct PlannedPopulation {
  ObserverDefinition observer;
  AssumedPeople assumed;
  LevelAxis axis;
  PlannedTask task = {};
};

/// A person: their own shifts and scale.
struct PlannedPerson {
  double shift = 0;  ///< along the axis, of the level at which half is seen
  double scale = 0;
  double rating_shift = 0;
  std::vector<double> curve_shift;  ///< one a curve; empty: none
};

[[nodiscard]] PlannedPerson draw_person(const PlannedPopulation& population, std::size_t curves,
                                        Random& random);

/// A choice and its rating.
struct PlannedAnswer {
  bool right = false;  ///< or yes
  int rating = 0;      ///< 1..4; 1 where none is asked for
};

/// Of somebody who sees nothing. `place` is the right alternative, from 0.
[[nodiscard]] PlannedAnswer guess_of(const PlannedPopulation& population, std::uint64_t place,
                                     Random& random);

[[nodiscard]] PlannedAnswer answer_of(const PlannedPopulation& population, const PlannedPerson& person,
                                      const std::vector<PlannedCurve>& curves, std::size_t curve,
                                      double level, std::uint64_t place, Random& random);

/// Mean noticeability over everybody at x of LevelAxis,
///
///     E = mean of (1 - l) P (1 + 3 Q) + (1 - (1 - l) P) b g,    P, Q = 1 / (1 + exp((x - m - shift) /
///     scale))
///
/// P with the person's shifts, Q (of the ratings) with their rating shift besides, l the lapses, b the chance
/// of the task, and g the mean rating of a guess. `seen` leaves out the second term, which is what guesses
/// add; `detected` the ratings, too, as a task without ratings does. By trapezoidal sums over normal
/// densities, whose error is under 1e-9.
[[nodiscard]] double mean_noticeability(const PlannedPopulation& population, const PlannedCurve& curve,
                                        double x, JointMean mean);

/// Shares of all answers at x that are right and rated 1 to K, then wrong and rated 1 to K (K of the task);
/// they sum to 1.
[[nodiscard]] Eigen::VectorXd answer_shares(const PlannedPopulation& population, const PlannedCurve& curve,
                                            double x);

/// x at which `mean_noticeability` equals a level, from its own values between the levels tested too.
[[nodiscard]] double true_crossing(const PlannedPopulation& population, const PlannedCurve& curve,
                                   double level, JointMean mean);

/// What is assumed of people, in sentences that a reader can question.
[[nodiscard]] std::string assumptions_text(const PlannedPopulation& population,
                                           const std::vector<PlannedCurve>& curves);

}  // namespace seamline::analysis
