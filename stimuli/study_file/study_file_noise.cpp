#include "stimuli/study_file/study_file_noise.h"

#include "stimuli/settings/noise_settings.h"
#include "stimuli/settings/read_settings.h"

namespace seamline::inline stimuli {
std::optional<SourceNoise> read_noise(const TomlTable& source, const std::optional<SourceNoise>& usual) {
  if (!source.has("noise")) return usual;
  if (source.is_text("noise")) {
    if (source.text("noise") != "none")
      throw source.complaint("noise", "\"none\", or a table with a model",
                             "\"" + source.text("noise") + "\"");
    return std::nullopt;
  }
  const TomlTable table = *source.table("noise");
  SourceNoise noise = usual.value_or(SourceNoise{});
  if (!usual && !table.has("model"))
    throw table.complaint("model", "\"generic\", \"time_of_flight\" or \"structured_light\"", "nothing");
  read_settings(table, noise);
  std::visit(
      [&](auto& model) {
        read_settings(table, model);
        read_settings(table, model.outliers);
      },
      noise.model);
  table.finish();
  return noise;
}

}  // namespace seamline::inline stimuli
