#include "stimuli/study_file/study_file_light.h"

#include <cmath>

#include "support/text/limits.h"

namespace seamline::inline stimuli {
namespace {

constexpr double anywhere = limits::farthest_place_m;

Eigen::Vector3d as_vector(const std::array<double, 3>& values) {
  return {values[0], values[1], values[2]};
}

Eigen::Vector3d read_direction(const TomlTable& table, const std::string& key,
                               const std::array<double, 3>& fallback) {
  const Eigen::Vector3d direction = as_vector(table.triple(key, fallback, {-anywhere, anywhere}));
  if (!(direction.norm() > 0)) throw table.complaint(key, "a direction that is not zero", "[0, 0, 0]");
  return direction.normalized();
}

LampDefinition read_lamp(const TomlTable& table) {
  LampDefinition lamp;
  if (!table.has("position_m")) throw table.complaint("position_m", "where the lamp is", "nothing");
  if (!table.has("intensity_w_sr"))
    throw table.complaint("intensity_w_sr", "how bright the lamp is, [red, green, blue]", "nothing");
  lamp.position_m = as_vector(table.triple("position_m", {0, 0, 0}, {-anywhere, anywhere, "m"}));
  lamp.intensity_w_sr = table.triple("intensity_w_sr", {0, 0, 0}, {0, limits::strongest_light, "W/sr"});
  lamp.is_spot = table.has("shines_along");
  if (lamp.is_spot) {
    lamp.shines_along = read_direction(table, "shines_along", {0, -1, 0});
    lamp.outer_deg = table.number("outer_deg", lamp.outer_deg, {0.1, 90, "degrees"});
    lamp.inner_deg = table.number("inner_deg", lamp.inner_deg, {0, 90, "degrees"});
    if (lamp.inner_deg > lamp.outer_deg)
      throw table.complaint("inner_deg", "an angle of at most outer_deg", "a larger one");
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
  scene.environment_radiance = table.triple("environment_radiance", scene.environment_radiance,
                                            {0, limits::strongest_light, "W/m2/sr"});
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
  EnvironmentDefinition& map = *scene.environment;
  map.rotation_deg = table.number("environment_rotation_deg", map.rotation_deg, {-360, 360, "degrees"});
  map.strength = table.number("environment_strength", map.strength, {0, limits::strongest_light});
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

MaterialModel read_materials(const TomlTable& table, MaterialModel usual) {
  if (!table.has("materials")) return usual;
  const std::string text = table.text("materials");
  for (const MaterialModel model : {MaterialModel::diffuse, MaterialModel::gltf})
    if (text == word(model)) return model;
  throw table.complaint("materials", "diffuse or gltf", "\"" + text + "\"");
}

}  // namespace

SunDefinition read_sun(const TomlTable& table) {
  SunDefinition sun;
  sun.to_sun = read_direction(table, "to_sun", {0, 1, 0});
  sun.irradiance_w_m2 = table.triple("irradiance_w_m2", {0, 0, 0}, {0, limits::strongest_light, "W/m2"});
  sun.angular_radius_deg = table.number("angular_radius_deg", 0.0, {0, 45, "degrees"});
  table.finish();
  return sun;
}

std::filesystem::path find_asset(const TomlTable& table, const std::string& key, const std::string& file,
                                 const AssetFolders& folders, AssetCheck assets, BuiltinKind kind) {
  return assets == AssetCheck::must_exist ? resolve_asset(file, folders, table.field(key), kind)
                                          : std::filesystem::path{};
}

void read_light(const TomlTable& table, const AssetFolders& folders, AssetCheck assets,
                SceneDefinition& scene) {
  read_environment(table, folders, assets, scene);
  read_lamps(table, scene);
  scene.ambient_occlusion = table.boolean("ambient_occlusion", scene.ambient_occlusion);
  scene.ao_distance_m = table.number("ao_distance_m", scene.ao_distance_m, {1e-9, anywhere, "m"});
  if (scene.ambient_occlusion)
    for (const char* key : {"environment", "suns", "lamps"})
      if (table.has(key))
        throw table.complaint(key, "light of a scene without ambient_occlusion, which has none but its own",
                              "ambient_occlusion");
  scene.bounces = table.integer("bounces", scene.bounces, {0, 1024});
  scene.albedo = table.number("albedo", scene.albedo, {0, 1});
  scene.materials = read_materials(table, scene.materials);
  const auto read_layer = [&](const char* key, std::optional<double>& value) {
    if (!table.has(key)) return;
    if (scene.materials != MaterialModel::gltf)
      throw table.complaint(key, "materials = \"gltf\" beside it: diffuse surfaces have no such number",
                            "materials = \"diffuse\"");
    value = table.number(key, 0, {0, 1});
  };
  read_layer("object_metallic", scene.object_metallic);
  read_layer("object_roughness", scene.object_roughness);
  if (scene.materials == MaterialModel::diffuse)
    scene.object_metallic.reset(), scene.object_roughness.reset();
  scene.exposure_ev = table.number("exposure_ev", scene.exposure_ev, {-60, 60, "stops"});
  if (table.has("sun_radius_deg")) {
    scene.sun_radius_deg = table.number("sun_radius_deg", 0, {0, 45, "degrees"});
    if (scene.ambient_occlusion)
      throw table.complaint("sun_radius_deg", "a sun: the scene \"" + scene.name + "\" has ambient_occlusion",
                            "a radius of none");
  }
}

}  // namespace seamline::inline stimuli
