#pragma once
#include <vector>

#include "x3d/x3d_subject.h"

namespace seamline::renderer {

/// For each vertex of each object, the share of a uniform sky's irradiance that reaches it, 0 to 1: past the
/// objects, and past what of the real world is nearer than half of their own size (with ambient occlusion:
/// than its distance). Farther walls do not count: they send bounce light, which is not known.
[[nodiscard]] std::vector<std::vector<float>> x3d_openness(const X3dSubject& subject, int threads);

}  // namespace seamline::renderer
