#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/text/error.h"

namespace seamline::renderer {

/// The JSON of a glTF file, before the library that parses it: only what reads the file's bytes works on it.
using GltfJson = nlohmann::ordered_json;

/// Bytes of the file's buffers, by their numbers.
using GltfBuffers = std::vector<std::vector<unsigned char>>;

/// A complaint about a part of a glTF file.
[[nodiscard]] inline InputError bad_gltf(const std::filesystem::path& path, const std::string& field,
                                         const std::string& wanted, const std::string& found) {
  return input_error({.file = path.string(), .field = field, .wanted = wanted, .found = found});
}

/// A member of an object; null where there is none.
[[nodiscard]] const GltfJson* member(const GltfJson& object, const char* key);

/// An index, count or code; `usual` where there is none, or none that could be one.
[[nodiscard]] std::int64_t whole_number(const GltfJson& object, const char* key, std::int64_t usual);

/// A text; empty where there is none.
[[nodiscard]] std::string text_of(const GltfJson& object, const char* key);

/// How many elements an array of the file has; 0 without one.
[[nodiscard]] std::size_t count_of(const GltfJson& object, const char* key);

}  // namespace seamline::renderer
