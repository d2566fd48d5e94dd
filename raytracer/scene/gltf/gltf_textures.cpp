#include "raytracer/scene/gltf/gltf_textures.h"

#include <fmt/core.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "raytracer/scene/gltf/gltf_uri.h"
#include "support/files/atomic_file.h"
#include "support/files/confined_path.h"
#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/printable.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;

constexpr int uv_sets = 2;

template <class T>
bool exists(int index, const std::vector<T>& all) {
  return index >= 0 && static_cast<std::size_t>(index) < all.size();
}

Wrap wrap_of(int code) {
  if (code == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp;
  if (code == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::mirrored;
  return Wrap::repeat;
}

/// A number of an extension, or the usual one.
double number(const tinygltf::Value& table, const char* key, std::size_t index, double usual) {
  if (!table.Has(key)) return usual;
  const tinygltf::Value& value = table.Get(key);
  const tinygltf::Value& one = value.IsArray() ? value.Get(index) : value;
  return one.IsNumber() ? one.GetNumberAsDouble() : usual;
}

/// Throws InputError for a picture of a format that only extensions of glTF allow, with the way round.
void require_png_or_jpeg(std::string_view bytes, const std::string& name) {
  const char* format = nullptr;
  if (bytes.starts_with("\xABKTX 20\xBB"))
    format = "KTX2 (`gltf-transform ktxdecompress IN OUT` makes PNG of it)";
  if (bytes.starts_with("RIFF") && bytes.size() > 12 && bytes.substr(8).starts_with("WEBP"))
    format = "WebP (`gltf-transform png IN OUT` makes PNG of it)";
  if (bytes.starts_with("DDS ")) format = "DDS";
  if (bytes.substr(std::min<std::size_t>(4, bytes.size())).starts_with("ftypavif"))
    format = "AVIF (`gltf-transform png IN OUT` makes PNG of it)";
  if (format != nullptr)
    throw input_error({.file = name, .wanted = "a PNG or JPEG picture", .found = format});
}

ByteImage decoded_picture(std::string_view bytes, const std::string& name) {
  require_png_or_jpeg(bytes, name);
  return decode_texture(bytes, name);
}

}  // namespace

std::string_view GltfTextures::bytes_in_view(int view, const std::string& field) const {
  const auto bad = [&](const std::string& wanted) {
    return input_error({.file = file_.string(), .field = field, .wanted = wanted, .found = "none"});
  };
  if (!exists(view, model_.bufferViews)) throw bad("a buffer view that exists");
  const tinygltf::BufferView& range = model_.bufferViews[view];
  if (!exists(range.buffer, model_.buffers)) throw bad("a buffer that exists");
  const std::vector<unsigned char>& bytes = model_.buffers[range.buffer].data;
  if (range.byteLength > bytes.size() || range.byteOffset > bytes.size() - range.byteLength)
    throw bad("a picture inside its buffer");
  return {reinterpret_cast<const char*>(bytes.data()) + range.byteOffset, range.byteLength};
}

std::shared_ptr<const ByteImage> GltfTextures::picture(int index, const std::string& field) {
  if (const auto known = pictures_.find(index); known != pictures_.end()) return known->second;
  if (!exists(index, model_.images))
    throw input_error({.file = file_.string(),
                       .field = field,
                       .wanted = "a PNG or JPEG picture",
                       .found = index < 0 ? "a texture without one" : "one that does not exist"});
  const tinygltf::Image& image = model_.images[index];
  const std::string where = fmt::format("images[{}]", index);
  const std::string name = fmt::format("{}: {}", file_.string(), where);
  ByteImage decoded;
  if (image.uri.empty()) {
    decoded = decoded_picture(bytes_in_view(image.bufferView, where), name);
  } else if (is_data_uri(image.uri)) {
    const std::optional<std::string> bytes = data_of_uri(image.uri);
    if (!bytes)
      throw input_error(
          {.file = file_.string(), .field = where, .wanted = "a picture in base64", .found = "none"});
    decoded = decoded_picture(*bytes, name);
  } else {
    const fs::path path =
        path_below(file_.parent_path(), file_of_uri(image.uri), {.file = file_.string(), .field = where});
    std::error_code error;
    if (!fs::is_regular_file(path, error))
      throw input_error({.file = file_.string(),
                         .field = where,
                         .wanted = "a picture beside the file",
                         .found = fmt::format("no file \"{}\"", printable(path.string()))});
    decoded = decoded_picture(read_file(path, limits::largest_texture_file_bytes), path.string());
  }
  decoded_bytes_ += static_cast<std::int64_t>(decoded.values.size());
  if (decoded_bytes_ > limits::largest_texture_bytes)
    throw input_error({.file = file_.string(),
                       .field = where,
                       .wanted = fmt::format("pictures of at most {} bytes together, decoded",
                                             limits::largest_texture_bytes),
                       .found = "more"});
  return pictures_.emplace(index, std::make_shared<const ByteImage>(std::move(decoded))).first->second;
}

Texture GltfTextures::read(const tinygltf::TextureInfo& info, Encoding encoding, const std::string& field) {
  if (!exists(info.index, model_.textures))
    throw input_error({.file = file_.string(),
                       .field = field,
                       .wanted = "a texture that exists",
                       .found = std::to_string(info.index)});
  const tinygltf::Texture& from = model_.textures[info.index];
  Texture texture{.picture = picture(from.source, fmt::format("textures[{}]", info.index)),
                  .encoding = encoding,
                  .uv_set = info.texCoord};
  if (exists(from.sampler, model_.samplers)) {
    const tinygltf::Sampler& sampler = model_.samplers[from.sampler];
    texture.wrap_u = wrap_of(sampler.wrapS);
    texture.wrap_v = wrap_of(sampler.wrapT);
    texture.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
  }
  if (const auto found = info.extensions.find("KHR_texture_transform"); found != info.extensions.end()) {
    const tinygltf::Value& table = found->second;
    const auto pair = [&](const char* key, double usual) {
      return Eigen::Vector2d(number(table, key, 0, usual), number(table, key, 1, usual)).cast<float>().eval();
    };
    texture.transform = texture_transform(
        pair("offset", 0), static_cast<float>(number(table, "rotation", 0, 0)), pair("scale", 1));
    texture.uv_set = static_cast<int>(number(table, "texCoord", 0, texture.uv_set));
    if (!texture.transform.allFinite())
      throw input_error({.file = file_.string(),
                         .field = field + ".KHR_texture_transform",
                         .wanted = "finite numbers",
                         .found = "others"});
  }
  if (texture.uv_set < 0 || texture.uv_set >= uv_sets)
    throw input_error({.file = file_.string(),
                       .field = field + ".texCoord",
                       .wanted = "0 or 1, the sets of texture coordinates that Seamline reads",
                       .found = std::to_string(texture.uv_set)});
  return texture;
}

}  // namespace seamline::renderer
