#include "renderer/depth/gltf_write.h"

#include <tiny_gltf.h>

#include <span>

#include "support/files/gltf_writing.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

tinygltf::Model model_of(const DepthMesh& mesh) {
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "seamline";
  model.buffers.emplace_back();
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  const int positions =
      add_accessor(model, std::as_bytes(std::span(mesh.vertices_m)),
                   {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER});
  Eigen::Vector3f least = mesh.vertices_m.front(), most = mesh.vertices_m.front();
  for (const Eigen::Vector3f& vertex : mesh.vertices_m) {
    least = least.cwiseMin(vertex);
    most = most.cwiseMax(vertex);
  }
  model.accessors.back().minValues = {least.x(), least.y(), least.z()};
  model.accessors.back().maxValues = {most.x(), most.y(), most.z()};
  primitive.attributes["POSITION"] = positions;
  primitive.indices = add_accessor(
      model, std::as_bytes(std::span(mesh.triangles)),
      {TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER});
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
  write_glb_file(path, model_of(mesh));
}

}  // namespace seamline::renderer
