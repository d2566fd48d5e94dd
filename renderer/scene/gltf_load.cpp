#include "renderer/scene/gltf_load.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <utility>

#include "support/files/atomic_file.h"
#include "support/files/confined_path.h"
#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/text_bounds.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

InputError bad(const fs::path& path, const std::string& field, const std::string& wanted,
               const std::string& found) {
  return input_error({.file = path.string(), .field = field, .wanted = wanted, .found = found});
}

/// The parts of a file: its JSON, and what follows it in a GLB.
struct GltfText {
  std::string json;
  std::string rest = {};
  bool binary = false;
};

constexpr std::size_t glb_header_bytes = 20;  ///< magic, version, length; length and kind of the first chunk

std::size_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

/// The library's own check of the second chunk's length forgets the chunk's header of 8 bytes.
GltfText split(std::string bytes, const fs::path& path) {
  if (!bytes.starts_with("glTF")) return {.json = std::move(bytes)};
  const auto cut = [&](const char* what) { return bad(path, "", "a whole glTF 2.0 file", what); };
  if (bytes.size() < glb_header_bytes) throw cut("one that ends in its header");
  const std::size_t length = number_at(bytes, 8);
  if (length > bytes.size() || length < glb_header_bytes) throw cut("one that is shorter than it says");
  bytes.resize(length);
  const std::size_t json_bytes = number_at(bytes, 12);
  if (json_bytes > bytes.size() - glb_header_bytes) throw cut("one that ends before its JSON does");
  GltfText text{.json = bytes.substr(glb_header_bytes, json_bytes),
                .rest = bytes.substr(glb_header_bytes + json_bytes),
                .binary = true};
  if (!text.rest.empty() && (text.rest.size() < 8 || number_at(text.rest, 0) > text.rest.size() - 8))
    throw cut("one that ends before its binary chunk does");
  return text;
}

/// Buffers of a GLB are copies of its one chunk: a thousand of them are a thousand times its size.
void check_buffers(const Json& json, const fs::path& path) {
  const auto buffers = json.find("buffers");
  if (buffers == json.end()) return;
  if (!buffers->is_array() || static_cast<std::int64_t>(buffers->size()) > limits::largest_gltf_buffers)
    throw bad(path, "buffers", "at most " + std::to_string(limits::largest_gltf_buffers) + " buffers",
              buffers->is_array() ? std::to_string(buffers->size()) : "no array");
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < buffers->size(); ++i) {
    const Json& buffer = (*buffers)[i];
    const std::string field = "buffers[" + std::to_string(i) + "]";
    if (!buffer.is_object() || !buffer.contains("byteLength") || !buffer["byteLength"].is_number_unsigned() ||
        buffer["byteLength"] == 0)
      throw bad(path, field + ".byteLength", "a whole number above 0", "none");
    const auto bytes = buffer["byteLength"].get<std::uint64_t>();
    constexpr auto most = static_cast<std::uint64_t>(limits::largest_scene_file_bytes);
    if (bytes > most || (total += bytes) > most)
      throw bad(path, field, "buffers of at most " + std::to_string(most) + " bytes together", "more");
  }
}

/// What the file says of its pictures, which the library does not see: it would decode them.
struct PictureTables {
  Json images, textures, samplers;
};

Json take_table(Json& json, const char* name, const fs::path& path) {
  const auto found = json.find(name);
  if (found == json.end()) return Json::array();
  Json table = std::move(*found);
  json.erase(name);
  if (!table.is_array() || static_cast<std::int64_t>(table.size()) > limits::most_gltf_pictures)
    throw bad(path, name, "an array of at most " + std::to_string(limits::most_gltf_pictures),
              table.is_array() ? std::to_string(table.size()) : "something else");
  return table;
}

/// An index or code of a table; `usual` where there is none, or none that could be one.
int whole_number(const Json& table, const char* key, int usual) {
  const auto found = table.is_object() ? table.find(key) : table.end();
  if (!table.is_object() || found == table.end() || !found->is_number_integer()) return usual;
  const auto number = found->get<std::int64_t>();
  return std::in_range<int>(number) ? static_cast<int>(number) : usual;
}

std::string text_of(const Json& table, const char* key) {
  const auto found = table.is_object() ? table.find(key) : table.end();
  return table.is_object() && found != table.end() && found->is_string() ? found->get<std::string>()
                                                                         : std::string();
}

/// Nothing here is checked against the rest of the file: whoever uses a texture does that.
void add_pictures(const PictureTables& tables, tinygltf::Model& model) {
  for (const Json& from : tables.images) {
    tinygltf::Image image;
    image.uri = text_of(from, "uri");
    image.bufferView = whole_number(from, "bufferView", -1);
    model.images.push_back(std::move(image));
  }
  for (const Json& from : tables.textures) {
    tinygltf::Texture texture;
    texture.source = whole_number(from, "source", -1);
    texture.sampler = whole_number(from, "sampler", -1);
    model.textures.push_back(std::move(texture));
  }
  for (const Json& from : tables.samplers) {
    tinygltf::Sampler sampler;
    sampler.magFilter = whole_number(from, "magFilter", -1);
    sampler.wrapS = whole_number(from, "wrapS", TINYGLTF_TEXTURE_WRAP_REPEAT);
    sampler.wrapT = whole_number(from, "wrapT", TINYGLTF_TEXTURE_WRAP_REPEAT);
    model.samplers.push_back(std::move(sampler));
  }
}

/// What a scene needs and no more: what is not there cannot be misread.
Json needed_part(const std::string& text, const fs::path& path) {
  require_bounded_json(text, path.string());
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) throw bad(path, "", "a whole glTF 2.0 file", "one whose JSON is damaged");
  check_buffers(json, path);
  for (const char* unread : {"animations", "skins", "extras"}) json.erase(unread);
  return json;
}

/// The file again, with the part of its JSON that is needed.
std::string joined(const Json& json, const GltfText& text) {
  std::string bytes = json.dump();
  if (!text.binary) return bytes;
  bytes.append((4 - bytes.size() % 4) % 4, ' ');
  const auto number = [](std::size_t value) {
    const auto narrow = static_cast<std::uint32_t>(value);
    std::string four(4, '\0');
    std::memcpy(four.data(), &narrow, 4);
    return four;
  };
  const std::size_t length = glb_header_bytes + bytes.size() + text.rest.size();
  return "glTF" + number(2) + number(length) + number(bytes.size()) + "JSON" + bytes + text.rest;
}

/// Where the library may read: `user_data` is the glTF file's folder.
bool may_read(const std::string& file, void* user_data) {
  std::error_code error;
  return fs::is_regular_file(file, error) && lies_below(file, *static_cast<const fs::path*>(user_data));
}

bool read_buffer(std::vector<unsigned char>* out, std::string* error, const std::string& file,
                 void* user_data) {
  try {
    if (!may_read(file, user_data)) throw InputError("it lies outside the folder of the glTF file");
    const std::string bytes = read_file(file, limits::largest_scene_file_bytes);
    out->assign(bytes.begin(), bytes.end());
    return true;
  } catch (const InputError& complaint) {
    if (error != nullptr) *error += complaint.what();
    return false;
  }
}

tinygltf::Model parse(const std::string& bytes, bool binary, const fs::path& path) {
  fs::path folder = path.parent_path().empty() ? fs::path(".") : path.parent_path();
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks({.FileExists = may_read,
                         .ExpandFilePath = [](const std::string& file, void*) { return file; },
                         .ReadWholeFile = read_buffer,
                         .WriteWholeFile = nullptr,
                         .user_data = &folder});
  tinygltf::Model model;
  std::string error, warning;
  bool loaded = false;
  try {
    if (!std::in_range<unsigned>(bytes.size())) throw std::length_error("more than 4 GiB");
    const auto size = static_cast<unsigned>(bytes.size());
    loaded = binary
                 ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                               reinterpret_cast<const unsigned char*>(bytes.data()), size,
                                               folder.string())
                 : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, folder.string());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& thrown) {
    error += thrown.what();
  }
  while (!error.empty() && error.back() == '\n') error.pop_back();
  std::replace(error.begin(), error.end(), '\n', ' ');
  if (!loaded) throw bad(path, "", "a whole glTF 2.0 file", error.empty() ? "something else" : error);
  return model;
}

}  // namespace

std::string file_of_uri(const std::string& uri) {
  const auto digit = [](char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
  };
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool coded =
        uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
    name += coded ? static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2])) : uri[i];
    if (coded) i += 2;
  }
  return name;
}

tinygltf::Model load_gltf(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) throw bad(path, "", "a .gltf or .glb file", "no such file");
  GltfText text = split(read_file(path, limits::largest_scene_file_bytes), path);
  Json json = needed_part(text.json, path);
  text.json.clear();
  const PictureTables pictures{.images = take_table(json, "images", path),
                               .textures = take_table(json, "textures", path),
                               .samplers = take_table(json, "samplers", path)};
  tinygltf::Model model = parse(joined(json, text), text.binary, path);
  add_pictures(pictures, model);
  static const std::set<std::string> known = {"KHR_lights_punctual", "KHR_materials_emissive_strength",
                                              "KHR_mesh_quantization", "KHR_materials_unlit",
                                              "KHR_texture_transform"};
  for (const std::string& extension : model.extensionsRequired)
    if (!known.contains(extension))
      throw bad(path, "extensionsRequired", "extensions that Seamline knows", "\"" + extension + "\"");
  return model;
}

}  // namespace seamline::renderer
