#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "renderer/material/material.h"
#include "renderer/scene/gltf_textures.h"
#include "stimuli/definition/surface/material_model.h"

namespace tinygltf {
class Model;
struct Material;
}  // namespace tinygltf

namespace seamline::renderer {

/// The materials of one glTF file, as a model needs them: in the diffuse one only base colour, emission and
/// the alpha mask are read.
class GltfMaterials {
 public:
  GltfMaterials(const tinygltf::Model& model, const std::filesystem::path& file, MaterialModel kind)
      : model_(model), file_(file), kind_(kind), textures_(model, file) {}

  /// Throws InputError naming file and field: a material or picture that is wrong, half-transparent surfaces,
  /// and, in the glTF model, extensions that would change the picture and are not rendered. `where` names the
  /// primitive.
  [[nodiscard]] std::shared_ptr<const Material> read(int index, const std::string& where);

  /// What materials that were read have and the diffuse model leaves out; empty in the glTF model.
  [[nodiscard]] const std::set<std::string>& left_out() const { return left_out_; }

 private:
  [[nodiscard]] Material read_new(const tinygltf::Material& from, const std::string& field);
  void read_layer(const tinygltf::Material& from, const std::string& field, Material& material);
  void read_alpha(const tinygltf::Material& from, const std::string& field, Material& material) const;
  [[nodiscard]] Rgb read_emission(const tinygltf::Material& from, const std::string& field) const;

  const tinygltf::Model& model_;
  std::filesystem::path file_;
  MaterialModel kind_;
  GltfTextures textures_;
  std::map<int, std::shared_ptr<const Material>> known_;
  std::set<std::string> left_out_;
};

}  // namespace seamline::renderer
