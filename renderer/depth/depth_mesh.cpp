#include "renderer/depth/depth_mesh.h"

#include <algorithm>
#include <stdexcept>

#include "renderer/depth/adaptive_mesh.h"
#include "renderer/depth/dense_sphere.h"
#include "renderer/depth/full_mesh.h"

namespace seamline::renderer {
namespace {

DepthMesh build_from_clean_map(const DepthMap& map, const MeshOptions& options) {
  const DenseSphere sphere = make_dense_sphere(map, options.yaw_texels, options.threads);
  switch (options.density) {
    case MeshDensity::adaptive:
      return build_adaptive_mesh(sphere, options.tolerance, options.threads);
    case MeshDensity::full:
      return build_full_mesh(sphere, options.threads);
  }
  throw std::logic_error("a mesh density that is neither adaptive nor full");
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

}  // namespace seamline::renderer
