#pragma once
#include "stimuli/definition/study_definition.h"
#include "stimuli/settings/settings_text.h"

namespace seamline::inline stimuli {

template <>
inline constexpr std::array<std::string_view, 2> words_of<MeshDensity> = {"adaptive", "full"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<MeshAlbedo> = {"constant", "truth", "photograph"};

/// At the top of a study file.
template <>
inline constexpr auto settings_of<StudyDefinition> = std::to_array<Setting<StudyDefinition>>({
    {.key = "width_px",
     .slot = &StudyDefinition::width_px,
     .range = {8, 16384, "px"},
     .meaning = "Width of the pictures.",
     .changes = Changes::truth,
     .of_condition = false},
    {.key = "height_px",
     .slot = &StudyDefinition::height_px,
     .range = {8, 16384, "px"},
     .meaning = "Height of the pictures.",
     .changes = Changes::truth,
     .of_condition = false},
    {.key = "samples_per_pixel",
     .slot = &StudyDefinition::samples_per_pixel,
     .range = {1, 65536},
     .meaning = "Camera samples of a pixel. Powers of two are best.",
     .changes = Changes::truth,
     .of_condition = false},
    {.key = "seed",
     .slot = &StudyDefinition::seed,
     .range = {0, 9007199254740991},  // all whole numbers up to here are numbers of TOML and JSON
     .meaning = "Seed of all sample points and of the orders of trials. A page for browsers shows orders, so "
                "give its study a long one that nobody knows.",
     .changes = Changes::truth,
     .of_condition = false},
});

/// At the top of a study file and of a condition.
template <>
inline constexpr auto settings_of<DepthSettings> = std::to_array<Setting<DepthSettings>>({
    {.key = "mesh",
     .slot = choice<&DepthSettings::mesh>(),
     .meaning = "Depth mesh: as few triangles as `mesh_tolerance` allows, or every vertex.",
     .level = Quantity::mesh_tolerance},
    {.key = "mesh_tolerance",
     .slot = &DepthSettings::mesh_tolerance,
     .range = {1e-9, 1},
     .meaning = "Largest relative error along a ray that the adaptive mesh may make.",
     .level = Quantity::mesh_tolerance},
    {.key = "mesh_albedo",
     .slot = choice<&DepthSettings::albedo>(),
     .meaning =
         "[Albedo of the depth mesh](../developers/design_of_parts.md#12-what-the-depth-mesh-is-made-of): "
         "one number, the truth's by direction, or read out of the photograph. Refused where no artifact "
         "looks at it (it takes `bounce`, `reflection`, `all` or `isolation = \"mask\"`)."},
    {.key = "yaw_texels",
     .slot = &DepthSettings::yaw_texels,
     .range = {-16384, 16384, "texels"},
     .meaning = "Rotates the sampling grid of the depth map by this many texels. Only the fractional part "
                "matters.",
     .is_read_apart = true},
});

}  // namespace seamline::inline stimuli
