#pragma once
#include <string_view>

namespace seamline::live {

/// How depth comes into the picture's pixels. `points`: each measured pixel lands in one (paper 001, section
/// 4.3). `mesh`: the local scene is drawn from the colour camera (paper 000, section 2.2.2).
enum class Mapping { points, mesh };

/// Who is in front. `none`: always the virtual thing. `mesh`: rays into the local scene. `depth_test`:
/// registered depth of the pixel (paper 002, section 5). `ghosts`: the local scene drawn first, invisibly
/// (001, section 5.1; 000, section 4.1).
enum class Occlusion { none, mesh, depth_test, ghosts };

/// Whether light of suns and lamps arrives: always; by rays; by shadow maps of one texel, of 3 x 3, or soft.
enum class Shadows { none, traced, map, pcf, pcss };

struct Methods {
  Mapping mapping = Mapping::mesh;
  Occlusion occlusion = Occlusion::depth_test;
  Shadows shadows = Shadows::pcf;

  bool operator==(const Methods&) const = default;
};

inline constexpr int mapping_count = 2, occlusion_count = 4, shadows_count = 5;

[[nodiscard]] std::string_view word(Mapping mapping);
[[nodiscard]] std::string_view word(Occlusion occlusion);
[[nodiscard]] std::string_view word(Shadows shadows);

/// Whether the methods ask rays of the local scene, for which its tree must be built.
[[nodiscard]] bool needs_tree(const Methods& methods);
[[nodiscard]] bool uses_maps(Shadows shadows);

}  // namespace seamline::live
