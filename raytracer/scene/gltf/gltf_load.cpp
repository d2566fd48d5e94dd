#include "raytracer/scene/gltf/gltf_load.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "raytracer/scene/gltf/gltf_buffers.h"
#include "raytracer/scene/gltf/gltf_compression.h"
#include "raytracer/scene/gltf/gltf_uri.h"
#include "support/files/atomic_file.h"
#include "support/files/confined_path.h"
#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/text_bounds.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;

/// The parts of a file: its JSON, and the binary chunk of a GLB.
struct GltfText {
  std::string json;
  std::optional<std::string> chunk = {};
};

constexpr std::size_t glb_header_bytes = 20;  ///< magic, version, length; length and kind of the first chunk

std::size_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

/// The first chunk of bytes behind the JSON; none where there is none.
std::optional<std::string> binary_chunk(const std::string& bytes, std::size_t from, const InputError& cut) {
  constexpr std::size_t header_bytes = 8;
  while (from < bytes.size()) {
    if (bytes.size() - from < header_bytes || number_at(bytes, from) > bytes.size() - from - header_bytes)
      throw cut;
    const std::size_t length = number_at(bytes, from);
    if (std::string_view(bytes).substr(from + 4, 4) == std::string_view("BIN\0", 4))
      return bytes.substr(from + header_bytes, length);
    from += header_bytes + length;
  }
  return std::nullopt;
}

GltfText split(std::string bytes, const fs::path& path) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
  if (!bytes.starts_with("glTF")) return {.json = std::move(bytes)};
  const auto cut = [&](const char* what) { return bad_gltf(path, "", "a whole glTF 2.0 file", what); };
  if (bytes.size() < glb_header_bytes) throw cut("one that ends in its header");
  if (number_at(bytes, 4) == 1)
    throw bad_gltf(path, "", "glTF 2.0 (`gltf-pipeline -i IN -o OUT` turns 1.0 into it)",
                   "a .glb of glTF 1.0");
  const std::size_t length = number_at(bytes, 8);
  if (length > bytes.size() || length < glb_header_bytes) throw cut("one that is shorter than it says");
  bytes.resize(length);
  const std::size_t json_bytes = number_at(bytes, 12);
  if (json_bytes > bytes.size() - glb_header_bytes) throw cut("one that ends before its JSON does");
  return {.json = bytes.substr(glb_header_bytes, json_bytes),
          .chunk = binary_chunk(bytes, glb_header_bytes + json_bytes,
                                cut("one that ends before its binary chunk does"))};
}

/// Whether a file that begins so may be a glTF file: a .glb, or JSON behind blanks and a mark of byte order.
bool may_be_gltf(std::string_view start) {
  if (start.starts_with("glTF")) return true;
  if (start.starts_with("\xEF\xBB\xBF")) start.remove_prefix(3);
  const std::size_t begin = start.find_first_not_of(" \t\r\n");
  return begin == std::string_view::npos || start[begin] == '{';
}

/// The JSON of a file alone, which in a .glb comes before megabytes of numbers; empty where it cannot be
/// read.
std::string json_of_file(const fs::path& path) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) return {};
  std::ifstream in(path, std::ios::binary);
  std::string text(static_cast<std::size_t>(std::min<std::uintmax_t>(size, glb_header_bytes)), ' ');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!in || !may_be_gltf(text)) return {};
  std::uintmax_t rest = size - text.size();
  if (text.size() == glb_header_bytes && text.starts_with("glTF")) {
    rest = std::min<std::uintmax_t>(rest, number_at(text, 12));
    text.clear();
  }
  if (std::cmp_greater(text.size() + rest, limits::largest_scene_file_bytes)) return {};
  const std::size_t begun = text.size();
  text.resize(begun + static_cast<std::size_t>(rest));
  in.read(text.data() + begun, static_cast<std::streamsize>(rest));
  return in ? text : std::string();
}

/// What the file says of its pictures, which the library does not see: it would decode them.
struct PictureTables {
  GltfJson images, textures, samplers;
};

GltfJson take_table(GltfJson& json, const char* name, const fs::path& path) {
  const auto found = json.find(name);
  if (found == json.end()) return GltfJson::array();
  GltfJson table = std::move(*found);
  json.erase(name);
  if (!table.is_array() || static_cast<std::int64_t>(table.size()) > limits::most_gltf_pictures)
    throw bad_gltf(path, name, "an array of at most " + std::to_string(limits::most_gltf_pictures),
                   table.is_array() ? std::to_string(table.size()) : "something else");
  return table;
}

int index_or(const GltfJson& table, const char* key, int usual) {
  const std::int64_t number = whole_number(table, key, usual);
  return std::in_range<int>(number) ? static_cast<int>(number) : usual;
}

/// Where a picture that only an extension names lies: those of formats that are not read, so that whoever
/// needs it can say which.
int source_of(const GltfJson& texture) {
  if (const int source = index_or(texture, "source", -1); source >= 0) return source;
  if (const GltfJson* extensions = member(texture, "extensions"))
    for (const char* name :
         {"EXT_texture_webp", "KHR_texture_basisu", "EXT_texture_avif", "MSFT_texture_dds"})
      if (const GltfJson* extension = member(*extensions, name)) return index_or(*extension, "source", -1);
  return -1;
}

/// Nothing here is checked against the rest of the file: whoever uses a texture does that.
void add_pictures(const PictureTables& tables, tinygltf::Model& model) {
  for (const GltfJson& from : tables.images) {
    tinygltf::Image image;
    image.uri = text_of(from, "uri");
    image.bufferView = index_or(from, "bufferView", -1);
    model.images.push_back(std::move(image));
  }
  for (const GltfJson& from : tables.textures) {
    tinygltf::Texture texture;
    texture.source = source_of(from);
    texture.sampler = index_or(from, "sampler", -1);
    model.textures.push_back(std::move(texture));
  }
  for (const GltfJson& from : tables.samplers) {
    tinygltf::Sampler sampler;
    sampler.magFilter = index_or(from, "magFilter", -1);
    sampler.wrapS = index_or(from, "wrapS", TINYGLTF_TEXTURE_WRAP_REPEAT);
    sampler.wrapT = index_or(from, "wrapT", TINYGLTF_TEXTURE_WRAP_REPEAT);
    model.samplers.push_back(std::move(sampler));
  }
}

/// Files that were taken for a scene are refused by what they are, before their text is looked at.
void require_json(const std::string& text, const fs::path& path) {
  const std::size_t after_mark = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;  // of byte order, which JSON skips
  const std::size_t begin = text.find_first_not_of(" \t\r\n", after_mark);
  if (begin == std::string::npos) throw bad_gltf(path, "", "a whole glTF 2.0 file", "an empty file");
  if (text[begin] == '<')
    throw bad_gltf(path, "", "a whole glTF 2.0 file",
                   "a page of HTML or XML (it may have been saved in place of the file itself)");
  if (text[begin] != '{')
    throw bad_gltf(path, "", "a whole glTF 2.0 file", "another kind of file, neither JSON nor binary glTF");
}

/// What a scene needs and no more: what is not there cannot be misread.
GltfJson needed_part(const std::string& text, const fs::path& path, LeftOut& left_out, GltfJson* animations) {
  require_json(text, path);
  require_bounded_json(text, path.string());
  GltfJson json = GltfJson::parse(text, nullptr, false);
  if (!json.is_object()) throw bad_gltf(path, "", "a whole glTF 2.0 file", "one whose JSON is damaged");
  require_readable(json, path);
  if (animations != nullptr) *animations = take_table(json, "animations", path);
  note_unread(json, left_out);
  for (const char* unread : {"animations", "extras"}) json.erase(unread);
  if (const GltfJson* skins = member(json, "skins"); skins != nullptr && !skins->is_array())
    json.erase("skins");
  return json;
}

/// The library reads no file: buffers and pictures are not in the text that it gets.
tinygltf::Model parse(const std::string& text, const fs::path& path) {
  tinygltf::TinyGLTF loader;
  tinygltf::Model model;
  std::string error, warning;
  bool loaded = false;
  try {
    if (!std::in_range<unsigned>(text.size())) throw std::length_error("more than 4 GiB");
    loaded = loader.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                        static_cast<unsigned>(text.size()), "");
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& thrown) {
    error += thrown.what();
  }
  while (!error.empty() && error.back() == '\n') error.pop_back();
  std::replace(error.begin(), error.end(), '\n', ' ');
  if (!loaded) throw bad_gltf(path, "", "a whole glTF 2.0 file", error.empty() ? "something else" : error);
  return model;
}

}  // namespace

tinygltf::Model load_gltf(const fs::path& path, LeftOut& left_out, GltfJson* animations) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) throw bad_gltf(path, "", "a .gltf or .glb file", "no such file");
  GltfText text = split(read_file(path, limits::largest_scene_file_bytes), path);
  GltfJson json = needed_part(text.json, path, left_out, animations);
  text.json.clear();
  const PictureTables pictures{.images = take_table(json, "images", path),
                               .textures = take_table(json, "textures", path),
                               .samplers = take_table(json, "samplers", path)};
  GltfBuffers buffers = take_buffers(json, text.chunk, path);
  undo_compression(json, buffers, path);
  tinygltf::Model model = parse(json.dump(-1, ' ', false, GltfJson::error_handler_t::replace), path);
  for (std::vector<unsigned char>& bytes : buffers) model.buffers.emplace_back().data = std::move(bytes);
  add_pictures(pictures, model);
  return model;
}

std::vector<fs::path> files_named_by_gltf(const fs::path& path) {
  const std::string text = json_of_file(path);
  try {
    require_bounded_json(text, path.string());
  } catch (const InputError&) {
    return {};
  }
  const GltfJson json = GltfJson::parse(text, nullptr, false);
  std::vector<fs::path> files;
  for (const char* name : {"buffers", "images"}) {
    const GltfJson* table = member(json, name);
    if (table == nullptr || !table->is_array()) continue;
    for (const GltfJson& named : *table) {
      const std::string uri = text_of(named, "uri");
      if (uri.empty() || is_data_uri(uri)) continue;
      const fs::path file = path.parent_path() / file_of_uri(uri);
      std::error_code error;
      if (fs::is_regular_file(file, error) && lies_below(file, path.parent_path())) files.push_back(file);
    }
  }
  return files;
}

}  // namespace seamline::renderer
