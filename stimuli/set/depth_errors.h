#pragma once
#include <optional>
#include <string>
#include <vector>

#include "stimuli/set/manifest.h"

namespace seamline::inline stimuli {

/// How far the estimated depth of a scene is from the truth at one level of a condition: the mean over its
/// stimuli.
struct LevelDepthError {
  std::string scene, condition;  ///< the condition's name, empty where the study has one
  Quantity quantity = Quantity::estimate_share;
  double level = 0;
  DepthErrorRecord error;
  int stimuli = 0;
};

/// Of a set, in its order; empty where no depth is estimated.
[[nodiscard]] std::vector<LevelDepthError> depth_errors_of_set(const Manifest& manifest);

/// "AbsRel 0.031, RMSE 0.12 m, delta < 1.25 99.1 %".
[[nodiscard]] std::string depth_error_text(const DepthErrorRecord& error);

/// A sentence for each scene and condition: the errors at each level.
[[nodiscard]] std::vector<std::string> sentences(const std::vector<LevelDepthError>& errors);

/// What a level of `estimate_share` is in the words of depth estimation: the mean over the scenes of a
/// condition, linear between the levels of the set, exact at 0. None where the levels are of another quantity
/// or end before.
[[nodiscard]] std::optional<DepthErrorRecord> depth_error_at(const std::vector<LevelDepthError>& errors,
                                                             const std::string& condition, double level);

}  // namespace seamline::inline stimuli
