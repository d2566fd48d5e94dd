#pragma once
#include "raytracer/light/light.h"
#include "raytracer/material/mask.h"
#include "raytracer/scene/camera.h"
#include "raytracer/tracing/geometry.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// A virtual object as masks see it: they matter only where it is, and what hides it is what is nearer.
struct MaskedObject {
  const Geometry& object;
  Eigen::Vector3f centre_m = Eigen::Vector3f::Zero();  ///< of the sphere around its bounding box
  float radius_m = 0;

  explicit MaskedObject(const Geometry& virtual_object);
  /// Whether a direction from the origin may meet it, or passes within a margin of it.
  [[nodiscard]] bool may_meet(const Eigen::Vector3f& direction, float margin_rad) const;
};

/// The mask that somebody would paint: the silhouettes of what is before the object in `world`. A texel's
/// share is over 4 x 4 directions; where the object is not met, what counts is whether the world is nearer
/// than its centre. Texels away from the object are 0.
[[nodiscard]] DirectionMask occlusion_mask(const Geometry& world, const MaskedObject& object, int width_px,
                                           int threads);

/// The matte that somebody would paint: how much of each sun does not arrive at what `truth` shows, over 3 x
/// 3 directions and, of suns with a disc, places on it. Surfaces that are turned away from a sun say nothing
/// of it. Directions outside the camera's view are 0.
[[nodiscard]] ShadowMatte shadow_matte(const Geometry& truth, const Light& light, const Camera& camera,
                                       int width_px, int threads);

/// What detection looks at.
struct DetectedFrom {
  const Image& photograph;  ///< linear radiance
  const Camera& camera;
  int threads = 1;
};

/// The silhouettes of a coarse local scene, moved onto the photograph's edges near them: the local scene's
/// answer a pixel, smoothed along what the photograph shows (guided filter of He, Sun and Tang, TPAMI 35(6),
/// 2013, guided by display values; radius one and a half texels of the depth map, at least 2 px), and a half
/// of it decides.
[[nodiscard]] DirectionMask detected_mask(const Geometry& local, const MaskedObject& object,
                                          int depth_width_px, int mask_width_px, const DetectedFrom& from);

/// The photograph's shadows, told by what the local scene would have there. A pixel's light in the local
/// scene is A + v S: what arrives without the suns, and each sun's share if nothing is in the way. With k,
/// how bright the photograph is beside a local scene that is lit, m = (B / k - A) / S is the visibility v
/// that the photograph shows: shadow below 0.25, light above 0.75, a part of it between. k is looked for
/// around the pixel (the fourth fifth of B / (A + S) over some 48 x 48 pixels that face a sun), because the A
/// of a coarse mesh is wrong by another factor in every corner; it differs from the whole picture's by at
/// most 1.6. Of several suns all get the same share. Dark paint passes for shadow: it assumes the local
/// scene's albedo.
[[nodiscard]] ShadowMatte detected_matte(const Geometry& local, const Light& light, int matte_width_px,
                                         const DetectedFrom& from);

}  // namespace seamline::renderer
