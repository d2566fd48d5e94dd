#pragma once
#include <functional>

#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/stability_case.h"
#include "laboratory/stability/light/gltf_scene.h"
#include "raytracer/scene/truth_scene.h"

namespace seamline::stability {

/// How a scene's files become a scene; the product's is `load_truth_scene`.
using LoadRule = std::function<TruthScene(const SceneDefinition& definition, int width_px, int height_px)>;

/// The same furnished corner, from files, with and without the root node's scale and translation (which the
/// object's placement follows): composite through a depth map of 256 px, all questions answered by it. The
/// error is the root mean square difference of the two pictures over the picture's own estimated noise.
[[nodiscard]] Finding try_root_node(const RootNode& root, int threads,
                                    const LoadRule& load = load_truth_scene);

}  // namespace seamline::stability
