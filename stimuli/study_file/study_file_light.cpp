#include "stimuli/study_file/study_file_light.h"
#include "stimuli/definition/moving/file_moment.h"

#include <cmath>

#include "stimuli/settings/read_settings.h"
#include "stimuli/settings/scene_settings.h"
#include "support/text/limits.h"

namespace seamline::inline stimuli {
namespace {

constexpr double anywhere = limits::farthest_place_m;

Eigen::Vector3d read_direction(const TomlTable& table, const std::string& key,
                               const std::array<double, 3>& fallback) {
  const std::array<double, 3> read = table.triple(key, fallback, {-anywhere, anywhere});
  const Eigen::Vector3d direction(read[0], read[1], read[2]);
  if (!(direction.norm() > 0)) throw table.complaint(key, "a direction that is not zero", "[0, 0, 0]");
  return direction.normalized();
}

LampDefinition read_lamp(const TomlTable& table) {
  LampDefinition lamp;
  read_settings(table, lamp);
  lamp.is_spot = table.has("shines_along");
  if (lamp.is_spot) {
    lamp.shines_along = read_direction(table, "shines_along", {0, -1, 0});
    read_setting(table, "outer_deg", lamp);
    read_setting(table, "inner_deg", lamp);
  }
  table.finish();
  return lamp;
}

void read_environment(const TomlTable& table, const AssetFolders& folders, AssetCheck assets,
                      SceneDefinition& scene) {
  if (table.has("environment_radiance")) {
    if (table.has("environment"))
      throw table.complaint("environment", "a map or environment_radiance, not both", "both");
    scene.environment.reset();
  }
  read_setting(table, "environment_radiance", scene);
  if (table.has("environment")) {
    const std::string file = table.text("environment");
    scene.environment = EnvironmentDefinition{
        .file = file,
        .path = find_asset(table, "environment", file, folders, assets, BuiltinKind::environment)};
  }
  if (!scene.environment) {
    for (const char* key : {"environment_rotation_deg", "environment_strength"})
      if (table.has(key)) throw table.complaint(key, "an environment map to change", "none");
    return;
  }
  read_settings(table, *scene.environment);
}

void read_lamps(const TomlTable& table, SceneDefinition& scene) {
  if (table.has("suns")) {
    scene.sun.reset();
    scene.suns.emplace();
    for (const TomlTable& sun : table.tables("suns")) scene.suns->push_back(read_sun(sun));
  }
  if (table.has("lamps")) {
    scene.lamps.emplace();
    for (const TomlTable& lamp : table.tables("lamps")) scene.lamps->push_back(read_lamp(lamp));
  }
}

}  // namespace

SunDefinition read_sun(const TomlTable& table) {
  SunDefinition sun;
  sun.to_sun = read_direction(table, "to_sun", {0, 1, 0});
  read_settings(table, sun);
  table.finish();
  return sun;
}

std::filesystem::path find_asset(const TomlTable& table, const std::string& key, const std::string& file,
                                 const AssetFolders& folders, AssetCheck assets, BuiltinKind kind) {
  return assets == AssetCheck::must_exist
             ? resolve_asset(split_moment(file).file, folders, table.field(key), kind)
             : std::filesystem::path{};
}

void read_light(const TomlTable& table, const AssetFolders& folders, AssetCheck assets,
                SceneDefinition& scene) {
  read_environment(table, folders, assets, scene);
  read_lamps(table, scene);
  read_settings(table, scene);
  if (scene.ambient_occlusion)
    for (const char* key : {"environment", "suns", "lamps"})
      if (table.has(key))
        throw table.complaint(key, "light of a scene without ambient_occlusion, which has none but its own",
                              "ambient_occlusion");
  drop_idle(scene);
  if (table.has("sun_radius_deg") && scene.ambient_occlusion)
    throw table.complaint("sun_radius_deg", "a sun: the scene \"" + scene.name + "\" has ambient_occlusion",
                          "a radius of none");
}

}  // namespace seamline::inline stimuli
