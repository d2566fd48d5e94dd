#pragma once
#include "raytracer/scene/truth_scene.h"
#include "renderer/depth/local_scene.h"
#include "renderer/transport/scene_geometry.h"

namespace seamline::renderer {

/// Whether a method draws the local scene's triangles, which must then have been kept.
[[nodiscard]] bool looks_at_triangles(const Pipeline& pipeline);

/// Makes what a pipeline's methods ask in place of rays, and puts it into the local scene: maps of every sun
/// and lamp, lights cut out of the environment, normals, ghosts. Throws InputError where shadow maps have no
/// light to be of.
///
/// A map of the object covers the object. A map of the local scene covers the object and, of what the camera
/// sees (every second pixel either way), those surfaces on which the object's shadow may fall for any of the
/// lights, and, under a sky, those within four radii of the ball around the object, which take some of the
/// sky away from each other: elsewhere the pictures with and without the object hardly differ.
void add_realtime_methods(const TruthScene& scene, const ObjectGeometry& geometry, const Pipeline& pipeline,
                          int threads, LocalScene& local);

/// How the scene's camera draws depth.
[[nodiscard]] DrawView camera_view(const Camera& camera);

}  // namespace seamline::renderer
