#pragma once
#include <filesystem>

#include "raytracer/scene/truth_scene.h"
#include "renderer/picture/composite.h"
#include "stimuli/definition/stimulus.h"

namespace seamline::renderer {

/// Whose layers are written where, and the hash of what they were made from.
struct LayerTarget {
  std::filesystem::path set_folder;
  Stimulus stimulus;
  std::string inputs;
};

/// Everything that one stimulus was made of.
struct LayerSources {
  const TruthSums& truth;
  const StimulusSums& layers;
  const Composite& composite;
};

/// Writes `SET/layers/ID/*.exr`: background, reference, with, without (off the object), ratio, matte,
/// composite, difference (composite minus reference), additive (Debevec's form), and `local_scene.png`, a
/// shaded picture of the depth mesh (paper Fig. 2).
void write_layers(const LayerTarget& target, const TruthScene& scene, const Geometry* depth,
                  const LayerSources& parts);

/// Whether the layers of a stimulus are there and were made from these inputs.
[[nodiscard]] bool has_layers(const std::filesystem::path& set_folder, const Stimulus& stimulus,
                              const std::string& inputs);

/// The depth mesh lit from the camera: grey by the angle of its triangles, sky black.
[[nodiscard]] Image shaded_picture(const Camera& camera, const Geometry& geometry);

}  // namespace seamline::renderer
