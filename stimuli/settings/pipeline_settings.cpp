#include "stimuli/settings/pipeline_settings.h"

#include "stimuli/definition/at_level.h"

namespace seamline::inline stimuli {

std::string fault_of_light_count(const Pipeline& pipeline) {
  const int count = pipeline.light_count;
  return count > 0 && (count & (count - 1)) == 0 ? "" : "a power of two, because median cut halves";
}

std::string_view word(Occlusion occlusion) {
  return word_of(occlusion);
}
std::string_view word(PipelineShadows shadows) {
  return word_of(shadows);
}
std::string_view word(ShadowFilter filter) {
  return word_of(filter);
}
std::string_view word(PipelineLights lights) {
  return word_of(lights);
}
std::string_view word(PipelineCompositing compositing) {
  return word_of(compositing);
}
std::string_view word(PipelineNormals normals) {
  return word_of(normals);
}

std::string canonical_text(const Pipeline& pipeline) {
  return settings_text(pipeline);
}

void set_level(Pipeline& pipeline, Quantity quantity, double level) {
  set_level_of(pipeline, quantity, level);
}

}  // namespace seamline::inline stimuli
