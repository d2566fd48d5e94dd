#include "raytracer/scene/visible_objects.h"

#include <fmt/core.h>
#include <algorithm>

#include "raytracer/scene/camera.h"
#include "stimuli/definition/parts/task_definition.h"
#include "support/text/error.h"

namespace seamline::renderer {

std::vector<VisiblePixels> visible_pixels(const Camera& camera, const Geometry& everything,
                                          std::size_t objects) {
  std::vector<VisiblePixels> seen(objects + 1);
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x)
      if (const auto hit = everything.nearest(centre_ray(camera, x, y))) {
        VisiblePixels& of = seen[hit->object_index];
        ++of.count;
        of.sum_x_px += x;
      }
  return seen;
}

void require_same_camera(const StudyDefinition& study, const TruthScene& now, const TruthScene& then) {
  if (now.camera_position_m == then.camera_position_m && now.camera.axes == then.camera.axes) return;
  throw input_error({.file = study.file.string(),
                     .field = fmt::format("scene \"{}\", animation", now.definition.name),
                     .wanted = "depth of the picture's own moment beside a camera that moves",
                     .found = "late or held depth"});
}

void require_mirrors(const StudyDefinition& study, const TruthScene& scene) {
  const std::vector<Artifact>& artifacts = scene.definition.artifacts;
  if (std::find(artifacts.begin(), artifacts.end(), Artifact::reflection) == artifacts.end()) return;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const auto& meshes = scene.objects[i];
    const bool mirrors = std::any_of(meshes.begin(), meshes.end(),
                                     [](const auto& mesh) { return mesh->f0.maxCoeff() > 0.0F; });
    if (!mirrors)
      throw input_error({.file = study.file.string(),
                         .field = fmt::format("scene \"{}\", object \"{}\"", scene.definition.name,
                                              scene.definition.objects[i].name),
                         .wanted = "a glossy object for the artifact reflection (materials = \"gltf\")",
                         .found = "a diffuse one"});
  }
}

void require_visible_objects(const StudyDefinition& study, const TruthScene& scene) {
  const std::vector<VisiblePixels> seen =
      visible_pixels(scene.camera, scene.geometry(true, scene.object_indices()), scene.objects.size());
  const auto complaint = [&](std::size_t object, const std::string& wanted, const std::string& found) {
    return input_error({.file = study.file.string(),
                        .field = fmt::format("scene \"{}\", object \"{}\"", scene.definition.name,
                                             scene.definition.objects[object - 1].name),
                        .wanted = wanted,
                        .found = found});
  };
  for (std::size_t i = 1; i < seen.size(); ++i)
    if (seen[i].count == 0)
      throw complaint(i, "an object that covers at least one pixel of the picture", "none");
  if (scene.objects.size() == usual_objects) return;
  const auto x_px = [&](std::size_t i) { return seen[i].sum_x_px / static_cast<double>(seen[i].count); };
  for (std::size_t i = 2; i < seen.size(); ++i)
    if (x_px(i) <= x_px(i - 1))
      throw complaint(i, "objects in the order in which they stand in the picture, from left to right",
                      fmt::format("one left of \"{}\"", scene.definition.objects[i - 2].name));
}

}  // namespace seamline::renderer
