#pragma once
#include <compare>
#include <string>
#include <string_view>

#include "stimuli/definition/methods/occlusion.h"

namespace seamline::inline stimuli {

/// How light of suns and lamps is kept from where it does not arrive. `shadow_map`: a picture of depth as the
/// light sees it, of the local scene and of the object (000, section 4.2; 001, section 5.3).
/// `occlusion_field`: spherical harmonics of what is visible past an object, on shells around it (001,
/// section 5.4).
enum class PipelineShadows { traced, shadow_map, occlusion_field };

/// How a shadow map is looked up: one texel; percentage-closer, 3 x 3 texels (Reeves and others 1987); soft
/// shadows by percentage-closer, whose width a search for blockers says (Fernando 2005).
enum class ShadowFilter { none, pcf, pcss };

/// Normals of the real surfaces. `mesh`: of the depth mesh's triangles. `truth`: the true ones.
/// `cross_products`: of neighbouring depth samples in the picture's pixels (001, section 5.2).
/// `triangle_mean`: the mean of the triangles around each vertex, linear between vertices (000, section 4.2).
enum class PipelineNormals { mesh, truth, cross_products, triangle_mean };

/// What stands for the light. `median_cut`: suns in place of the environment, by median cut (001,
/// section 5.3).
enum class PipelineLights { as_given, median_cut };

/// How the object's change of the local scene is put onto the photograph. `ratio`: times with over without.
/// `additive`: plus with minus without. `dark_layer`: shadow as a dark layer of one opacity, whatever light
/// is there.
enum class PipelineCompositing { ratio, additive, dark_layer };

/// How light is computed from the local scene, where it answers: traced, or by methods of real time. What it
/// does not name is traced.
struct Pipeline {
  Occlusion occlusion = Occlusion::mesh;  ///< or `depth_test`, `ghosts`
  PipelineShadows shadows = PipelineShadows::traced;
  ShadowFilter shadow_filter = ShadowFilter::none;
  int shadow_map_px = 1024;       ///< a side; of shadow maps only, and so are filter and bias
  double shadow_bias_texels = 1;  ///< of a texel's width, times 1 + tan of the angle of incidence
  int field_bands = 4;            ///< of occlusion fields only, and so are their shells
  int field_shells = 8;
  PipelineNormals normals = PipelineNormals::mesh;
  PipelineLights lights = PipelineLights::as_given;
  int light_count = 16;  ///< a power of two; of median cut only
  PipelineCompositing compositing = PipelineCompositing::ratio;
  double shadow_opacity = 0.5;  ///< of a dark layer only

  auto operator<=>(const Pipeline&) const = default;
};

[[nodiscard]] std::string_view word(PipelineShadows shadows);
[[nodiscard]] std::string_view word(ShadowFilter filter);
[[nodiscard]] std::string_view word(PipelineNormals normals);
[[nodiscard]] std::string_view word(PipelineLights lights);
[[nodiscard]] std::string_view word(PipelineCompositing compositing);

/// "occlusion ghosts, shadows shadow_map pcf 1024 px bias 1": what is not traced, and nothing else; empty
/// where everything is.
[[nodiscard]] std::string canonical_text(const Pipeline& pipeline);

}  // namespace seamline::inline stimuli
