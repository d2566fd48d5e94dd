#pragma once
#include <string_view>

namespace seamline::inline stimuli {

/// Who says whether the real world or the virtual object is in front. A setting knows some of these.
enum class Occlusion {
  mesh,          ///< the local scene, by rays, a sample at a time
  depth_test,    ///< the measured depth of a pixel or direction, in metres (002, section 5)
  depth_buffer,  ///< the same in the steps of a depth buffer (001, section 5.1)
  ghosts,  ///< the local scene, drawn first into a depth buffer and not into the picture (001, section 5.1;
           ///< 000, section 4.1)
  mask,    ///< a mask that somebody painted, which is the truth's silhouettes (paper, section 6)
  edges,   ///< the local scene's silhouettes, moved onto the photograph's edges
  nobody   ///< the object is, always
};

/// "mesh", "depth_test", ...; of `nobody` "none".
[[nodiscard]] std::string_view word(Occlusion occlusion);

/// Whether the depth of pixels is tested, in place of rays into the local scene.
[[nodiscard]] constexpr bool tests_pixels(Occlusion occlusion) {
  return occlusion == Occlusion::depth_test || occlusion == Occlusion::depth_buffer;
}

}  // namespace seamline::inline stimuli
