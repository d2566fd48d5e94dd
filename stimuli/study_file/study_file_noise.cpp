#include "stimuli/study_file/study_file_noise.h"

#include "stimuli/study_file/study_file_words.h"

namespace seamline::inline stimuli {
namespace {

using sensors::GenericNoise;
using sensors::StructuredLightNoise;
using sensors::TimeOfFlightNoise;

constexpr Range share{0, 1}, anything{0, 1e6}, electrons{0, 1e15, "photoelectrons"};

/// Reads what each model has, over what it holds.
struct ReadParameters {
  const TomlTable& table;

  void number(const char* key, double& value, Range range) const { value = table.number(key, value, range); }

  void operator()(GenericNoise& noise) const {
    number("relative_sigma", noise.relative_sigma, anything);
    number("step_m", noise.step_m, anything);
    number("dropout_share", noise.dropout_share, share);
  }
  void operator()(TimeOfFlightNoise& noise) const {
    number("modulation_hz", noise.modulation_hz, {1e3, 1e12, "Hz"});
    number("amplitude_at_1m_e", noise.amplitude_at_1m_e, electrons);
    number("contrast", noise.contrast, {1e-6, 1});
    number("background_e", noise.background_e, electrons);
    number("readout_e", noise.readout_e, {0, 1e9, "photoelectrons"});
    number("weakest_amplitude_e", noise.weakest_amplitude_e, electrons);
    number("full_well_e", noise.full_well_e, electrons);
    noise.wraps = table.boolean("wraps", noise.wraps);
    noise.mixes = table.boolean("mixes", noise.mixes);
  }
  void operator()(StructuredLightNoise& noise) const {
    number("baseline_m", noise.baseline_m, {1e-6, 1e6, "m"});
    number("sigma_px", noise.sigma_px, anything);
    number("step_px", noise.step_px, anything);
    number("grazing_sigma_m", noise.grazing_sigma_m, anything);
    number("sure_deg", noise.sure_deg, {0, 90, "degrees"});
    number("lost_deg", noise.lost_deg, {noise.sure_deg, 90, "degrees (not before sure_deg)"});
    number("sure_signal", noise.sure_signal, {0, 1e9});
    number("lost_signal", noise.lost_signal, {0, noise.sure_signal});
  }
};

void read_outliers(const TomlTable& table, sensors::Outliers& outliers) {
  outliers.share = table.number("outlier_share", outliers.share, share);
  outliers.nearest_m = table.number("outlier_nearest_m", outliers.nearest_m, {0, 1e9, "m"});
  outliers.farthest_m =
      table.number("outlier_farthest_m", outliers.farthest_m, {outliers.nearest_m, 1e9, "m"});
}

}  // namespace

std::optional<SourceNoise> read_noise(const TomlTable& source, const std::optional<SourceNoise>& usual) {
  if (!source.has("noise")) return usual;
  if (source.is_text("noise")) {
    if (source.text("noise") != "none")
      throw source.complaint("noise", "\"none\", or a table with a model",
                             "\"" + source.text("noise") + "\"");
    return std::nullopt;
  }
  const TomlTable table = *source.table("noise");
  static const Words<sensors::NoiseModel> models = {{"generic", GenericNoise{}},
                                                    {"time_of_flight", TimeOfFlightNoise{}},
                                                    {"structured_light", StructuredLightNoise{}}};
  SourceNoise noise = usual.value_or(SourceNoise{});
  if (table.has("model"))
    noise.model = one_of<sensors::NoiseModel>(table, "model", noise.model, models);
  else if (!usual)
    throw table.complaint("model", "\"generic\", \"time_of_flight\" or \"structured_light\"", "nothing");
  std::visit(ReadParameters{table}, noise.model);
  std::visit([&](auto& one) { read_outliers(table, one.outliers); }, noise.model);
  noise.scale = table.number("scale", noise.scale, {0, 1e6});
  table.finish();
  return noise;
}

}  // namespace seamline::inline stimuli
