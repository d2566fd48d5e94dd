#pragma once
#include "renderer/estimators/estimator.h"
#include "renderer/picture/composite.h"

namespace seamline::renderer {

/// Composites an object into a photograph of which only a depth mesh is known: everything is answered by the
/// mesh. A photograph has no sub-pixels, so its share of a pixel is (1 - alpha) B ratio
/// (documentation/design.md, section 2). Camera and mesh are centred on the panorama.
[[nodiscard]] StimulusSums render_onto_photograph(const Image& photograph, const Geometry& depth,
                                                  const Geometry& object, const Camera& camera,
                                                  const Light& light, const PassOptions& options);

}  // namespace seamline::renderer
