#pragma once
#include "raytracer/scene/truth_scene.h"
#include "renderer/depth/local_scene.h"
#include "renderer/estimators/estimator.h"
#include "renderer/estimators/stereo_depth.h"

namespace seamline::renderer {

/// The local scene of a stimulus of the object that the estimator has taken: its mesh from the truth without
/// that object, and what else the settings want of it, guided by and painted from the estimator's
/// photograph. `traces_rays`: see LocalSceneUse. `captured` is what the depth camera saw instead of the truth
/// as it is now; null: the truth. `stereo` keeps what was matched of
/// this scene without this object.
[[nodiscard]] LocalScene stimulus_scene(const TruthScene& scene, const SceneEstimator& estimator,
                                        const DepthSettings& settings, bool traces_rays, int threads,
                                        const Geometry* captured = nullptr, StereoMemory* stereo = nullptr);

}  // namespace seamline::renderer
