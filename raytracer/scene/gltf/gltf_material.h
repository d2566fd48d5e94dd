#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "raytracer/material/material.h"
#include "raytracer/scene/gltf/gltf_extensions.h"
#include "raytracer/scene/gltf/gltf_textures.h"
#include "raytracer/scene/gltf/transparency.h"
#include "stimuli/definition/surface/material_model.h"

namespace tinygltf {
class Model;
class Value;
struct Material;
}  // namespace tinygltf

namespace seamline::renderer {

/// The materials of one glTF file, as a model needs them: in the diffuse one only base colour, emission and
/// alpha are read.
class GltfMaterials {
 public:
  GltfMaterials(const tinygltf::Model& model, const std::filesystem::path& file, MaterialModel kind,
                Transparency transparency, LeftOut& left_out)
      : model_(model),
        file_(file),
        kind_(kind),
        transparency_(transparency),
        textures_(model, file),
        left_out_(left_out) {}

  /// The material of a primitive whose vertices have alpha of that kind; null: its surfaces are left out, as
  /// `Transparency` says. Throws InputError naming file and field: a material or picture that is wrong, and
  /// half-transparent surfaces where those are refused. `where` names the primitive.
  [[nodiscard]] std::shared_ptr<const Material> read(int index, const std::string& where,
                                                     AlphaKind of_vertices = AlphaKind::opaque);

  /// What materials that were read have and the diffuse model leaves out; empty in the glTF model. What no
  /// model draws is among what the file leaves out.
  [[nodiscard]] const std::set<std::string>& left_out_of_diffuse() const { return left_out_of_diffuse_; }

 private:
  [[nodiscard]] std::shared_ptr<const Material> read_new(const tinygltf::Material& from,
                                                         const std::string& field, AlphaKind of_vertices);
  void read_base(const tinygltf::Material& from, const std::string& field, Material& material);
  void read_layer(const tinygltf::Material& from, const std::string& field, Material& material);
  void read_dielectric(const tinygltf::Material& from, const std::string& field, Material& material);
  void read_glossiness(const tinygltf::Value& extension, const std::string& field, Material& material);
  [[nodiscard]] Rgb read_emission(const tinygltf::Material& from, const std::string& field) const;
  [[nodiscard]] bool read_alpha(const tinygltf::Material& from, const std::string& field,
                                AlphaKind of_vertices, Material& material);
  [[nodiscard]] bool keeps_half_transparent(const tinygltf::Material& from, const std::string& field,
                                            const char* what);
  void note_left_out(const tinygltf::Material& from);

  const tinygltf::Model& model_;
  std::filesystem::path file_;
  MaterialModel kind_;
  Transparency transparency_;
  GltfTextures textures_;
  LeftOut& left_out_;
  std::map<std::pair<int, AlphaKind>, std::shared_ptr<const Material>> known_;
  std::set<std::string> left_out_of_diffuse_;
};

}  // namespace seamline::renderer
