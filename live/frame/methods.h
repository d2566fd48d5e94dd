#pragma once
#include <array>
#include <string_view>

#include "stimuli/definition/methods/occlusion.h"

namespace seamline::live {

/// How depth comes into the picture's pixels. `points`: each measured pixel lands in one (paper 001, section
/// 4.3). `mesh`: the local scene is drawn from the colour camera (paper 000, section 2.2.2).
enum class Mapping { points, mesh };

/// Whether light of suns and lamps arrives: always; by rays; by shadow maps of one texel, of 3 x 3, or soft.
enum class Shadows { none, traced, map, pcf, pcss };

struct Methods {
  Mapping mapping = Mapping::mesh;
  Occlusion occlusion = Occlusion::depth_test;
  Shadows shadows = Shadows::pcf;

  bool operator==(const Methods&) const = default;
};

inline constexpr std::array every_mapping = {Mapping::points, Mapping::mesh};
inline constexpr std::array every_occlusion = {Occlusion::nobody, Occlusion::mesh, Occlusion::depth_test,
                                               Occlusion::ghosts};
inline constexpr std::array every_shadows = {Shadows::none, Shadows::traced, Shadows::map, Shadows::pcf,
                                             Shadows::pcss};

[[nodiscard]] std::string_view word(Mapping mapping);
[[nodiscard]] std::string_view word(Shadows shadows);

/// Whether the methods ask rays of the local scene, for which its tree must be built.
[[nodiscard]] bool needs_tree(const Methods& methods);
[[nodiscard]] bool uses_maps(Shadows shadows);

}  // namespace seamline::live
