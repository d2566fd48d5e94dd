#include "stimuli/study_file/study_file_scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "stimuli/definition/looks/study_look.h"
#include "stimuli/definition/moving/file_moment.h"
#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/settings/clip_settings.h"
#include "stimuli/settings/read_settings.h"
#include "stimuli/settings/scene_settings.h"
#include "stimuli/study_file/moving/study_file_clip.h"
#include "stimuli/study_file/study_file_light.h"

namespace seamline::inline stimuli {
namespace {

/// Of nodes that are written behind a file's name, as only the program does.
void refuse_written_nodes(const TomlTable& table, const std::string& file, const std::string& wanted) {
  if (const auto moment = split_moment(file).moment; moment && !moment->nodes.empty())
    throw table.complaint("file", wanted, "\"" + file + "\"");
}

ObjectDefinition read_object(const TomlTable& table, const AssetFolders& folders, AssetCheck assets) {
  ObjectDefinition object;
  read_settings(table, object);
  table.finish();
  refuse_written_nodes(table, object.file, "a file whose nodes stand where it has them");
  object.path = find_asset(table, "file", object.file, folders, assets);
  return object;
}

/// Whether it is a panorama.
bool read_projection(const TomlTable& table) {
  return table.has("projection") && read_word(table, "projection", words_of_projection) == 1;
}

/// `path` of an object or node. `place`: the scene and which of it moves.
void read_path(const TomlTable& table, const Eigen::Vector3d& position_m,
               const std::pair<std::string, std::string>& place, Quantity level, ClipDefinition* clip) {
  if (!table.has("path")) return;
  if (clip == nullptr)
    throw table.complaint("path", "a table [clip] in the study beside it: objects of stills stand still",
                          "none");
  clip->motions.emplace(place, read_motion(*table.table("path"), position_m, level));
}

/// Nodes of the background that stand or move elsewhere than in their file.
void read_nodes(const TomlTable& table, SceneDefinition& scene, Quantity level, ClipDefinition* clip) {
  refuse_written_nodes(table, scene.file, "a file, and [[scene.node]] for nodes that stand elsewhere");
  std::set<std::string> names;
  for (const TomlTable& one : table.tables("node")) {
    PlacedNode node;
    read_settings(one, node);
    const bool moves = one.has("path") || one.has("position_m") || one.has("rotation_deg");
    one.finish();
    if (node.name.empty() || node.name.find_first_of(marks_of_nodes) != std::string::npos)
      throw one.complaint("name", "a node's name without any of " + std::string(marks_of_nodes),
                          "\"" + node.name + "\"");
    if (!names.insert(node.name).second)
      throw one.complaint("name", "each node once", "\"" + node.name + "\" twice");
    if (!moves)
      throw one.complaint("name", "position_m, rotation_deg or a path beside it, which move the node",
                          "none");
    const PlacedNode elsewhere{.name = node.name, .position_m = Eigen::Vector3d::Ones()};
    if (!split_moment(with_node(scene.file, elsewhere)).moment)
      throw table.complaint("file", "a glTF file (.gltf, .glb) or a built-in one beside [[scene.node]]",
                            "\"" + scene.file + "\"");
    read_path(one, node.position_m, {scene.name, place_of_node(node.name)}, level, clip);
    scene.file = with_node(scene.file, node);
  }
}

/// `animation` of an object, or of the background.
void read_animation_of(const TomlTable& table, const std::string& file,
                       const std::pair<std::string, std::string>& place, ClipDefinition* clip) {
  if (!table.has("animation")) return;
  if (clip == nullptr)
    throw table.complaint("animation",
                          "a table [clip] in the study beside it; a still may stand at one moment of it: "
                          "file = \"FILE.glb#NAME@SECONDS\"",
                          "none");
  clip->animations.emplace(place, read_animation(*table.table("animation"), file));
}

/// `path` of a camera.
void read_camera_path(const TomlTable& table, SceneDefinition& scene, ClipDefinition* clip) {
  if (!table.has("path")) return;
  if (clip == nullptr)
    throw table.complaint("path", "a table [clip] in the study beside it: cameras of stills stand still",
                          "none");
  clip->cameras.emplace(scene.name, read_camera_motion(*table.table("path")));
}

CameraDefinition read_camera(const TomlTable& table) {
  static_cast<void>(table.has("path"));  // read by `read_camera_path`
  CameraDefinition camera;
  camera.look_at_m = {0, 0, -1};  // without the signs of zeros that the default has: they stand in the hash
  const bool is_panorama = read_projection(table);
  if (is_panorama && table.has("horizontal_fov_deg"))
    throw table.complaint("horizontal_fov_deg",
                          "look.horizontal_fov_deg, which is of the view: a panorama shows all directions",
                          "both");
  read_settings(table, camera);
  if (is_panorama) camera.horizontal_fov_deg = panorama_fov_deg;
  const Eigen::Vector3d view = camera.look_at_m - camera.position_m;
  if (view.cross(Eigen::Vector3d::UnitY()).norm() <= 1e-9 * view.norm())
    throw table.complaint("look_at_m", "a point that is not straight above, below or at the camera",
                          "no such point");
  table.finish();
  return camera;
}

std::vector<Artifact> read_artifacts(const TomlTable& table) {
  std::vector<Artifact> artifacts;
  for (const std::string& text : table.texts("artifacts")) {
    const std::optional<Artifact> artifact = artifact_from_word(text);
    if (!artifact)
      throw table.complaint("artifacts",
                            "receiver, shadow, occlusion, overlap, bounce, reflection, all or none",
                            "\"" + text + "\"");
    if (std::find(artifacts.begin(), artifacts.end(), *artifact) != artifacts.end())
      throw table.complaint("artifacts", "each artifact once", "\"" + text + "\" twice");
    artifacts.push_back(*artifact);
  }
  return artifacts;
}

}  // namespace

SceneDefinition read_scene(const TomlTable& table, const AssetFolders& folders, AssetCheck assets,
                           Quantity level, ClipDefinition* clip, int objects) {
  SceneDefinition scene;
  for (const char* key : {"name", "file"}) read_setting(table, key, scene);
  scene.artifacts = read_artifacts(table);
  read_light(table, folders, assets, scene);
  if (const auto sun = table.table("sun")) {
    if (scene.suns) throw table.complaint("suns", "one of sun and suns", "both");
    if (scene.sun_radius_deg && sun->has("angular_radius_deg"))
      throw table.complaint("sun_radius_deg", "one radius of the sun", "sun.angular_radius_deg beside it");
    scene.sun = read_sun(*sun);
  }
  if (const auto camera = table.table("camera")) {
    scene.camera = read_camera(*camera);
    read_camera_path(*camera, scene, clip);
  }
  read_animation_of(table, scene.file, {scene.name, ""}, clip);
  read_nodes(table, scene, level, clip);
  std::set<std::string> names;
  for (const TomlTable& object : table.tables("object")) {
    scene.objects.push_back(read_object(object, folders, assets));
    if (!names.insert(scene.objects.back().name).second)
      throw object.complaint("name", "a name that no other object of the scene has",
                             "\"" + scene.objects.back().name + "\"");
    read_path(object, scene.objects.back().position_m, {scene.name, scene.objects.back().name}, level, clip);
    read_animation_of(object, scene.objects.back().file, {scene.name, scene.objects.back().name}, clip);
  }
  table.finish();
  if (static_cast<int>(scene.objects.size()) != objects)
    throw table.complaint("object",
                          objects == usual_objects
                              ? "three objects: left, middle, right"
                              : std::to_string(objects) + ", as [task] says (objects), from left to right",
                          std::to_string(scene.objects.size()));
  scene.path = find_asset(table, "file", scene.file, folders, assets);
  return scene;
}

}  // namespace seamline::inline stimuli
