#include "support/files/gltf_writing.h"

#include <tiny_gltf.h>

#include <cstring>
#include <sstream>
#include <stdexcept>

#include "support/files/atomic_file.h"

namespace seamline {

int add_accessor(tinygltf::Model& model, std::span<const std::byte> values, const AccessorKind& kind) {
  std::vector<unsigned char>& buffer = model.buffers.at(0).data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = buffer.size();
  view.byteLength = values.size();
  view.target = kind.target;
  buffer.resize(buffer.size() + values.size());
  std::memcpy(buffer.data() + view.byteOffset, values.data(), values.size());
  model.bufferViews.push_back(view);
  tinygltf::Accessor accessor;
  accessor.bufferView = static_cast<int>(model.bufferViews.size()) - 1;
  accessor.componentType = kind.component_type;
  accessor.type = kind.type;
  const int bytes_each = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(kind.component_type)) *
                         tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(kind.type));
  accessor.count = values.size() / static_cast<std::size_t>(bytes_each);
  model.accessors.push_back(accessor);
  return static_cast<int>(model.accessors.size()) - 1;
}

void write_glb_file(const std::filesystem::path& path, const tinygltf::Model& model) {
  std::ostringstream bytes;  // the writer does not notice a disk that is full
  tinygltf::TinyGLTF writer;
  if (!writer.WriteGltfSceneToStream(&model, bytes, false, true))
    throw std::logic_error("the scene cannot be written as glTF");
  write_file_atomically(path, std::move(bytes).str());
}

}  // namespace seamline
