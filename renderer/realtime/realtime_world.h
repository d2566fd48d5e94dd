#pragma once
#include <optional>

#include "renderer/realtime/depth_normals.h"
#include "renderer/realtime/field_light.h"
#include "renderer/realtime/shadow_map.h"

namespace seamline::renderer {

/// Methods of real time that answer in place of rays wherever the depth mesh has a part (`Pipeline`), ready
/// to be asked.
struct RealtimeWorld {
  Pipeline pipeline;
  Light light;                             ///< the scene's, or what stands for it
  std::vector<Light> each_lamp;            ///< lights of one lamp and nothing else, in the light's order
  std::optional<ShadowMaps> real, object;  ///< of the local scene and of the virtual object; none: traced
  std::optional<FieldLight> fields;        ///< none: traced, or by maps
  std::optional<NormalPicture> normals;    ///< of the local scene; none: the mesh's, or the truth's

  [[nodiscard]] ShadowLookup lookup() const {
    return {pipeline.shadow_filter, static_cast<float>(pipeline.shadow_bias_texels)};
  }
  [[nodiscard]] bool is_dark_layer() const { return pipeline.compositing == PipelineCompositing::dark_layer; }
  /// Whether light is asked for in another way than by tracing the scene's own.
  [[nodiscard]] bool changes_light() const {
    return pipeline.shadows != PipelineShadows::traced || pipeline.lights != PipelineLights::as_given ||
           is_dark_layer();
  }
};

}  // namespace seamline::renderer
