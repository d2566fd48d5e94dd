#pragma once
#include "sensors/noise/measurement.h"
#include "stimuli/definition/depth_chain.h"
#include "stimuli/settings/settings_text.h"

namespace seamline::inline stimuli {

[[nodiscard]] std::string fault_of_farthest(const sensors::Outliers& outliers);
[[nodiscard]] std::string fault_of_lost_angle(const sensors::StructuredLightNoise& noise);
[[nodiscard]] std::string fault_of_lost_signal(const sensors::StructuredLightNoise& noise);

/// Of every noise model.
template <>
inline constexpr auto settings_of<sensors::Outliers> = std::to_array<Setting<sensors::Outliers>>({
    {.key = "outlier_share",
     .slot = &sensors::Outliers::share,
     .range = {0, 1},
     .meaning = "Share of pixels with a value that is uniform over the next two.",
     .wording = {.before = " outliers "},
     .level = Quantity::outlier_share},
    {.key = "outlier_nearest_m",
     .slot = &sensors::Outliers::nearest_m,
     .range = {0, 1e9, "m"},
     .meaning = "Where the wild values begin.",
     .wording = {.before = " "}},
    {.key = "outlier_farthest_m",
     .slot = &sensors::Outliers::farthest_m,
     .range = {0, 1e9, "m"},
     .meaning = "Where they end, not before `outlier_nearest_m`.",
     .wording = {.before = " "},
     .fault = fault_of_farthest},
});

template <>
inline constexpr auto settings_of<sensors::GenericNoise> = std::to_array<Setting<sensors::GenericNoise>>({
    {.key = "relative_sigma",
     .slot = &sensors::GenericNoise::relative_sigma,
     .range = {0, 1e6},
     .meaning = "Standard deviation as a share of the depth.",
     .wording = {.before = " "}},
    {.key = "step_m",
     .slot = &sensors::GenericNoise::step_m,
     .range = {0, 1e6, "m"},
     .meaning = "Depth is rounded to this step; 0: not.",
     .wording = {.before = " "}},
    {.key = "dropout_share",
     .slot = &sensors::GenericNoise::dropout_share,
     .range = {0, 1},
     .meaning = "Share of pixels that become holes.",
     .wording = {.before = " "}},
    {.key = "", .slot = part<&sensors::GenericNoise::outliers>(), .wording = {.written = Written::always}},
});

template <>
inline constexpr auto settings_of<sensors::TimeOfFlightNoise> =
    std::to_array<Setting<sensors::TimeOfFlightNoise>>({
        {.key = "modulation_hz",
         .slot = &sensors::TimeOfFlightNoise::modulation_hz,
         .range = {1e3, 1e12, "Hz"},
         .meaning = "Frequency of the light.",
         .wording = {.before = " "}},
        {.key = "amplitude_at_1m_e",
         .slot = &sensors::TimeOfFlightNoise::amplitude_at_1m_e,
         .range = {0, 1e15, "photoelectrons"},
         .meaning = "Of a white surface, seen head on at 1 m, a sample.",
         .wording = {.before = " "}},
        {.key = "contrast",
         .slot = &sensors::TimeOfFlightNoise::contrast,
         .range = {1e-6, 1},
         .meaning = "Modulated share of the camera's own light.",
         .wording = {.before = " "}},
        {.key = "background_e",
         .slot = &sensors::TimeOfFlightNoise::background_e,
         .range = {0, 1e15, "photoelectrons"},
         .meaning = "Other light, a sample.",
         .wording = {.before = " "}},
        {.key = "readout_e",
         .slot = &sensors::TimeOfFlightNoise::readout_e,
         .range = {0, 1e9, "photoelectrons"},
         .meaning = "Standard deviation of readout.",
         .wording = {.before = " "}},
        {.key = "weakest_amplitude_e",
         .slot = &sensors::TimeOfFlightNoise::weakest_amplitude_e,
         .range = {0, 1e15, "photoelectrons"},
         .meaning = "Pixels with less are holes.",
         .wording = {.before = " "}},
        {.key = "full_well_e",
         .slot = &sensors::TimeOfFlightNoise::full_well_e,
         .range = {0, 1e15, "photoelectrons"},
         .meaning = "Pixels with more are holes.",
         .wording = {.before = " "}},
        {.key = "wraps",
         .slot = &sensors::TimeOfFlightNoise::wraps,
         .meaning = "`false`: the ambiguity of the phase is resolved.",
         .wording = {.before = " "}},
        {.key = "mixes",
         .slot = &sensors::TimeOfFlightNoise::mixes,
         .meaning = "`false`: no flying pixels.",
         .wording = {.before = " "}},
        {.key = "",
         .slot = part<&sensors::TimeOfFlightNoise::outliers>(),
         .wording = {.written = Written::always}},
    });

template <>
inline constexpr auto settings_of<sensors::StructuredLightNoise> =
    std::to_array<Setting<sensors::StructuredLightNoise>>({
        {.key = "baseline_m",
         .slot = &sensors::StructuredLightNoise::baseline_m,
         .range = {1e-6, 1e6, "m"},
         .meaning = "Between camera and projector.",
         .wording = {.before = " "}},
        {.key = "sigma_px",
         .slot = &sensors::StructuredLightNoise::sigma_px,
         .range = {0, 1e6, "px"},
         .meaning = "Standard deviation of the disparity.",
         .wording = {.before = " "}},
        {.key = "step_px",
         .slot = &sensors::StructuredLightNoise::step_px,
         .range = {0, 1e6, "px"},
         .meaning = "The disparity is rounded to this step; 0: not.",
         .wording = {.before = " "}},
        {.key = "grazing_sigma_m",
         .slot = &sensors::StructuredLightNoise::grazing_sigma_m,
         .range = {0, 1e6, "m"},
         .meaning = "Noise that grows at grazing angles.",
         .wording = {.before = " "}},
        {.key = "sure_deg",
         .slot = &sensors::StructuredLightNoise::sure_deg,
         .range = {0, 90, "degrees"},
         .meaning = "Below this angle no pixel is lost.",
         .wording = {.before = " "}},
        {.key = "lost_deg",
         .slot = &sensors::StructuredLightNoise::lost_deg,
         .range = {0, 90, "degrees"},
         .meaning = "At this angle all are lost; not before `sure_deg`.",
         .wording = {.before = " "},
         .fault = fault_of_lost_angle},
        {.key = "sure_signal",
         .slot = &sensors::StructuredLightNoise::sure_signal,
         .range = {0, 1e9},
         .meaning = "Above this signal (albedo cos t / z^2) no pixel is lost.",
         .wording = {.before = " "}},
        {.key = "lost_signal",
         .slot = &sensors::StructuredLightNoise::lost_signal,
         .range = {0, 1e9},
         .meaning = "At this signal all are lost; not above `sure_signal`.",
         .wording = {.before = " "},
         .fault = fault_of_lost_signal},
        {.key = "",
         .slot = part<&sensors::StructuredLightNoise::outliers>(),
         .wording = {.written = Written::always}},
    });

template <>
inline constexpr std::array<std::string_view, 3> words_of<sensors::NoiseModel> = {"generic", "time_of_flight",
                                                                                  "structured_light"};

/// `depth.noise`.
template <>
inline constexpr auto settings_of<SourceNoise> = std::to_array<Setting<SourceNoise>>({
    {.key = "model",
     .slot = choice<&SourceNoise::model>(),
     .meaning = "Which model.",
     .wording = {.before = " noise "},
     .usual = "the preset's"},
    {.key = "scale",
     .slot = &SourceNoise::scale,
     .range = {0, 1e6},
     .meaning = "Factor on every standard deviation, step and share. 0 is no noise; what the instrument "
                "cannot see stays a hole.",
     .wording = {.before = " scale "},
     .level = Quantity::depth_noise},
});
static_assert(are_sound<sensors::StructuredLightNoise>(settings_of<sensors::StructuredLightNoise>));
static_assert(are_sound<sensors::TimeOfFlightNoise>(settings_of<sensors::TimeOfFlightNoise>));

}  // namespace seamline::inline stimuli
