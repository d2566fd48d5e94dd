#include "raytracer/scene/visible_objects.h"

#include <fmt/core.h>
#include <algorithm>

#include "raytracer/scene/camera.h"
#include "support/text/error.h"

namespace seamline::renderer {

std::array<std::int64_t, 4> visible_pixels(const Camera& camera, const Geometry& everything) {
  std::array<std::int64_t, 4> count{};
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x)
      if (const auto hit = everything.nearest(centre_ray(camera, x, y)))
        ++count[static_cast<std::size_t>(hit->object_index)];
  return count;
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
  const std::array<std::int64_t, 4> seen = visible_pixels(scene.camera, scene.geometry(true, {1, 2, 3}));
  for (std::size_t i = 1; i < seen.size(); ++i)
    if (seen[i] == 0)
      throw input_error({.file = study.file.string(),
                         .field = fmt::format("scene \"{}\", object \"{}\"", scene.definition.name,
                                              scene.definition.objects[i - 1].name),
                         .wanted = "an object that covers at least one pixel of the picture",
                         .found = "none"});
}

}  // namespace seamline::renderer
