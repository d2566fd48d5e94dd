#include "raytracer/scene/gltf/gltf_buffers.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "raytracer/scene/gltf/gltf_uri.h"
#include "support/files/atomic_file.h"
#include "support/files/confined_path.h"
#include "support/text/limits.h"
#include "support/text/printable.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;

/// Buffers may be read and copied: what they claim is added up first.
void check_sizes(const GltfJson& buffers, const fs::path& path) {
  if (!buffers.is_array() || static_cast<std::int64_t>(buffers.size()) > limits::largest_gltf_buffers)
    throw bad_gltf(path, "buffers", fmt::format("at most {} buffers", limits::largest_gltf_buffers),
                   buffers.is_array() ? std::to_string(buffers.size()) : "no array");
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const std::string field = fmt::format("buffers[{}]", i);
    const GltfJson* length = member(buffers[i], "byteLength");
    if (length == nullptr || !length->is_number_unsigned() || *length == 0)
      throw bad_gltf(path, field + ".byteLength", "a whole number above 0", "none");
    const auto bytes = length->get<std::uint64_t>();
    constexpr auto most = static_cast<std::uint64_t>(limits::largest_scene_file_bytes);
    if (bytes > most || (total += bytes) > most)
      throw bad_gltf(path, field, fmt::format("buffers of at most {} bytes together", most), "more");
  }
}

/// Whether a view of the buffer is compressed, so that its bytes lie in another buffer.
bool is_place_of_compressed_bytes(const GltfJson& json, std::size_t buffer) {
  const GltfJson* views = member(json, "bufferViews");
  if (views == nullptr || !views->is_array()) return false;
  return std::any_of(views->begin(), views->end(), [&](const GltfJson& view) {
    const GltfJson* extensions = member(view, "extensions");
    return extensions != nullptr && std::cmp_equal(whole_number(view, "buffer", -1), buffer) &&
           (member(*extensions, "EXT_meshopt_compression") != nullptr ||
            member(*extensions, "KHR_meshopt_compression") != nullptr);
  });
}

std::string bytes_of_file(const std::string& uri, const fs::path& path, const std::string& field) {
  if (uri.find("://") != std::string::npos)
    throw bad_gltf(path, field, "a file of bytes beside the glTF file",
                   "the address \"" + printable(uri) + "\", which is not fetched");
  const fs::path file = path_below(path.parent_path().empty() ? fs::path(".") : path.parent_path(),
                                   file_of_uri(uri), {.file = path.string(), .field = field});
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    throw bad_gltf(path, field, "a file of bytes beside the glTF file",
                   fmt::format("no file \"{}\"", printable(file.string())));
  return read_file(file, limits::largest_scene_file_bytes);
}

std::vector<unsigned char> buffer_bytes(const GltfJson& json, const GltfJson& buffer, std::size_t index,
                                        const std::optional<std::string>& chunk, const fs::path& path) {
  const std::string field = fmt::format("buffers[{}]", index), uri = text_of(buffer, "uri");
  std::string bytes;
  if (uri.empty()) {
    const bool is_chunk = index == 0 && chunk;
    if (!is_chunk && is_place_of_compressed_bytes(json, index)) return {};
    if (!is_chunk) throw bad_gltf(path, field, "a uri, or the binary chunk of a .glb file", "neither");
    bytes = *chunk;
  } else if (is_data_uri(uri)) {
    std::optional<std::string> data = data_of_uri(uri);
    if (!data) throw bad_gltf(path, field, "a data URI in base64", "one that is not");
    bytes = std::move(*data);
  } else {
    bytes = bytes_of_file(uri, path, field);
  }
  const auto length = buffer["byteLength"].get<std::uint64_t>();
  if (bytes.size() < length)
    throw bad_gltf(path, field, fmt::format("{} bytes, as its byteLength says", length),
                   std::to_string(bytes.size()));
  return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)};
}

}  // namespace

GltfBuffers take_buffers(GltfJson& json, const std::optional<std::string>& chunk, const fs::path& path) {
  const auto found = json.find("buffers");
  if (found == json.end()) return {};
  const GltfJson table = std::move(*found);
  json.erase("buffers");
  check_sizes(table, path);
  GltfBuffers buffers;
  for (std::size_t i = 0; i < table.size(); ++i)
    buffers.push_back(buffer_bytes(json, table[i], i, chunk, path));
  return buffers;
}

}  // namespace seamline::renderer
