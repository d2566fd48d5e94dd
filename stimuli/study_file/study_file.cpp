#include "stimuli/study_file/study_file.h"

#include <algorithm>
#include <set>

#include "stimuli/study_file/carried_files.h"
#include "stimuli/study_file/study_file_people.h"
#include "stimuli/study_file/study_file_procedure.h"
#include "stimuli/study_file/study_file_scene.h"
#include "stimuli/study_file/study_file_session.h"
#include "stimuli/study_file/study_file_words.h"
#include "stimuli/study_file/toml_table.h"
#include "support/files/assets.h"
#include "support/text/error.h"

namespace seamline::inline stimuli {
namespace {

constexpr const char* study_format = "seamline study 1";

void check_format(const TomlTable& table) {
  const std::string format = table.text("format");
  if (format != study_format)
    throw table.complaint("format", std::string("\"") + study_format + "\"", "\"" + format + "\"");
}

Isolation read_isolation(const TomlTable& table) {
  const std::string text = table.text("isolation", "query");
  const std::optional<Isolation> isolation = isolation_from_word(text);
  if (!isolation) throw table.complaint("isolation", "\"query\" or \"mask\"", "\"" + text + "\"");
  return *isolation;
}

MeshDensity read_mesh(const TomlTable& table) {
  const std::string text = table.text("mesh", "adaptive");
  for (const MeshDensity density : {MeshDensity::adaptive, MeshDensity::full})
    if (word(density) == text) return density;
  throw table.complaint("mesh", "\"adaptive\" or \"full\"", "\"" + text + "\"");
}

std::vector<int> read_widths(const TomlTable& table) {
  std::vector<int> widths = table.integers("depth_width_px", {2, 16384, "px"});
  for (const int width : widths)
    if (width % 2 != 0) throw table.complaint("depth_width_px", "even widths", std::to_string(width));
  if (std::set<int>(widths.begin(), widths.end()).size() != widths.size())
    throw table.complaint("depth_width_px", "widths that differ", "a width given twice");
  std::sort(widths.begin(), widths.end());
  return widths;
}

ObserverDefinition read_observer(const TomlTable& table) {
  ObserverDefinition observer;
  observer.scale_octaves = table.number("scale_octaves", observer.scale_octaves, {1e-6, 100, "octaves"});
  observer.direction = read_direction(table);
  if (table.has("image_gain")) observer.image_gain = table.number("image_gain", 1, {1e-9, 1e9});
  observer.pixels_per_degree =
      table.number("pixels_per_degree", observer.pixels_per_degree, {1, 1000, "pixels per degree"});
  observer.people_sd_octaves =
      table.number("people_sd_octaves", observer.people_sd_octaves, {0, 100, "octaves"});
  if (const auto midpoints = table.table("midpoint_width_px")) {
    for (const Artifact artifact : every_artifact) {
      double& width_px = observer.midpoint_width_px[artifact];
      width_px = midpoints->number(std::string(word(artifact)), width_px, {1e-3, 1e9, "px"});
    }
    midpoints->finish();
  }
  table.finish();
  return observer;
}

StudyDefinition read_study_table(const TomlTable& table, const AssetFolders& folders, AssetCheck assets) {
  const std::filesystem::path& path = folders.study_file;
  check_format(table);
  StudyDefinition study;
  study.file = path;
  study.name = table.text("name");
  study.isolation = read_isolation(table);
  study.width_px = table.integer("width_px", study.width_px, {8, 16384, "px"});
  study.height_px = table.integer("height_px", study.height_px, {8, 16384, "px"});
  study.samples_per_pixel = table.integer("samples_per_pixel", study.samples_per_pixel, {1, 65536});
  study.seed = static_cast<std::uint64_t>(table.integer("seed", 1, {0, 2147483647}));
  study.mesh = read_mesh(table);
  study.mesh_tolerance = table.number("mesh_tolerance", study.mesh_tolerance, {1e-9, 1});
  study.depth_width_px = read_widths(table);
  study.yaw_texels = table.integer("yaw_texels", 0, {-16384, 16384, "texels"});
  if (const auto session = table.table("session")) study.session = read_session(*session);
  study.procedure = read_procedure(table, study.depth_width_px);
  if (const auto observer = table.table("observer")) study.observer = read_observer(*observer);
  if (const auto catches = table.table("catch")) study.catches = read_catches(*catches);
  read_people(table, study);
  std::set<std::string> names;
  for (const TomlTable& scene : table.tables("scene")) {
    study.scenes.push_back(read_scene(scene, folders, assets));
    if (!names.insert(study.scenes.back().name).second)
      throw scene.complaint("name", "a name that no other scene has", "\"" + study.scenes.back().name + "\"");
  }
  table.finish();
  const std::filesystem::path folder = path.parent_path();
  check_carried_files(study, assets == AssetCheck::must_exist ? &folder : nullptr);
  if (study.scenes.empty()) throw table.complaint("scene", "at least one [[scene]]", "none");
  return study;
}

}  // namespace

StudyDefinition read_study(const std::filesystem::path& path, AssetCheck assets,
                           const std::filesystem::path& asset_root) {
  std::error_code error;
  if (!asset_root.empty() && !std::filesystem::is_directory(asset_root, error))
    throw input_error(
        {.field = "--asset-root", .wanted = "a folder", .found = "no folder at " + asset_root.string()});
  return read_study_table(TomlTable::read(path), {.study_file = path, .asset_root = asset_root}, assets);
}

StudyDefinition read_study_text(const std::string& text, const std::filesystem::path& said_to_be) {
  return read_study_table(TomlTable::parse(text, said_to_be), {.study_file = said_to_be},
                          AssetCheck::not_needed);
}

}  // namespace seamline::inline stimuli
