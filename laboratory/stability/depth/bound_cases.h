#pragma once
#include <functional>

#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/stability_case.h"
#include "laboratory/stability/depth/depth_maps.h"
#include "renderer/depth/adaptive_mesh.h"

namespace seamline::stability {

/// How a dense sphere becomes a mesh within a tolerance; the product's is `build_adaptive_mesh`.
using BoundRule = std::function<DepthMesh(const DenseSphere& sphere, double tolerance)>;
[[nodiscard]] DepthMesh bounded_as_product(const DenseSphere& sphere, double tolerance);

/// Random maps of 32 to 48 px on dense spheres of their own size (the product's are never smaller than 2048),
/// tolerances 1e-5 to 0.1 by chance.
struct RandomMaps {
  int count = 500;
  std::uint64_t seed = 1;
  RandomMapKind kind = {};
};

/// Largest error of any ray of any map over the tolerance asked for.
[[nodiscard]] Finding try_bound(const RandomMaps& maps, const BoundRule& rule = bounded_as_product);
/// Rays through valid vertices that meet nothing, rays through holes that meet something, triangles that face
/// away.
[[nodiscard]] Finding try_holes(const RandomMaps& maps, const BoundRule& rule = bounded_as_product);
/// By how much the mesh's own statement of its largest error is exceeded, relative to the tolerance.
[[nodiscard]] Finding try_reported_error(const RandomMaps& maps, const BoundRule& rule = bounded_as_product);
/// Open or repeated edges of maps without holes.
[[nodiscard]] Finding try_watertight(const RandomMaps& maps, const BoundRule& rule = bounded_as_product);
/// Maps whose mesh differs between one thread and three.
[[nodiscard]] Finding try_threads(const RandomMaps& maps);
/// Maps whose mesh with tolerance 0 is not at full density.
[[nodiscard]] Finding try_tolerance_0(const RandomMaps& maps, const BoundRule& rule = bounded_as_product);

}  // namespace seamline::stability
