#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/foresight/simulated_answers.h"
#include "analysis/joint/joint_quantities.h"

namespace seamline::analysis {

/// A threshold that a plan can be asked for.
struct PlannedQuantity {
  std::string_view word;  ///< as asked for
  std::string_view name;  ///< as printed
  JointQuantity joint = JointQuantity::perceptual;
  SoughtMean sought = {};  ///< the mean that reaches which level there

  [[nodiscard]] bool corrected() const { return sought.mean == JointMean::seen; }  ///< for guessing
};
inline constexpr std::array<PlannedQuantity, 5> every_planned_quantity = {
    {{"PT", "PT", JointQuantity::perceptual, {JointMean::as_counted, 0.5}},
     {"SN", "SN", JointQuantity::slightly_noticeable, {JointMean::as_counted, 1.0}},
     {"corrected-PT", "corrected PT", JointQuantity::perceptual_corrected, {JointMean::seen, 0.5}},
     {"corrected-SN", "corrected SN", JointQuantity::slightly_noticeable_corrected, {JointMean::seen, 1.0}},
     {"detection", "detection", JointQuantity::detection, {JointMean::detected, 0.5}}}};

/// What the intervals are wanted of: a threshold of a curve, or how much further it lies than the same
/// threshold of another.
struct PlanTarget {
  PlannedQuantity quantity;
  std::size_t curve = 0;
  std::optional<std::size_t> against = {};
  double truth_x = 0;  ///< of the assumed people, in x of LevelAxis
};

/// What is asked for, in the words of the command line. Empty lists: PT and SN (detection where nobody is
/// asked for ratings), every artifact and condition, no difference.
struct WantedTargets {
  std::vector<std::string> quantities = {};
  std::vector<std::string> artifacts = {}, conditions = {};
  std::vector<std::string> differences = {};  ///< "A:B": of artifacts or of conditions, B less A
  bool differences_alone = false;             ///< thresholds themselves are not wanted
  /// How much further the thresholds of B lie than those of A, whatever the study file says of B's people.
  std::optional<double> stated_difference = {};
};

/// "SN of overlap in soft", "PT of overlap less that of receiver".
[[nodiscard]] std::string name_of(const PlanTarget& target, const std::vector<PlannedCurve>& curves);

/// The targets with their true values. A stated difference moves the midpoints of `curves`. Throws InputError
/// at a word that names nothing of the study, and where nothing is left to want.
[[nodiscard]] std::vector<PlanTarget> plan_targets(const WantedTargets& wanted,
                                                   const PlannedPopulation& population,
                                                   std::vector<PlannedCurve>& curves);

}  // namespace seamline::analysis
