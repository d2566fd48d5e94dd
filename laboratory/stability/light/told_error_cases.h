#pragma once
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/stability_case.h"
#include "raytracer/scene/truth_scene.h"
#include "stimuli/definition/artifact.h"

namespace seamline::stability {

/// What pictures of a scene's left object say of their own error beside the true one, over six seeds: the
/// error is how many times the larger of the two is the smaller, less one. Truth is the path estimator with
/// 1,024 samples a pixel of another seed, its own noise taken out.
[[nodiscard]] Finding try_told_error(const TruthScene& scene, Artifact artifact, int threads);

}  // namespace seamline::stability
