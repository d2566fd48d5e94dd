#pragma once
#include <filesystem>

#include "renderer/depth/depth_mesh.h"

namespace seamline::renderer {

/// Writes a depth mesh as a .glb file (metres, +Y up, origin at the panorama's centre), atomically.
void write_depth_mesh(const std::filesystem::path& path, const DepthMesh& mesh);

}  // namespace seamline::renderer
