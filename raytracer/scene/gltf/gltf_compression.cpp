#include "raytracer/scene/gltf/gltf_compression.h"

#include <fmt/core.h>

#include <array>
#include <cstring>
#include <map>
#include <string_view>
#include <utility>

#include "raytracer/scene/gltf/draco_mesh.h"
#include "raytracer/scene/gltf/meshopt_view.h"
#include "support/text/limits.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;

constexpr const char* draco_extension = "KHR_draco_mesh_compression";

/// Where compressed bytes lie.
struct ByteRange {
  std::int64_t buffer = -1, offset = 0, length = 0;
};

std::string_view compressed_bytes(const ByteRange& range, const GltfBuffers& buffers, const fs::path& path,
                                  const std::string& field) {
  const bool inside = range.buffer >= 0 && std::cmp_less(range.buffer, buffers.size()) && range.offset >= 0 &&
                      range.length > 0 && std::cmp_less_equal(range.length, buffers[range.buffer].size()) &&
                      std::cmp_less_equal(range.offset, buffers[range.buffer].size() -
                                                            static_cast<std::size_t>(range.length));
  if (!inside)
    throw bad_gltf(path, field, "compressed bytes inside their buffer",
                   fmt::format("{} from byte {} of buffer {}", range.length, range.offset, range.buffer));
  const auto& bytes = buffers[range.buffer];
  return {reinterpret_cast<const char*>(bytes.data()) + range.offset, static_cast<std::size_t>(range.length)};
}

/// Adds decoded bytes as a buffer; its number.
std::int64_t add_buffer(std::vector<unsigned char> bytes, GltfBuffers& buffers, const fs::path& path,
                        const std::string& field) {
  std::size_t total = bytes.size();
  for (const auto& buffer : buffers) total += buffer.size();
  if (std::cmp_greater(total, limits::largest_scene_file_bytes))
    throw bad_gltf(path, field,
                   fmt::format("buffers of at most {} bytes together", limits::largest_scene_file_bytes),
                   "more after they are decoded");
  buffers.push_back(std::move(bytes));
  return static_cast<std::int64_t>(buffers.size()) - 1;
}

const GltfJson* meshopt_extension(const GltfJson& view) {
  const GltfJson* extensions = member(view, "extensions");
  if (extensions == nullptr) return nullptr;
  const GltfJson* extension = member(*extensions, "EXT_meshopt_compression");
  return extension != nullptr ? extension : member(*extensions, "KHR_meshopt_compression");
}

void undo_meshopt(GltfJson& view, const std::string& field, GltfBuffers& buffers, const fs::path& path) {
  const GltfJson* extension = meshopt_extension(view);
  if (extension == nullptr) return;
  const std::int64_t usual = whole_number(view, "buffer", -1);
  if (usual >= 0 && std::cmp_less(usual, buffers.size()) && !buffers[usual].empty())
    return;  // its bytes lie there uncompressed as well
  if (!has_meshopt())
    throw bad_gltf(path, "EXT_meshopt_compression",
                   "Seamline built with meshoptimizer (Debian: libmeshoptimizer-dev), or a file without this "
                   "compression (gltfpack -i IN -o OUT -noq undoes it)",
                   "a build without it");
  const std::int64_t count = whole_number(*extension, "count", 0),
                     stride = whole_number(*extension, "byteStride", 0);
  if (count < 1 || stride < 1 || stride > 256 || count > limits::largest_scene_file_bytes / stride)
    throw bad_gltf(path, field, "a count and a byteStride up to 256",
                   fmt::format("{} and {}", count, stride));
  const MeshoptView what{.mode = text_of(*extension, "mode"),
                         .filter = text_of(*extension, "filter"),
                         .count = static_cast<std::size_t>(count),
                         .stride = static_cast<std::size_t>(stride)};
  const std::string_view bytes =
      compressed_bytes({whole_number(*extension, "buffer", -1), whole_number(*extension, "byteOffset", 0),
                        whole_number(*extension, "byteLength", 0)},
                       buffers, path, field);
  auto decoded = decode_meshopt(bytes, what);
  if (!decoded)
    throw bad_gltf(
        path, field, "bytes compressed as EXT_meshopt_compression says",
        fmt::format("others (mode {}, filter {})", what.mode, what.filter.empty() ? "NONE" : what.filter));
  view["byteLength"] = decoded->size();
  view["byteOffset"] = 0;
  view["buffer"] = add_buffer(std::move(*decoded), buffers, path, field);
}

/// The meshes of a file that Draco compressed, each decoded once.
class DracoMeshes {
 public:
  DracoMeshes(GltfJson& json, GltfBuffers& buffers, const fs::path& path)
      : json_(json), buffers_(buffers), path_(path) {}

  void undo(GltfJson& primitive, const std::string& field) {
    const GltfJson* extensions = member(primitive, "extensions");
    const GltfJson* extension = extensions != nullptr ? member(*extensions, draco_extension) : nullptr;
    const GltfJson* ids = extension != nullptr ? member(*extension, "attributes") : nullptr;
    if (ids == nullptr || !ids->is_object() || !is_needed(primitive)) return;
    const DracoMesh& mesh = decoded(whole_number(*extension, "bufferView", -1), field);
    GltfJson& attributes = primitive["attributes"];
    for (const auto& [name, id] : ids->items()) {
      const auto found = mesh.attributes.find(id.is_number_integer() ? id.get<int>() : -1);
      if (found == mesh.attributes.end())
        throw bad_gltf(path_, field, fmt::format("{} in the mesh that Draco compressed", name), "none");
      const GltfJson* accessor = accessor_of(attributes, name.c_str());
      const GltfJson* normalised = accessor != nullptr ? member(*accessor, "normalized") : nullptr;
      const bool is_normalised = normalised != nullptr && normalised->is_boolean() && normalised->get<bool>();
      attributes[name] = add_accessor(found->second, mesh.vertices, is_normalised, field);
    }
    DracoAttribute corners{.component_type = 5125, .components = 1, .bytes = {}};
    corners.bytes.resize(mesh.corners.size() * sizeof(std::uint32_t));
    std::memcpy(corners.bytes.data(), mesh.corners.data(), corners.bytes.size());
    primitive["indices"] = add_accessor(corners, mesh.corners.size(), false, field);
    primitive["mode"] = 4;
    primitive["extensions"].erase(draco_extension);
  }

 private:
  [[nodiscard]] const GltfJson* accessor_of(const GltfJson& object, const char* key) const {
    const std::int64_t index = whole_number(object, key, -1);
    const GltfJson* all = member(json_, "accessors");
    if (all == nullptr || index < 0 || std::cmp_greater_equal(index, all->size())) return nullptr;
    return &(*all)[index];
  }

  /// Whether one of its accessors has no bytes of its own.
  [[nodiscard]] bool is_needed(const GltfJson& primitive) const {
    const GltfJson* attributes = member(primitive, "attributes");
    if (attributes == nullptr || !attributes->is_object()) return false;
    const auto lacks = [](const GltfJson* accessor) {
      return accessor != nullptr && member(*accessor, "bufferView") == nullptr;
    };
    if (lacks(accessor_of(primitive, "indices"))) return true;
    for (const auto& [name, index] : attributes->items())
      if (lacks(accessor_of(*attributes, name.c_str()))) return true;
    return false;
  }

  const DracoMesh& decoded(std::int64_t view, const std::string& field) {
    if (const auto known = known_.find(view); known != known_.end()) return known->second;
    if (!has_draco())
      throw bad_gltf(path_, draco_extension,
                     "Seamline built with Draco (Debian: libdraco-dev), or a file without this compression "
                     "(`gltf-transform copy IN OUT` undoes it)",
                     "a build without it");
    const GltfJson* views = member(json_, "bufferViews");
    if (views == nullptr || view < 0 || std::cmp_greater_equal(view, views->size()))
      throw bad_gltf(path_, field, "a buffer view that exists", std::to_string(view));
    const GltfJson& from = (*views)[view];
    const std::string_view bytes =
        compressed_bytes({whole_number(from, "buffer", -1), whole_number(from, "byteOffset", 0),
                          whole_number(from, "byteLength", 0)},
                         buffers_, path_, field);
    auto mesh = decode_draco(bytes, static_cast<std::uint32_t>(limits::largest_scene_vertices),
                             static_cast<std::uint32_t>(limits::largest_scene_triangles));
    if (!mesh)
      throw bad_gltf(path_, field, fmt::format("a mesh compressed as {} says", draco_extension),
                     "damaged bytes, or too many of them");
    return known_.emplace(view, std::move(*mesh)).first->second;
  }

  std::size_t add_accessor(const DracoAttribute& attribute, std::size_t count, bool normalised,
                           const std::string& field) {
    static constexpr std::array<const char*, 4> types = {"SCALAR", "VEC2", "VEC3", "VEC4"};
    const std::int64_t buffer =
        add_buffer({attribute.bytes.begin(), attribute.bytes.end()}, buffers_, path_, field);
    GltfJson& views = json_["bufferViews"];
    views.push_back({{"buffer", buffer}, {"byteLength", attribute.bytes.size()}});
    GltfJson& accessors = json_["accessors"];
    accessors.push_back({{"bufferView", views.size() - 1},
                         {"componentType", attribute.component_type},
                         {"normalized", normalised},
                         {"count", count},
                         {"type", types[attribute.components - 1]}});
    return accessors.size() - 1;
  }

  GltfJson& json_;
  GltfBuffers& buffers_;
  const fs::path& path_;
  std::map<std::int64_t, DracoMesh> known_;
};

}  // namespace

void undo_compression(GltfJson& json, GltfBuffers& buffers, const fs::path& path) {
  for (std::size_t i = 0; i < count_of(json, "bufferViews"); ++i)
    undo_meshopt(json["bufferViews"][i], fmt::format("bufferViews[{}]", i), buffers, path);
  DracoMeshes draco(json, buffers, path);
  for (std::size_t m = 0; m < count_of(json, "meshes"); ++m) {
    GltfJson& mesh = json["meshes"][m];
    for (std::size_t p = 0; p < count_of(mesh, "primitives"); ++p)
      draco.undo(mesh["primitives"][p], fmt::format("meshes[{}].primitives[{}]", m, p));
  }
}

}  // namespace seamline::renderer
