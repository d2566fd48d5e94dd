#pragma once
#include <array>
#include <cstdint>

#include "raytracer/scene/truth_scene.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::renderer {

/// Pixels whose centre shows background (0) or object 1, 2, 3.
[[nodiscard]] std::array<std::int64_t, 4> visible_pixels(const Camera& camera, const Geometry& everything);

/// Throws InputError when one of the scene's objects covers no pixel of the picture.
void require_visible_objects(const StudyDefinition& study, const TruthScene& scene);

/// Throws InputError when a study asks what is mirrored in an object that mirrors nothing.
void require_mirrors(const StudyDefinition& study, const TruthScene& scene);

}  // namespace seamline::renderer
