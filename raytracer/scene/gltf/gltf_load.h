#pragma once
#include <filesystem>
#include <vector>

#include "raytracer/scene/gltf/gltf_extensions.h"
#include "raytracer/scene/gltf/gltf_json.h"

namespace tinygltf {
class Model;
}

namespace seamline::renderer {

/// Reads a .gltf or .glb file with the buffers it names, uncompressed. Of images, textures and samplers it
/// has what the file says of them; no picture is read. What of the file nobody will look at is added to
/// `left_out`. The library that does it trusts what it reads in several places, so the file's size, the depth
/// of its nesting and the sizes of its buffers are checked first (limits.h), and buffers are read only from
/// the file's own folder or below it. Throws InputError naming the file and what in it is wrong.
/// `animations`, where it is asked for, gets the file's table of them, unread.
[[nodiscard]] tinygltf::Model load_gltf(const std::filesystem::path& path, LeftOut& left_out,
                                        GltfJson* animations = nullptr);

/// The files of buffers, then of pictures, that a .gltf or .glb file names: those that are there, in its
/// folder or below it, as its readers open them. Of a .glb only the JSON is read. Empty for a file that
/// cannot be read, of which `load_gltf` says what is wrong.
[[nodiscard]] std::vector<std::filesystem::path> files_named_by_gltf(const std::filesystem::path& path);

}  // namespace seamline::renderer
