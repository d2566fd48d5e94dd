#include "raytracer/scene/truth_scene.h"
#include "raytracer/scene/panorama_camera.h"
#include "stimuli/definition/looks/study_look.h"

#include <fmt/core.h>

#include <cmath>
#include <numeric>
#include <utility>

#include "raytracer/light/bright_patches.h"
#include "raytracer/scene/eyes.h"
#include "raytracer/scene/lit_parts.h"
#include "raytracer/scene/resting_object.h"
#include "raytracer/scene/scene_moment.h"
#include "raytracer/scene/scene_surfaces.h"
#include "support/arithmetic/units.h"
#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/printable.h"

namespace seamline::renderer {
namespace {

void set_material(const FileMesh& from, const Eigen::Matrix3f& rotation, SurfaceMesh& mesh) {
  const MaterialValues values = largest_values(*from.material);
  mesh.albedo = values.scatterer.albedo;
  mesh.f0 = values.scatterer.f0;
  mesh.alpha = values.scatterer.alpha;
  mesh.f90 = values.scatterer.f90;
  if (from.material->is_uniform() && from.colours.empty()) return;
  mesh.material = from.material;
  mesh.colours = from.colours;
  mesh.uvs = from.uvs;
  mesh.tangents.reserve(from.tangents.size());
  for (const Eigen::Vector4f& tangent : from.tangents) {
    Eigen::Vector4f turned = tangent;
    turned.head<3>() = rotation * tangent.head<3>();
    mesh.tangents.push_back(turned);
  }
}

Rgb rgb(const std::array<double, 3>& values) {
  return Eigen::Array3d(values[0], values[1], values[2]).cast<float>();
}

}  // namespace

void set_layer(const SceneDefinition& definition, FileMesh& mesh) {
  if (!definition.object_metallic && !definition.object_roughness) return;
  Material material;
  if (mesh.material)
    material = *mesh.material;
  else
    material.base_colour = mesh.albedo.value_or(Rgb::Constant(static_cast<float>(definition.albedo))),
    material.metallic = 0.0F;
  material.has_layer = true;
  material.metallic_roughness_texture.reset();
  if (definition.object_metallic) material.metallic = static_cast<float>(*definition.object_metallic);
  if (definition.object_roughness) material.roughness = static_cast<float>(*definition.object_roughness);
  mesh.material = std::make_shared<const Material>(std::move(material));
}

std::vector<int> TruthScene::object_indices() const {
  std::vector<int> indices(objects.size());
  std::iota(indices.begin(), indices.end(), 1);
  return indices;
}

std::vector<int> TruthScene::other_indices(int object_index) const {
  std::vector<int> indices = object_indices();
  std::erase(indices, object_index);
  return indices;
}

Geometry TruthScene::geometry(bool with_background, const std::vector<int>& indices, Edges edges) const {
  std::vector<std::shared_ptr<const SurfaceMesh>> meshes;
  if (with_background) meshes = background;
  for (const int index : indices) {
    const auto& object = objects[index - 1];
    meshes.insert(meshes.end(), object.begin(), object.end());
  }
  return Geometry(meshes, edges);
}

Geometry TruthScene::geometry_without(int object_index) const {
  return geometry(true, other_indices(object_index));
}

Eigen::Affine3d object_placement(const ObjectDefinition& object) {
  const Eigen::Vector3d angle = object.rotation_deg * radians_per_degree;
  Eigen::Affine3d placement = Eigen::Affine3d::Identity();
  placement.translate(object.position_m);
  placement.rotate(Eigen::AngleAxisd(angle.y(), Eigen::Vector3d::UnitY()));
  placement.rotate(Eigen::AngleAxisd(angle.x(), Eigen::Vector3d::UnitX()));
  placement.rotate(Eigen::AngleAxisd(angle.z(), Eigen::Vector3d::UnitZ()));
  placement.scale(object.scale);
  return placement;
}

std::vector<std::shared_ptr<const SurfaceMesh>> place_meshes(const SceneFile& file,
                                                             const Eigen::Affine3d& placement,
                                                             const Eigen::Vector3d& centre_m,
                                                             double default_albedo, int object_index) {
  std::vector<std::shared_ptr<const SurfaceMesh>> meshes;
  const Eigen::Matrix3f rotation = placement.rotation().cast<float>();
  for (const FileMesh& from : file.meshes) {
    auto mesh = std::make_shared<SurfaceMesh>();
    mesh->name = from.name;
    mesh->object_index = object_index;
    mesh->positions_m.reserve(from.positions_m.size());
    for (const Eigen::Vector3d& vertex : from.positions_m) {
      const Eigen::Vector3d place_m = placement * vertex - centre_m;
      if (!(place_m.array().abs() <= limits::farthest_place_m).all())
        throw input_error(
            {.file = file.file,
             .field = "mesh \"" + from.name + "\"",
             .wanted = fmt::format("vertices within {:g} m of the camera", limits::farthest_place_m),
             .found = "one farther away"});
      mesh->positions_m.push_back(place_m.cast<float>());
    }
    mesh->normals.reserve(from.normals.size());
    for (const Eigen::Vector3f& normal : from.normals) mesh->normals.push_back(rotation * normal);
    mesh->triangles = from.triangles;
    mesh->albedo = from.albedo.value_or(Rgb::Constant(static_cast<float>(default_albedo)));
    mesh->emission = from.emission;
    if (from.material) set_material(from, rotation, *mesh);
    meshes.push_back(std::move(mesh));
  }
  return meshes;
}

namespace {

Sun sun_of(const SunDefinition& sun, const std::optional<double>& radius_deg) {
  return {sun.to_sun.cast<float>().normalized(), rgb(sun.irradiance_w_m2),
          static_cast<float>(radius_deg.value_or(sun.angular_radius_deg) * radians_per_degree)};
}

/// The study's suns, else the file's.
std::vector<Sun> scene_suns(const SceneDefinition& definition, const SceneFile& file) {
  std::vector<Sun> suns;
  if (definition.suns) {
    for (const SunDefinition& sun : *definition.suns) suns.push_back(sun_of(sun, definition.sun_radius_deg));
  } else if (definition.sun) {
    suns.push_back(sun_of(*definition.sun, definition.sun_radius_deg));
  } else {
    for (const FileSun& sun : file.suns)
      suns.push_back({sun.to_sun.cast<float>().normalized(), sun.irradiance_w_m2,
                      static_cast<float>(definition.sun_radius_deg.value_or(0) * radians_per_degree)});
  }
  if (definition.sun_radius_deg && suns.empty())
    throw input_error({.file = definition.path.string(),
                       .field = "sun_radius_deg of the scene \"" + definition.name + "\"",
                       .wanted = "a sun in the scene file, or a [scene.sun] in the study file",
                       .found = "none"});
  return suns;
}

/// The study's lamps, else the file's.
std::vector<Lamp> scene_lamps(const SceneDefinition& definition, const SceneFile& file,
                              const Eigen::Vector3d& centre_m) {
  std::vector<Lamp> lamps;
  if (definition.lamps) {
    for (const LampDefinition& lamp : *definition.lamps)
      lamps.push_back({(lamp.position_m - centre_m).cast<float>(), rgb(lamp.intensity_w_sr), lamp.is_spot,
                       lamp.shines_along.cast<float>(),
                       static_cast<float>(std::cos(lamp.inner_deg * radians_per_degree)),
                       static_cast<float>(std::cos(lamp.outer_deg * radians_per_degree))});
    return lamps;
  }
  for (const FileLamp& lamp : file.lamps)
    lamps.push_back({(lamp.position_m - centre_m).cast<float>(), lamp.intensity_w_sr, lamp.is_spot,
                     lamp.shines_along.cast<float>(), static_cast<float>(std::cos(lamp.inner_rad)),
                     static_cast<float>(std::cos(lamp.outer_rad))});
  return lamps;
}

}  // namespace

std::vector<std::string> left_out_sentences(const TruthScene& scene) {
  std::vector<std::string> sentences(scene.left_out.begin(), scene.left_out.end());
  if (scene.left_out_of_diffuse.empty()) return sentences;
  std::string names;
  for (const std::string& one : scene.left_out_of_diffuse)
    names += (names.empty() ? "" : ", ") + printable(one);
  sentences.push_back(
      fmt::format("{}: its files have {}, which materials = \"{}\" leaves out; \"gltf\" is the other model",
                  scene.definition.name, names, word(scene.definition.materials)));
  return sentences;
}

Light scene_light(const SceneDefinition& definition, const SceneFile& file, const Eigen::Vector3d& centre_m) {
  Light light;
  light.environment_radiance = rgb(definition.environment_radiance);
  light.bounces = definition.bounces;
  light.ambient_occlusion = definition.ambient_occlusion;
  if (definition.ambient_occlusion) {
    light.bounces = 0;
    light.sky_distance_m = static_cast<float>(definition.ao_distance_m);
    return light;
  }
  if (const auto& map = definition.environment) {
    light.environment_radiance = Rgb::Zero();
    light.environment = std::make_shared<EnvironmentMap>(
        read_environment_map(map->path), static_cast<float>(map->rotation_deg * radians_per_degree),
        Rgb::Constant(static_cast<float>(map->strength)));
  }
  light.suns = scene_suns(definition, file);
  light.lamps = scene_lamps(definition, file, centre_m);
  return light;
}

Camera scene_camera(const SceneDefinition& definition, const SceneFile& file, int width_px, int height_px,
                    Eigen::Vector3d& camera_position_m) {
  Camera camera;
  camera.width_px = width_px;
  camera.height_px = height_px;
  if (definition.camera) {
    const CameraDefinition& given = *definition.camera;
    const Eigen::Vector3d back = (given.position_m - given.look_at_m).normalized();
    if (is_panorama(given)) {
      camera_position_m = given.position_m;
      return panorama_camera(width_px, height_px, static_cast<float>(std::atan2(-back.x(), back.z())), true);
    }
    const Eigen::Vector3d right = Eigen::Vector3d::UnitY().cross(back).normalized();
    Eigen::Matrix3d axes;
    axes << right, back.cross(right), back;
    camera.axes = axes.cast<float>();
    camera.tan_half_horizontal =
        static_cast<float>(std::tan(0.5 * given.horizontal_fov_deg * radians_per_degree));
    camera_position_m = given.position_m;
    return camera;
  }
  if (!file.camera)
    throw input_error({.file = definition.path.string(),
                       .wanted = "a camera in the scene file, or a [scene.camera] in the study file",
                       .found = "none"});
  camera.axes = file.camera->axes.cast<float>();
  camera.tan_half_horizontal =
      static_cast<float>(std::tan(0.5 * file.camera->vertical_fov_rad) * width_px / height_px);
  camera_position_m = file.camera->position_m;
  return camera;
}

void add_emitters(std::span<const std::shared_ptr<const SurfaceMesh>> background, Light& light) {
  auto emitters = std::make_shared<EmittingSurfaces>(background);
  if (!emitters->empty()) light.emitters = std::move(emitters);
}

Eigen::Affine3d standing_placement(const ObjectDefinition& object, const SceneFile& file,
                                   const TruthScene& scene, std::vector<std::string>& rests) {
  const Eigen::Affine3d placement = object_placement(object);
  if (!object.rest) return placement;
  const RestingObject at_rest =
      rested(file, placement, ground_of(scene.background, scene.camera_position_m),
             "rest of the object \"" + object.name + "\" of the scene \"" + scene.definition.name + "\"");
  rests.push_back(rest_sentence(scene.definition.name + ": " + object.name, at_rest));
  return at_rest.placement;
}

namespace {

void note_left_out(const SceneFile& file, const std::vector<std::string>& unused, TruthScene& scene) {
  scene.left_out_of_diffuse.insert(file.left_out_of_diffuse.begin(), file.left_out_of_diffuse.end());
  if (std::string sentence = left_out_sentence(file, unused); !sentence.empty())
    scene.left_out.insert(std::move(sentence));
}

/// What of the scene's own file the study's camera, suns and lamps stand for.
std::vector<std::string> unused_of_scene(const SceneDefinition& definition, const SceneFile& file) {
  std::vector<std::string> unused;
  if (definition.camera && file.camera) unused.emplace_back("its camera (the study has one)");
  const std::string reason =
      definition.ambient_occlusion ? " (ambient_occlusion has none)" : " (the study's stand for them)";
  if ((definition.suns || definition.sun || definition.ambient_occlusion) && !file.suns.empty())
    unused.emplace_back("its suns" + reason);
  if ((definition.lamps || definition.ambient_occlusion) && !file.lamps.empty())
    unused.emplace_back("its lamps" + reason);
  return unused;
}

/// At a moment of an animation there may be nothing to see.
void require_shown(const SceneFile& scene, const std::string& named, const std::filesystem::path& path,
                   const std::string& what) {
  if (split_moment(named).moment)
    require_triangles(scene, path.string(), what);
  else
    require_surface(scene, path.string(), what);
}

}  // namespace

SceneFile read_object_file(const ObjectDefinition& object, const SceneDefinition& scene) {
  SceneFile file = read_scene_moment(object.path, scene.materials, Transparency::refused,
                                     split_moment(object.file).moment);
  for (FileMesh& mesh : file.meshes) set_layer(scene, mesh);
  return file;
}

TruthScene load_truth_scene(const SceneDefinition& definition, int width_px, int height_px) {
  TruthScene scene;
  scene.definition = definition;
  const SceneFile background = read_scene_moment(definition.path, definition.materials, Transparency::refused,
                                                 split_moment(definition.file).moment);
  require_shown(background, definition.file, definition.path, "a scene");
  scene.camera = view_camera(
      scene_camera(definition, background, width_px, height_px, scene.camera_position_m), definition.view);
  scene.light = scene_light(definition, background, scene.camera_position_m);
  note_left_out(background, unused_of_scene(definition, background), scene);
  scene.background =
      place_meshes(background, Eigen::Affine3d::Identity(), scene.camera_position_m, definition.albedo, 0);
  if (!definition.ambient_occlusion) cut_where_lit(scene.background);
  if (!definition.ambient_occlusion) add_emitters(scene.background, scene.light);
  scene.objects.resize(definition.objects.size());
  for (std::size_t i = 0; i < definition.objects.size(); ++i) {
    const ObjectDefinition& object = definition.objects[i];
    SceneFile file = read_object_file(object, definition);
    require_shown(file, object.file, object.path, "an object");
    note_left_out(file, camera_and_lights(file), scene);
    scene.objects[i] = place_meshes(file, standing_placement(object, file, scene, scene.rests),
                                    scene.camera_position_m, definition.albedo, static_cast<int>(i) + 1);
  }
  if (!scene.light.lamps.empty())
    add_bright_patches(scene.background, scene.geometry(true, scene.object_indices()), scene.light);
  return scene;
}

}  // namespace seamline::renderer
