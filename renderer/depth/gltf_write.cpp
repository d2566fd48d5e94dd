#include "renderer/depth/gltf_write.h"

#include <tiny_gltf.h>

#include <cstring>
#include <sstream>
#include <stdexcept>

#include "support/files/atomic_file.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

int add_accessor(tinygltf::Model& model, const void* data, std::size_t bytes, std::size_t count,
                 int component_type, int type, int target) {
  std::vector<unsigned char>& buffer = model.buffers[0].data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = buffer.size();
  view.byteLength = bytes;
  view.target = target;
  buffer.resize(buffer.size() + bytes);
  std::memcpy(buffer.data() + view.byteOffset, data, bytes);
  model.bufferViews.push_back(view);
  tinygltf::Accessor accessor;
  accessor.bufferView = static_cast<int>(model.bufferViews.size()) - 1;
  accessor.componentType = component_type;
  accessor.type = type;
  accessor.count = count;
  model.accessors.push_back(accessor);
  return static_cast<int>(model.accessors.size()) - 1;
}

tinygltf::Model model_of(const DepthMesh& mesh) {
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "seamline";
  model.buffers.emplace_back();
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  const int positions = add_accessor(
      model, mesh.vertices_m.data(), mesh.vertices_m.size() * sizeof(Eigen::Vector3f), mesh.vertices_m.size(),
      TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER);
  Eigen::Vector3f least = mesh.vertices_m.front(), most = mesh.vertices_m.front();
  for (const Eigen::Vector3f& vertex : mesh.vertices_m) {
    least = least.cwiseMin(vertex);
    most = most.cwiseMax(vertex);
  }
  model.accessors.back().minValues = {least.x(), least.y(), least.z()};
  model.accessors.back().maxValues = {most.x(), most.y(), most.z()};
  primitive.attributes["POSITION"] = positions;
  primitive.indices =
      add_accessor(model, mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]),
                   mesh.triangles.size() * 3, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR,
                   TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  tinygltf::Mesh part;
  part.name = "local scene";
  part.primitives.push_back(primitive);
  model.meshes.push_back(part);
  tinygltf::Node node;
  node.name = part.name;
  node.mesh = 0;
  model.nodes.push_back(node);
  model.scenes.emplace_back();
  model.scenes[0].nodes.push_back(0);
  model.defaultScene = 0;
  return model;
}

}  // namespace

void write_depth_mesh(const std::filesystem::path& path, const DepthMesh& mesh) {
  if (mesh.triangles.empty())
    throw input_error({.file = path.string(), .wanted = "a depth map with a surface", .found = "only holes"});
  const tinygltf::Model model = model_of(mesh);
  std::ostringstream bytes;  // the writer does not notice a disk that is full
  tinygltf::TinyGLTF writer;
  if (!writer.WriteGltfSceneToStream(&model, bytes, false, true))
    throw std::logic_error("the scene cannot be written as glTF");
  write_file_atomically(path, std::move(bytes).str());
}

}  // namespace seamline::renderer
