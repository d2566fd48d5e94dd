#pragma once
#include <vector>

#include "raytracer/scene/truth_scene.h"
#include "renderer/transport/worlds.h"

namespace seamline::renderer {

/// The geometries of a scene that its worlds are made of. Pointers in `worlds` look into it: it stays where
/// it is.
struct SceneGeometry {
  explicit SceneGeometry(const TruthScene& scene);
  SceneGeometry(const SceneGeometry&) = delete;
  SceneGeometry& operator=(const SceneGeometry&) = delete;
  ~SceneGeometry() = default;

  Geometry room;                 ///< the background alone
  Geometry objects;              ///< all objects
  std::vector<Geometry> alone;   ///< each object
  std::vector<Geometry> others;  ///< the other objects of each; none where there is one object
  Worlds worlds;
};

/// The truth of one virtual object: T (background and the others) and the object alone.
struct ObjectGeometry {
  Geometry truth;
  Geometry object;
};
[[nodiscard]] ObjectGeometry object_geometry(const TruthScene& scene, int object_index);

}  // namespace seamline::renderer
