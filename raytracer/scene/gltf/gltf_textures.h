#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "raytracer/material/texture.h"

namespace tinygltf {
class Model;
struct TextureInfo;
}  // namespace tinygltf

namespace seamline::renderer {

/// The textures of one glTF file, whose pictures are decoded when a material asks for them, each once.
class GltfTextures {
 public:
  GltfTextures(const tinygltf::Model& model, std::filesystem::path file)
      : model_(model), file_(std::move(file)) {}

  /// Throws InputError naming file and field: a picture that is not there, lies outside the file's folder, is
  /// damaged or too large, texture coordinates beyond the second set.
  [[nodiscard]] Texture read(const tinygltf::TextureInfo& info, Encoding encoding, const std::string& field);

 private:
  [[nodiscard]] std::shared_ptr<const ByteImage> picture(int image, const std::string& field);
  [[nodiscard]] std::string_view bytes_in_view(int view, const std::string& field) const;

  const tinygltf::Model& model_;
  std::filesystem::path file_;
  std::map<int, std::shared_ptr<const ByteImage>> pictures_;
  std::int64_t decoded_bytes_ = 0;
};

}  // namespace seamline::renderer
