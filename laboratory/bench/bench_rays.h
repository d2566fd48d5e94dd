#pragma once
#include <string>
#include <vector>

#include "renderer/estimators/path/path_truth_pass.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::renderer {

/// The rays that a path-tracing pass asks of one geometry, in the order in which it asks them: pixel by pixel
/// in tiles of 4 x 4, so that neighbours follow each other.
struct RecordedRays {
  std::vector<Ray> primary;  ///< from the camera, which is the panorama's centre
  std::vector<Ray> sun;      ///< from what primary rays hit, to the sun
  std::vector<Ray> bounce;   ///< from there and later vertices of a path, cosine-distributed
};

/// The primary rays of the whole photograph, and one path of at most three vertices through every pixel of
/// every `tile_row_step`th row of tiles.
[[nodiscard]] RecordedRays record_rays(const TruthScene& scene, const Geometry& geometry, int tile_row_step);

/// A built-in scene with its objects, as the isolated study renders it.
[[nodiscard]] SceneDefinition bench_scene(const std::string& name);

}  // namespace seamline::renderer
