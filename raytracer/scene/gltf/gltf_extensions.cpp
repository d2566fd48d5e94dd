#include "raytracer/scene/gltf/gltf_extensions.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "support/text/counted.h"
#include "support/text/printable.h"

namespace seamline::renderer {
namespace {

/// Extensions that are read, or whose parts are named where they are left out (`GltfMaterials`).
constexpr std::array read_extensions = {
    "EXT_mesh_gpu_instancing",
    "EXT_meshopt_compression",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_diffuse_transmission",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_meshopt_compression",
    "KHR_node_visibility",
    "KHR_texture_transform",
};

/// Extensions that say nothing which a picture could show.
constexpr std::array silent_extensions = {
    "AGI_articulations", "EXT_instance_features", "EXT_mesh_features", "EXT_structural_metadata",
    "KHR_xmp",           "KHR_xmp_json_ld",
};

/// How to get rid of an extension that Seamline cannot read.
struct WayRound {
  const char* extension;
  const char* what;
};
constexpr std::array ways_round = {
    WayRound{"KHR_texture_basisu",
             "pictures in KTX2; `gltf-transform ktxdecompress IN OUT` makes PNG pictures of them"},
    WayRound{"EXT_texture_webp", "pictures in WebP; `gltf-transform png IN OUT` makes PNG pictures of them"},
    WayRound{"EXT_texture_avif", "pictures in AVIF; `gltf-transform png IN OUT` makes PNG pictures of them"},
    WayRound{"MSFT_texture_dds", "pictures in DDS; save the file with PNG pictures"},
    WayRound{"KHR_techniques_webgl",
             "shaders in place of materials; save the file with materials of glTF 2.0"},
    WayRound{"KHR_gaussian_splatting", "points in place of surfaces; save the file as a mesh"},
};

template <std::size_t size>
bool contains(const std::array<const char*, size>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

const WayRound* way_round(std::string_view name) {
  const auto found = std::find_if(ways_round.begin(), ways_round.end(),
                                  [&](const WayRound& way) { return way.extension == name; });
  return found == ways_round.end() ? nullptr : &*found;
}

}  // namespace

void require_readable(const GltfJson& json, const std::filesystem::path& path) {
  // Of glTF 1.0, tables have names in place of numbers; some of its files say no version.
  const GltfJson *asset = member(json, "asset"), *meshes = member(json, "meshes");
  const std::string version = asset != nullptr ? text_of(*asset, "version") : std::string();
  if ((!version.empty() && !version.starts_with("2.")) || (meshes != nullptr && meshes->is_object()))
    throw bad_gltf(path, "asset.version", "glTF 2.0 (`gltf-pipeline -i IN -o OUT` turns 1.0 into it)",
                   version.empty() ? "tables of glTF 1.0" : "\"" + printable(version) + "\"");
  const GltfJson* required = member(json, "extensionsRequired");
  if (required == nullptr || !required->is_array()) return;
  for (const GltfJson& one : *required) {
    const std::string name = one.is_string() ? one.get<std::string>() : std::string();
    if (contains(read_extensions, name) || contains(silent_extensions, name)) continue;
    const WayRound* way = way_round(name);
    throw bad_gltf(path, "extensionsRequired", "extensions that Seamline knows",
                   "\"" + printable(name) + "\"" + (way != nullptr ? fmt::format(" ({})", way->what) : ""));
  }
}

void note_unread(const GltfJson& json, LeftOut& left_out) {
  if (const std::size_t count = count_of(json, "animations"); count > 0)
    left_out.insert(counted(count, "animation") + " (everything is shown at rest)");
  if (const std::size_t count = count_of(json, "scenes"); count > 1)
    left_out.insert(counted(count - 1, "further scene"));
  const GltfJson* used = member(json, "extensionsUsed");
  if (used == nullptr || !used->is_array()) return;
  for (const GltfJson& one : *used) {
    const std::string name = one.is_string() ? one.get<std::string>() : std::string();
    if (name == "KHR_materials_variants") left_out.insert("variants of materials (the first look is shown)");
    if (!contains(read_extensions, name) && !contains(silent_extensions, name))
      left_out.insert(printable(name));
  }
}

}  // namespace seamline::renderer
