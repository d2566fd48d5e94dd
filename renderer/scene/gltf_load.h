#pragma once
#include <filesystem>
#include <string>

namespace tinygltf {
class Model;
}

namespace seamline::renderer {

/// Reads a .gltf or .glb file with the buffers it names. Of images, textures and samplers it has what the
/// file says of them; no picture is read. Animations, skins and extras are left out. The library that does it
/// trusts what it reads in several places, so the file's size, the depth of its nesting and the sizes of its
/// buffers are checked first (limits.h), and buffers are read only from the file's own folder or below it.
/// Throws InputError naming the file and what in it is wrong.
[[nodiscard]] tinygltf::Model load_gltf(const std::filesystem::path& path);

/// The name of the file that a URI of a glTF file names: %20 and its like are decoded.
[[nodiscard]] std::string file_of_uri(const std::string& uri);

}  // namespace seamline::renderer
