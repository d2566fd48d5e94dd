#pragma once
#include "raytracer/scene/camera.h"
#include "raytracer/tracing/geometry.h"
#include "renderer/picture/composite.h"
#include "stimuli/definition/views/view.h"

namespace seamline::renderer {

/// What `take_depth_parallax` makes a picture of.
struct DepthParallax {
  const View& view;
  const Camera& camera;      ///< of the view: all eyes' panoramas, and the one from the axis
  const Image& photographs;  ///< of that camera, without the object, linear
  const Geometry& mesh;      ///< the local scene, around the axis
  const StimulusSums& sums;  ///< of which the composite is
  int threads = 1;
};

/// Gives the real surfaces of a composite the parallax of the depth mesh, where the view says so: each eye
/// sees the panorama from the axis painted on the mesh, in place of its own photograph. What an eye's ray
/// meets on the mesh at P is looked up in the direction of P from the axis, the mean of 2 x 2 rays a pixel.
/// The object, the sky, what covers what, and the factor on the background are as they were.
void take_depth_parallax(const DepthParallax& from, Composite& composite);

}  // namespace seamline::renderer
