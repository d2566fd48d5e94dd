#include "renderer/depth_mesh.h"

#include <algorithm>

#include "renderer/dense_sphere.h"
#include "renderer/full_mesh.h"

namespace seamline {
namespace {

DepthMesh build_from_clean_map(const DepthMap& map, const MeshOptions& options) {
  const DenseSphere sphere = make_dense_sphere(map, options.yaw_texels, options.threads);
  // The adaptive mesh is still to come; full density meets every tolerance.
  return build_full_mesh(sphere, options.threads);
}

}  // namespace

DepthMesh build_depth_mesh(const DepthMap& map, const MeshOptions& options) {
  // Maps from files are clean; only one that was filled by hand has to be copied.
  const bool clean = std::none_of(map.distance_m.begin(), map.distance_m.end(), [](float distance_m) {
    return !(distance_m > 0) || (distance_m >= 1e9F && !is_hole(distance_m));
  });
  if (clean) return build_from_clean_map(map, options);
  DepthMap cleaned = map;
  clean_holes(cleaned);
  return build_from_clean_map(cleaned, options);
}

}  // namespace seamline
