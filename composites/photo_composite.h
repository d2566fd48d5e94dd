#pragma once
#include "raytracer/error/error_estimate.h"
#include "raytracer/error/samples_taken.h"
#include "renderer/depth/occlusion_test.h"
#include "renderer/estimators/estimator.h"
#include "renderer/picture/composite.h"

namespace seamline::renderer {

class SeenEmission;

/// Who is in front, in place of the depth mesh.
struct PhotoOcclusion {
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
  PhotoOcclusion occlusion = {};
  const Mask* shadow_matte = nullptr;  ///< where the suns do not reach; null: the local scene says it
  const Light* added = nullptr;        ///< exists only with the objects; null: none
  const SeenEmission* seen =
      nullptr;          ///< of small objects that emit (`seen_objects`); null: as it is sampled
  bool shadows = true;  ///< false: real surfaces keep the photograph's light, whatever the objects take
  Compositing compositing = Compositing::ratio;  ///< of the picture whose error is estimated
};

/// What light that exists only with the objects adds to real surfaces in a pixel, sums of samples.
struct AddedPixel {
  Rgb sent = Rgb::Zero();      ///< by the local scene, of its own albedo
  Rgb by_white = Rgb::Zero();  ///< by surfaces of albedo 1
};

/// Sums of a composite's samples.
struct PhotoSums : StimulusSums {
  Halves<AddedPixel> added = {};  ///< empty without `PhotoScene::added`
};

/// Sums of no samples yet.
[[nodiscard]] PhotoSums empty_photo_sums(const PhotoScene& scene, int threads);

/// Adds samples `first` to `options.spp` of every pixel, each path traced to its end: everything is answered
/// by the local scene, but who is in front and where the sun is blocked by `occlusion` and `shadow_matte`
/// where these say it. A photograph has no sub-pixels, so its share of a pixel is (1 - alpha) B ratio
/// (documentation/developers/design.md, section 2).
void add_photo_samples(const PhotoScene& scene, int first, const PassOptions& options, PhotoSums& sums);

/// The picture of them: `compose`, and what added light brings. Light adds up, so that a real surface of
/// radiance B under the light S sends under S + A
///   B (S + A) / S = B + B A / S, but at most B + A' with A' sent by a white surface, and
/// B + A of the local scene's own albedo where S is none (or with additive compositing). A is of the world
/// with the objects.
[[nodiscard]] Composite compose_photo(const PhotoSums& sums, Compositing compositing, int threads);

/// Sums, and the error of the picture that they make, in display units.
struct PhotoEstimate {
  PhotoSums sums;
  ErrorEstimate error;  ///< tiles empty with one sample a pixel: not known
  SamplesTaken taken = {};
};

/// By paths: `options.spp` samples a pixel, or, with an error to reach, 16 and twice as many until it is
/// reached.
[[nodiscard]] PhotoEstimate photo_by_path(const PhotoScene& scene, const std::optional<double>& error,
                                          double exposure_ev, const PassOptions& options);

}  // namespace seamline::renderer
