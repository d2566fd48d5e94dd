#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

namespace tinygltf {
class Model;
}

namespace seamline {

/// What the values of an accessor are, in glTF's numbers (tinygltf's TINYGLTF_ constants).
struct AccessorKind {
  int component_type = 0;  ///< e.g. TINYGLTF_COMPONENT_TYPE_FLOAT
  int type = 0;            ///< e.g. TINYGLTF_TYPE_VEC3
  int target = 0;          ///< e.g. TINYGLTF_TARGET_ARRAY_BUFFER
};

/// Appends values to the model's first buffer, which must be there, and describes them. Returns the number of
/// the new accessor.
int add_accessor(tinygltf::Model& model, std::span<const std::byte> values, const AccessorKind& kind);

/// Writes a model as a .glb file, whole or not at all. Throws InputError when the path cannot be written.
void write_glb_file(const std::filesystem::path& path, const tinygltf::Model& model);

}  // namespace seamline
