#include "composites/objects/objects_file.h"

#include <fmt/core.h>

#include "stimuli/study_file/study_file_light.h"
#include "support/files/assets.h"
#include "support/files/toml_table.h"
#include "support/text/limits.h"
#include "support/text/request_name.h"

namespace seamline::renderer {
namespace {

constexpr NumberRange unit_range{0, 1};

Eigen::Vector3d vector_at(const TomlTable& table, const std::string& key, NumberRange range) {
  const auto v = table.triple(key, {0, 0, 0}, range);
  return {v[0], v[1], v[2]};
}

void read_material(const TomlTable& table, PlacedModel& model) {
  if (table.has("materials")) {
    const std::string text = table.text("materials");
    if (text != "gltf" && text != "diffuse")
      throw table.complaint("materials", "gltf or diffuse", "\"" + text + "\"");
    model.materials = text == "gltf" ? MaterialModel::gltf : MaterialModel::diffuse;
  }
  if (table.has("transparent")) {
    const std::string text = table.text("transparent");
    const auto transparency = transparency_of(text);
    if (!transparency) throw table.complaint("transparent", transparency_words, "\"" + text + "\"");
    model.transparency = *transparency;
  }
  model.albedo = table.number("albedo", model.albedo, unit_range);
  for (const auto& [key, value] : {std::pair{"metallic", &model.metallic}, {"roughness", &model.roughness}}) {
    if (!table.has(key)) continue;
    if (model.materials == MaterialModel::diffuse)
      throw table.complaint(key, "materials = \"gltf\": diffuse surfaces have no such number",
                            "materials = \"diffuse\"");
    *value = table.number(key, 0, unit_range);
  }
}

PlacedModel read_object(const TomlTable& table, const AssetFolders& folders) {
  PlacedModel model;
  model.file = table.text("file");
  model.path = resolve_asset(model.file, folders, table.field("file"));
  model.has_place = table.has("position_m");
  if (model.has_place)
    model.position_m =
        vector_at(table, "position_m", {-limits::farthest_place_m, limits::farthest_place_m, "m"});
  model.rotation_deg = vector_at(table, "rotation_deg", {-1e9, 1e9, "degrees"});
  if (table.has("scale") && table.has("height_m"))
    throw table.complaint("height_m", "scale or height_m, not both", "both");
  model.scale = table.number("scale", 1, {1e-9, 1e9});
  if (table.has("height_m")) model.height_m = table.number("height_m", 1, {1e-9, 1e9, "m"});
  model.stands = table.boolean("stands", model.height_m.has_value() || !model.has_place);
  model.rest = table.boolean("rest", false);
  read_material(table, model);
  table.finish();
  return model;
}

/// What `read_light` reads besides, and the command has options for.
void refuse_options(const TomlTable& table) {
  for (const auto& [key, option] : {std::pair{"albedo", request_name("albedo")},
                                    {"bounces", request_name("bounces")},
                                    {"exposure_ev", request_name("exposure")}})
    if (table.has(key)) throw table.complaint(key, option + ", which the composite is asked with", "a key");
  for (const char* key : {"materials", "object_metallic", "object_roughness", "ambient_occlusion",
                          "ao_distance_m", "sun_radius_deg"})
    if (table.has(key)) throw table.complaint(key, "keys of light and tables [[object]]", "a key of studies");
}

/// Suns and lamps that exist only with the objects.
SceneDefinition read_added(const TomlTable& table, const AssetFolders& folders) {
  refuse_options(table);
  for (const char* key :
       {"environment", "environment_radiance", "environment_strength", "environment_rotation_deg"})
    if (table.has(key))
      throw table.complaint(key, "suns and lamps, which exist only with the objects", "an environment");
  SceneDefinition added;
  read_light(table, folders, AssetCheck::must_exist, added);
  table.finish();
  if (!added.suns && !added.lamps) throw table.complaint("lamps", "suns or lamps", "neither");
  return added;
}

ObjectsFile read_objects(const TomlTable& table, const std::filesystem::path& path,
                         const std::filesystem::path& asset_root) {
  const AssetFolders folders{.study_file = path, .asset_root = asset_root};
  ObjectsFile file;
  refuse_options(table);
  for (const char* key : {"environment", "environment_radiance", "suns", "lamps"})
    file.has_light = file.has_light || table.has(key);
  file.light.environment_radiance = {0, 0, 0};
  read_light(table, folders, AssetCheck::must_exist, file.light);
  if (const auto added = table.table("virtual_light")) file.added = read_added(*added, folders);
  for (const TomlTable& object : table.tables("object")) file.objects.push_back(read_object(object, folders));
  if (file.objects.empty() && !file.added)
    throw table.complaint("object", "at least one table [[object]]", "none");
  table.finish();
  return file;
}

}  // namespace

ObjectsFile read_objects_file(const std::filesystem::path& path, const std::filesystem::path& asset_root) {
  return read_objects(TomlTable::read(path), path, asset_root);
}

ObjectsFile parse_objects_file(const std::string& text, const std::filesystem::path& path,
                               const std::filesystem::path& asset_root) {
  return read_objects(TomlTable::parse(text, path), path, asset_root);
}

std::vector<std::filesystem::path> files_named_by(const ObjectsFile& file) {
  std::vector<std::filesystem::path> named;
  for (const PlacedModel& object : file.objects) named.push_back(object.path);
  if (file.light.environment) named.push_back(file.light.environment->path);
  return named;
}

std::string objects_file_text(const std::vector<PlacedModel>& objects) {
  std::string text;
  const auto three = [](const Eigen::Vector3d& v) {
    return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
  };
  const auto quoted = [](const std::string& from) {
    std::string out = "\"";
    for (const char letter : from) {
      if (letter == '"' || letter == '\\') out += '\\';
      out += letter;
    }
    return out + "\"";
  };
  for (const PlacedModel& object : objects) {
    text += fmt::format("[[object]]\nfile = {}\nposition_m = {}\nrotation_deg = {}\n", quoted(object.file),
                        three(object.position_m), three(object.rotation_deg));
    text += object.height_m ? fmt::format("height_m = {}\n", *object.height_m)
                            : fmt::format("scale = {}\n", object.scale);
    text += fmt::format("stands = {}\nmaterials = \"{}\"\nalbedo = {}\n", object.stands,
                        word(object.materials), object.albedo);
    if (object.transparency != Transparency::refused)
      text += fmt::format("transparent = \"{}\"\n", word(object.transparency));
    if (object.rest) text += "rest = true\n";
    if (object.metallic) text += fmt::format("metallic = {}\n", *object.metallic);
    if (object.roughness) text += fmt::format("roughness = {}\n", *object.roughness);
    text += "\n";
  }
  return text;
}

}  // namespace seamline::renderer
