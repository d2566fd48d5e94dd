#pragma once
#include "raytracer/scene/camera.h"
#include "raytracer/tracing/mesh.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// Where samples went: a display picture, dark and grey, with a bright dot where a pixel's direction is that
/// of a vertex of the mesh. Of any camera at the mesh's centre.
[[nodiscard]] Image samples_picture(const DepthMesh& mesh, const Camera& camera, const Image& display,
                                    int threads);

}  // namespace seamline::renderer
