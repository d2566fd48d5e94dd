#pragma once
#include <functional>

#include "laboratory/stability/common/namespaces.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/estimators/path/path_truth_pass.h"
#include "renderer/picture/composite.h"
#include "stimuli/definition/artifact.h"

namespace seamline::stability {

/// How a finished stimulus is made of its sums; the product's is `compose`.
using ComposeRule = std::function<Composite(const StimulusSums&)>;
[[nodiscard]] Composite compose_as_product(const StimulusSums& sums);

/// A small picture of a scene's left object, by the path estimator and a depth mesh of the scene.
struct SmallRender {
  Artifact artifact = Artifact::none;
  Isolation isolation = Isolation::query;
  int depth_width_px = 64;
  int spp = 8;
  std::uint64_t seed = 1;
  int threads = 1;
  ComposeRule compose = compose_as_product;
};

struct SmallPicture {
  StimulusSums sums;
  Composite composite;
  Image background, reference;
};

[[nodiscard]] SmallPicture render_small(const TruthScene& scene, const SmallRender& how);

/// How many pixels are not finite, or below 0, or above `most`.
[[nodiscard]] int pixels_out_of_range(const Image& image, double most);

}  // namespace seamline::stability
