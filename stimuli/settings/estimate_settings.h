#pragma once
#include "sensors/files/depth_words.h"
#include "stimuli/definition/depth_chain.h"
#include "stimuli/settings/settings_text.h"

namespace seamline::inline stimuli {

template <>
inline constexpr auto words_of<sensors::DepthValue> = sensors::words_of_values;
template <>
inline constexpr auto words_of<sensors::DepthPacking> = sensors::words_of_packings;
template <>
inline constexpr std::array<std::string_view, 2> words_of<EstimateAlignment> = {"none", "least_squares"};

/// Of `source = "file"`, where its depth is an estimate.
template <>
inline constexpr auto settings_of<FileEstimate> = std::to_array<Setting<FileEstimate>>({
    {.key = "value",
     .slot = choice<&FileEstimate::value>(),
     .meaning = "Of an [estimate](../how-to/estimated_depth.md): what its values are. `\"inverse\"`: 1 / "
                "distance = scale * value + shift; `\"relative\"`: distance = scale * value + shift.",
     .wording = {.before = " value "}},
    {.key = "align",
     .slot = choice<&FileEstimate::align>(),
     .meaning = "Where scale and shift come from: stated, or least squares on the true depth.",
     .beside = {"value", {"inverse", "relative"}},
     .wording = {.before = " align "}},
    {.key = "scale",
     .slot = &FileEstimate::scale,
     .range = {1e-12, 1e12},
     .meaning = "Stated; required of values that are no metres.",
     .beside = {"align", {"none"}},
     .wording = {.before = " scale ", .written = Written::where_unusual},
     .usual = "required"},
    {.key = "shift",
     .slot = &FileEstimate::shift,
     .range = {-1e12, 1e12},
     .meaning = "Stated.",
     .beside = {"align", {"none"}},
     .wording = {.before = " shift ", .written = Written::where_unusual}},
    {.key = "estimate_share",
     .slot = &FileEstimate::share,
     .range = {0, 1},
     .meaning = "How much of the estimate is taken: 1 / distance is mixed with the truth's. 0 is the truth, "
                "and the same bytes as a source without errors.",
     .wording = {.before = " share ", .written = Written::where_unusual},
     .level = Quantity::estimate_share},
});
static_assert(are_sound<FileEstimate>(settings_of<FileEstimate>));

/// Of `source = "file"` with `projection = "panorama"`.
template <>
inline constexpr auto settings_of<PanoramaFile> = std::to_array<Setting<PanoramaFile>>({
    {.key = "file",
     .slot = &PanoramaFile::file,
     .meaning = "As of a sensor's file.",
     .wording = {.before = " file "},
     .is_read_apart = true},
    {.key = "metres_per_step",
     .slot = &PanoramaFile::metres_per_step,
     .range = {1e-9, 1e9, "m"},
     .meaning = "As of a sensor's file.",
     .wording = {.before = " step ", .written = Written::where_unusual}},
    {.key = "packing",
     .slot = choice<&PanoramaFile::packing>(),
     .meaning = "As of a sensor's file.",
     .wording = {.before = " ", .written = Written::where_unusual}},
    {.key = "", .slot = part<&PanoramaFile::estimate>(), .wording = {.written = Written::always}},
});

}  // namespace seamline::inline stimuli
