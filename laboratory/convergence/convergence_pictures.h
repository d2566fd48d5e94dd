#pragma once
#include "laboratory/convergence/convergence_subject.h"
#include "laboratory/convergence/estimates/estimates.h"

namespace seamline::renderer {

/// The subject's stimulus with masks, mattes and what is found in the photograph in place of depth, of rising
/// width: error of the picture.
[[nodiscard]] EstimateResult measure_mitigation(const ConvergenceSubject& subject);
/// The subject's scene with its object by the fast estimator's truth pass, bounce light filtered by each of
/// its strengths: error of the picture.
[[nodiscard]] EstimateResult measure_filter(const ConvergenceSubject& subject);

}  // namespace seamline::renderer
