#include "renderer/transport/scene_geometry.h"

namespace seamline::renderer {

SceneGeometry::SceneGeometry(const TruthScene& scene)
    : room(scene.geometry(true, {}, Edges::loose)),
      objects(scene.geometry(false, scene.object_indices(), Edges::loose)),
      worlds{&room, &objects, {}, static_cast<int>(scene.objects.size())} {
  for (const int object : scene.object_indices()) {
    alone.push_back(scene.geometry(false, {object}, Edges::loose));
    if (scene.objects.size() > 1)
      others.push_back(scene.geometry(false, scene.other_indices(object), Edges::loose));
  }
  for (std::size_t i = 0; i < others.size(); ++i) worlds.others[i] = &others[i];
}

ObjectGeometry object_geometry(const TruthScene& scene, int object_index) {
  return {scene.geometry_without(object_index), scene.geometry(false, {object_index})};
}

}  // namespace seamline::renderer
