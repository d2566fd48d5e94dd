#pragma once
#include <array>

#include "renderer/scene/truth_scene.h"
#include "renderer/transport/worlds.h"

namespace seamline::renderer {

/// The geometries of a scene that its worlds are made of. Pointers in `worlds` look into it: it stays where
/// it is.
struct SceneGeometry {
  explicit SceneGeometry(const TruthScene& scene);
  SceneGeometry(const SceneGeometry&) = delete;
  SceneGeometry& operator=(const SceneGeometry&) = delete;
  ~SceneGeometry() = default;

  Geometry room;                   ///< the background alone
  Geometry objects;                ///< the three objects
  std::array<Geometry, 3> alone;   ///< each object
  std::array<Geometry, 3> others;  ///< the two other objects
  Worlds worlds;
};

}  // namespace seamline::renderer
