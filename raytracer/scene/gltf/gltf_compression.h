#pragma once
#include <filesystem>

#include "raytracer/scene/gltf/gltf_json.h"

namespace seamline::renderer {

/// Undoes EXT_meshopt_compression (and KHR_meshopt_compression of the same codec) and
/// KHR_draco_mesh_compression: decoded bytes become buffers of their own, and buffer views, accessors and
/// primitives name those. What lies uncompressed in the file beside it is left as it is. Throws InputError
/// naming the extension: damaged bytes, too many of them, or a build without the library, with the way round.
void undo_compression(GltfJson& json, GltfBuffers& buffers, const std::filesystem::path& path);

}  // namespace seamline::renderer
