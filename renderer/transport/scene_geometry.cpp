#include "renderer/transport/scene_geometry.h"

namespace seamline::renderer {

SceneGeometry::SceneGeometry(const TruthScene& scene)
    : room(scene.geometry(true, {}, Edges::loose)),
      objects(scene.geometry(false, {1, 2, 3}, Edges::loose)),
      alone{scene.geometry(false, {1}, Edges::loose), scene.geometry(false, {2}, Edges::loose),
            scene.geometry(false, {3}, Edges::loose)},
      others{scene.geometry(false, {2, 3}, Edges::loose), scene.geometry(false, {1, 3}, Edges::loose),
             scene.geometry(false, {1, 2}, Edges::loose)},
      worlds{&room, &objects, {&others[0], &others[1], &others[2]}, 3} {}

ObjectGeometry object_geometry(const TruthScene& scene, int object_index) {
  return {scene.geometry_without(object_index), scene.geometry(false, {object_index})};
}

}  // namespace seamline::renderer
