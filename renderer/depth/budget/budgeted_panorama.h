#pragma once
#include "renderer/depth/budget/budgeted_mesh.h"
#include "renderer/depth/panorama_chain.h"

namespace seamline::renderer {

/// As many samples as the uniform map of `settings.width_px` has, spent where depth jumps or (`budgeted`)
/// where `scene` says that wrong depth shows; where nothing of it would, the uniform map. They are chosen
/// from a map 16 times as wide, but of 2048 px at least and 4096 px at most, or twice as wide where that is
/// more. The map beside the mesh is what the mesh shows from the centre; it is empty unless asked for. Throws
/// InputError where the samples are too few.
[[nodiscard]] MeasuredPanorama budgeted_panorama(const ShownScene& scene, const DepthSettings& settings,
                                                 bool keeps_map);

/// The same with any number of samples.
[[nodiscard]] BudgetedMesh spend_samples(const Geometry& truth, std::int64_t samples,
                                         const ShownWeights* weights, double yaw_turns, int threads);

}  // namespace seamline::renderer
