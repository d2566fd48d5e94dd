#pragma once
#include <functional>

#include "renderer/estimators/estimator.h"
#include "renderer/picture/composite.h"

namespace seamline::renderer {

/// The camera of a photograph, at the origin of the renderer's frame.
struct PhotographCamera {
  int width_px = 0;
  int height_px = 0;
  /// Unit direction through an image position in pixels, (0, 0) being the upper left corner of the picture;
  /// zero where the lens lets none through: there the photograph stays as it is.
  std::function<Eigen::Vector3f(float x, float y)> direction;
};

[[nodiscard]] PhotographCamera photograph_camera(const Camera& camera);

/// Who is in front, in place of the depth mesh.
struct Occlusion {
  /// Whether the real world hides a point of the object: its image position, and the point. Empty: the mesh
  /// decides.
  std::function<bool(float x, float y, const Eigen::Vector3f& point_m)> hides = {};
  /// Whether real things may shade the object. Not where it is drawn over things that it stands behind or
  /// within: there they would make it black.
  bool real_shades_object = true;
};

/// Composites an object into a photograph of which only a depth mesh is known: everything is answered by the
/// mesh, but who is in front by `occlusion` where that says it. A photograph has no sub-pixels, so its share
/// of a pixel is (1 - alpha) B ratio (documentation/design.md, section 2). Camera and mesh have one origin.
[[nodiscard]] StimulusSums render_onto_photograph(const Image& photograph, const Geometry& depth,
                                                  const Geometry& object, const PhotographCamera& camera,
                                                  const Light& light, const PassOptions& options,
                                                  const Occlusion& occlusion = {});

}  // namespace seamline::renderer
