#pragma once
#include "renderer/depth/occlusion_test.h"
#include "renderer/error/error_estimate.h"
#include "renderer/estimators/estimator.h"
#include "renderer/picture/composite.h"

namespace seamline::renderer {

/// Who is in front, in place of the depth mesh.
struct Occlusion {
  const OcclusionTest* test = nullptr;  ///< null: the mesh decides, or nobody
  /// The objects are drawn over everything. Then real things do not shade them either: where they stand
  /// behind or within these, they would be black.
  bool nothing_hides = false;
};

/// A photograph of which only a local scene is known, and what is put into it. Camera and local scene have
/// one origin.
struct PhotoScene {
  const Image& photograph;
  const Camera& camera;
  const Geometry& depth;
  const Geometry& objects;  ///< all of them: they shade each other
  const Light& light;
  Occlusion occlusion = {};
  const Mask* shadow_matte = nullptr;  ///< where the suns do not reach; null: the local scene says it
  bool shadows = true;  ///< false: real surfaces keep the photograph's light, whatever the objects take
};

/// Sums of no samples yet.
[[nodiscard]] StimulusSums empty_photo_sums(const PhotoScene& scene, int threads);

/// Adds samples `first` to `options.spp` of every pixel, each path traced to its end: everything is answered
/// by the local scene, but who is in front and where the sun is blocked by `occlusion` and `shadow_matte`
/// where these say it. A photograph has no sub-pixels, so its share of a pixel is (1 - alpha) B ratio
/// (documentation/developers/design.md, section 2).
void add_photo_samples(const PhotoScene& scene, int first, const PassOptions& options, StimulusSums& sums);

/// Sums, and the error of the picture that they make, in display units.
struct PhotoEstimate {
  StimulusSums sums;
  ErrorEstimate error;  ///< tiles empty with one sample a pixel: not known
};

/// By paths: `options.spp` samples a pixel, or, with an error to reach, 16 and twice as many until it is
/// reached.
[[nodiscard]] PhotoEstimate photo_by_path(const PhotoScene& scene, const std::optional<double>& error,
                                          double exposure_ev, const PassOptions& options);

}  // namespace seamline::renderer
