#pragma once
#include <optional>
#include <string>
#include <vector>

#include "composites/composite_request.h"
#include "composites/photo_composite.h"
#include "composites/photo_depth.h"
#include "composites/photo_view.h"
#include "raytracer/material/mask.h"

namespace seamline::renderer {

/// What answers in place of the local scene.
struct GivenAnswers {
  std::optional<OcclusionTest> test;  ///< a mask, or depth looked up a pixel
  std::optional<Mask> shadow_matte;

  [[nodiscard]] PhotoOcclusion occlusion(Occlusion kind) const {
    if (test) return {.test = &*test};
    return {.nothing_hides = kind == Occlusion::nobody};
  }
};

/// Reads the masks that were asked for. Throws InputError where a file is no mask of the photograph.
[[nodiscard]] GivenAnswers given_answers(const CompositeRequest& request, const SeenPhoto& seen,
                                         const PhotoDepth& depth);

/// What those are, a line each; none where the local scene answers.
[[nodiscard]] std::vector<std::string> answers_text(const CompositeRequest& request);

}  // namespace seamline::renderer
