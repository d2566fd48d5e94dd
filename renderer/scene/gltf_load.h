#pragma once
#include <filesystem>

namespace tinygltf {
class Model;
}

namespace seamline::renderer {

/// Reads a .gltf or .glb file with the buffers it names; pictures, textures, animations, skins and extras
/// are left out unread. The library that does it trusts what it reads in several places, so the file's size,
/// the depth of its nesting and the sizes of its buffers are checked first (limits.h), and buffers are read
/// only from the file's own folder or below it. Throws InputError naming the file and what in it is wrong.
[[nodiscard]] tinygltf::Model load_gltf(const std::filesystem::path& path);

}  // namespace seamline::renderer
