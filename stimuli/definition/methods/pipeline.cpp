#include "stimuli/definition/methods/pipeline.h"

#include <fmt/core.h>

namespace seamline::inline stimuli {

std::string_view word(PipelineOcclusion occlusion) {
  switch (occlusion) {
    case PipelineOcclusion::mesh:
      return "mesh";
    case PipelineOcclusion::depth_test:
      return "depth_test";
    case PipelineOcclusion::ghosts:
      return "ghosts";
  }
  return {};
}

std::string_view word(PipelineShadows shadows) {
  switch (shadows) {
    case PipelineShadows::traced:
      return "traced";
    case PipelineShadows::shadow_map:
      return "shadow_map";
    case PipelineShadows::occlusion_field:
      return "occlusion_field";
  }
  return {};
}

std::string_view word(ShadowFilter filter) {
  switch (filter) {
    case ShadowFilter::none:
      return "none";
    case ShadowFilter::pcf:
      return "pcf";
    case ShadowFilter::pcss:
      return "pcss";
  }
  return {};
}

std::string_view word(PipelineNormals normals) {
  switch (normals) {
    case PipelineNormals::mesh:
      return "mesh";
    case PipelineNormals::truth:
      return "truth";
    case PipelineNormals::cross_products:
      return "cross_products";
    case PipelineNormals::triangle_mean:
      return "triangle_mean";
  }
  return {};
}

std::string_view word(PipelineLights lights) {
  switch (lights) {
    case PipelineLights::as_given:
      return "as_given";
    case PipelineLights::median_cut:
      return "median_cut";
  }
  return {};
}

std::string_view word(PipelineCompositing compositing) {
  switch (compositing) {
    case PipelineCompositing::ratio:
      return "ratio";
    case PipelineCompositing::additive:
      return "additive";
    case PipelineCompositing::dark_layer:
      return "dark_layer";
  }
  return {};
}

std::string canonical_text(const Pipeline& pipeline) {
  std::string text;
  const auto add = [&](const std::string& what) { text += (text.empty() ? "" : ", ") + what; };
  if (pipeline.occlusion != PipelineOcclusion::mesh)
    add(fmt::format("occlusion {}", word(pipeline.occlusion)));
  if (pipeline.shadows == PipelineShadows::shadow_map)
    add(fmt::format("shadows {} {} {} px bias {}", word(pipeline.shadows), word(pipeline.shadow_filter),
                    pipeline.shadow_map_px, pipeline.shadow_bias_texels));
  if (pipeline.shadows == PipelineShadows::occlusion_field)
    add(fmt::format("shadows {} {} bands {} shells", word(pipeline.shadows), pipeline.field_bands,
                    pipeline.field_shells));
  if (pipeline.normals != PipelineNormals::mesh) add(fmt::format("normals {}", word(pipeline.normals)));
  if (pipeline.lights == PipelineLights::median_cut)
    add(fmt::format("lights {} {}", word(pipeline.lights), pipeline.light_count));
  if (pipeline.compositing == PipelineCompositing::dark_layer)
    add(fmt::format("compositing {} {}", word(pipeline.compositing), pipeline.shadow_opacity));
  else if (pipeline.compositing != PipelineCompositing::ratio)
    add(fmt::format("compositing {}", word(pipeline.compositing)));
  return text;
}

}  // namespace seamline::inline stimuli
