#pragma once
#include <string_view>

namespace seamline::inline stimuli {

/// What the depth mesh is made of, as bounce light and mirrors see it. `constant`: the study's one albedo, as
/// in the paper. `truth`: the truth scene's own albedo, by direction, at the width of the depth map.
/// `photograph`: what the photograph shows over the light that reaches the mesh there
/// (renderer/estimators/mesh_albedo.h).
enum class MeshAlbedo { constant, truth, photograph };

[[nodiscard]] constexpr std::string_view word(MeshAlbedo albedo) {
  switch (albedo) {
    case MeshAlbedo::constant:
      return "constant";
    case MeshAlbedo::truth:
      return "truth";
    case MeshAlbedo::photograph:
      return "photograph";
  }
  return {};
}

}  // namespace seamline::inline stimuli
