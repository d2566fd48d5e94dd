#pragma once
#include <string_view>

namespace seamline::inline stimuli {

/// How surfaces scatter light. `diffuse`: every base colour is an albedo, as in the paper. `gltf`: metals and
/// glossy layers too, as the scene's files say.
enum class MaterialModel { diffuse, gltf };

[[nodiscard]] constexpr std::string_view word(MaterialModel model) {
  switch (model) {
    case MaterialModel::diffuse:
      return "diffuse";
    case MaterialModel::gltf:
      return "gltf";
  }
  return {};
}

}  // namespace seamline::inline stimuli
