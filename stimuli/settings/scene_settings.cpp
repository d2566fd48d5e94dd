#include "stimuli/settings/scene_settings.h"

namespace seamline::inline stimuli {

std::string fault_of_cone(const LampDefinition& lamp) {
  return lamp.inner_deg <= lamp.outer_deg ? "" : "an angle of at most outer_deg";
}

std::string canonical_text(const SunDefinition& sun) {
  return settings_text(sun);
}

std::string canonical_text(const LampDefinition& lamp) {
  std::string text = settings_text(lamp);
  if (lamp.is_spot)
    text += fmt::format(" spot {} {} {}", three_text(lamp.shines_along), lamp.inner_deg, lamp.outer_deg);
  return text + "\n";
}

std::string canonical_text(const EnvironmentDefinition& environment) {
  return settings_text(environment);
}

std::string text_inside(const SceneDefinition& scene) {
  std::string text;
  for (const ObjectDefinition& object : scene.objects) text += settings_text(object) + "\n";
  if (scene.sun) text += settings_text(*scene.sun);
  if (scene.camera) text += settings_text(*scene.camera);
  if (scene.environment) text += settings_text(*scene.environment);
  if (scene.suns) {
    text += "suns\n";
    for (const SunDefinition& sun : *scene.suns) text += settings_text(sun);
  }
  if (scene.lamps) {
    text += "lamps\n";
    for (const LampDefinition& lamp : *scene.lamps) text += canonical_text(lamp);
  }
  return text;
}

bool is_nothing_inside(const SceneDefinition& scene) {
  return text_inside(scene).empty();
}

std::string canonical_text(const SceneDefinition& scene) {
  std::string text = settings_text(scene);
  if (!scene.view.is_mono()) text += fmt::format("view {}\n", canonical_text(scene.view));
  return text;
}

}  // namespace seamline::inline stimuli
