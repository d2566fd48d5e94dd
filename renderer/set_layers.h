#pragma once
#include <filesystem>

#include "renderer/composite.h"
#include "renderer/truth_scene.h"
#include "stimuli/stimulus.h"

namespace seamline {

/// Writes `SET/layers/ID/*.exr`: background, reference, with, without, ratio, matte, composite, difference
/// (composite minus reference), additive (Debevec's form), and `local_scene.png`, a shaded picture of the
/// depth mesh (paper Fig. 2).
void write_layers(const std::filesystem::path& set_folder, const TruthScene& scene, const Geometry* depth,
                  const TruthLayers& truth, const StimulusLayers& layers, const Composite& composite,
                  const Stimulus& stimulus);

[[nodiscard]] bool has_layers(const std::filesystem::path& set_folder, const Stimulus& stimulus);

/// The depth mesh lit from the camera: grey by the angle of its triangles, sky black.
[[nodiscard]] Image shaded_picture(const Camera& camera, const Geometry& geometry);

/// Pixels whose centre shows background (0) or object 1, 2, 3.
[[nodiscard]] std::array<std::int64_t, 4> visible_pixels(const Camera& camera, const Geometry& everything);

}  // namespace seamline
