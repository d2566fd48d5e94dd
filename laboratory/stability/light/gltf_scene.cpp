#include "laboratory/stability/light/gltf_scene.h"

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include "support/files/atomic_file.h"

namespace seamline::stability {
namespace {

constexpr int float_type = 5126, unsigned_type = 5125;

/// One glTF buffer that accessors are appended to.
struct Buffer {
  std::string bytes;
  nlohmann::json views = nlohmann::json::array(), accessors = nlohmann::json::array();

  int add(const void* data, std::size_t size, std::size_t count, int component, const char* type) {
    views.push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}});
    bytes.append(static_cast<const char*>(data), size);
    accessors.push_back(
        {{"bufferView", views.size() - 1}, {"componentType", component}, {"count", count}, {"type", type}});
    return static_cast<int>(accessors.size()) - 1;
  }
};

}  // namespace

void write_gltf_scene(const std::filesystem::path& path, const std::vector<PartPointer>& parts,
                      const RootNode& root) {
  Buffer buffer;
  nlohmann::json nodes = nlohmann::json::array(), meshes = nlohmann::json::array(),
                 children = nlohmann::json::array();
  nodes.push_back({{"translation", {root.translation_m.x(), root.translation_m.y(), root.translation_m.z()}},
                   {"scale", {root.scale, root.scale, root.scale}}});
  for (const PartPointer& part : parts) {
    const int positions =
        buffer.add(part->positions_m.data(), part->positions_m.size() * sizeof(Eigen::Vector3f),
                   part->positions_m.size(), float_type, "VEC3");
    const int indices = buffer.add(part->triangles.data(), part->triangles.size() * sizeof(Triangle),
                                   part->triangles.size() * 3, unsigned_type, "SCALAR");
    meshes.push_back({{"primitives", {{{"attributes", {{"POSITION", positions}}}, {"indices", indices}}}}});
    nodes.push_back({{"mesh", meshes.size() - 1}});
    children.push_back(nodes.size() - 1);
  }
  nodes.push_back({{"camera", 0}});
  children.push_back(nodes.size() - 1);
  nodes[0]["children"] = children;
  const std::filesystem::path binary = std::filesystem::path(path).replace_extension(".bin");
  write_file_atomically(binary, std::string_view(buffer.bytes));
  const nlohmann::json gltf = {
      {"asset", {{"version", "2.0"}}},
      {"buffers", {{{"byteLength", buffer.bytes.size()}, {"uri", binary.filename().string()}}}},
      {"bufferViews", buffer.views},
      {"accessors", buffer.accessors},
      {"meshes", meshes},
      {"cameras", {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.01}}}}}},
      {"nodes", nodes},
      {"scenes", {{{"nodes", {0}}}}},
      {"scene", 0}};
  write_file_atomically(path, std::string_view(gltf.dump()));
}

}  // namespace seamline::stability
