#pragma once
#include "composites/objects/photo_objects.h"
#include "composites/photo_composite.h"

namespace seamline::renderer {

/// The same camera with at most so many columns.
[[nodiscard]] Camera preview_sized(const Camera& camera, int width_px);

/// Whether objects can change the picture, before it is rendered: whether a part of them is seen, or whether
/// they change a ten-thousandth of the light of a small picture of few samples. `sight`: of `scene`.
[[nodiscard]] bool may_change(const PhotoScene& scene, const ObjectSight& sight, int threads);

}  // namespace seamline::renderer
