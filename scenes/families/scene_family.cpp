#include "scenes/families/scene_family.h"

#include "scenes/families/family_parts.h"

namespace seamline::scenes {

std::string_view word(SceneFamily family) {
  switch (family) {
    case SceneFamily::rooms:
      return "rooms";
    case SceneFamily::pavilions:
      return "pavilions";
    case SceneFamily::arcades:
      return "arcades";
  }
  return {};
}

std::optional<SceneFamily> scene_family_from_word(std::string_view text) {
  for (const SceneFamily family : every_scene_family)
    if (word(family) == text) return family;
  return std::nullopt;
}

GeneratedScene generate_scene(SceneFamily family, Random& random) {
  switch (family) {
    case SceneFamily::rooms:
      return generate_room(random);
    case SceneFamily::pavilions:
      return generate_pavilion(random);
    case SceneFamily::arcades:
      return generate_arcade(random);
  }
  return {};
}

void place_anew(SceneFamily family, GeneratedScene& scene, std::size_t object, Random& random) {
  switch (family) {
    case SceneFamily::rooms:
      return place_in_room(scene, object, random);
    case SceneFamily::pavilions:
      return place_by_pavilion(scene, object, random);
    case SceneFamily::arcades:
      return place_in_arcade(scene, object, random);
  }
}

GeneratedScene as_shown(const GeneratedScene& scene) {
  if (!scene.mirrored) return scene;
  const Eigen::Affine3d mirror{Eigen::Scaling(-1.0, 1.0, 1.0)};
  GeneratedScene shown = scene;
  shown.mirrored = false;
  for (ScenePart& part : shown.background.parts) part.mesh = transformed(part.mesh, mirror);
  if (shown.background.camera) {
    shown.background.camera->position_m.x() *= -1;
    shown.background.camera->look_at_m.x() *= -1;
  }
  if (shown.background.sun) shown.background.sun->to_sun.x() *= -1;
  for (PlacedObject& object : shown.objects) {
    object.position_m.x() *= -1;
    object.yaw_deg *= -1;
  }
  return shown;
}

}  // namespace seamline::scenes
