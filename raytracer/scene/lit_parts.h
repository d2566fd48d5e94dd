#pragma once
#include <memory>
#include <vector>

#include "raytracer/tracing/mesh.h"

namespace seamline::renderer {

/// Cuts surfaces whose emission texture is lit in a small part of them only: triangles become grids of
/// smaller ones, and those that emit are meshes of their own, by how brightly. Light is asked of surfaces
/// that emit by the largest emission of their mesh; of a screen with one lit texel in four thousand it was
/// found once in four thousand questions, as one bright speck, and pictures without a speck yet had no error
/// to tell. Other meshes, and those lit in more than a quarter, are left as they are.
void cut_where_lit(std::vector<std::shared_ptr<const SurfaceMesh>>& meshes);

}  // namespace seamline::renderer
