#pragma once
#include "stimuli/definition/study_definition.h"
#include "stimuli/settings/settings_text.h"

namespace seamline::inline stimuli {

template <>
inline constexpr std::array<std::string_view, 2> words_of<Isolation> = {"query", "mask"};
template <>
inline constexpr std::array<std::string_view, 2> words_of<MeshDensity> = {"adaptive", "full"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<MeshAlbedo> = {
    word(MeshAlbedo::constant), word(MeshAlbedo::truth), word(MeshAlbedo::photograph)};

/// It becomes part of file names.
[[nodiscard]] std::string fault_of_name(const ConditionDefinition& condition);

/// At the top of a study file.
template <>
inline constexpr auto settings_of<StudyDefinition> = std::to_array<Setting<StudyDefinition>>({
    {.key = "format",
     .slot = Described{"text"},
     .meaning = "The format of the file.",
     .changes = Changes::presentation,
     .of_condition = false,
     .is_read_apart = true,
     .form = "`\"seamline study 1\"`",
     .usual = "required"},
    {.key = "name",
     .slot = &StudyDefinition::name,
     .meaning = "Name of the study. A set folder belongs to one study.",
     .changes = Changes::presentation,
     .of_condition = false,
     .required = "a text in quotes"},
    {.key = "isolation",
     .slot = choice<&StudyDefinition::isolation>(),
     .meaning = "How one artifact is [kept apart](../explanation/seams.md#isolation-one-seam-at-a-time)."},
    {.key = "depth_width_px",
     .slot = Described{"list of whole numbers"},
     .range = {2, 16384, "px"},
     .meaning = "Widths W of the depth maps (W x W/2): the levels. Where `[level]` names another quantity: "
                "one number, the width of all maps; left out beside `texels_per_degree`, `depth_samples` "
                "and beside a sensor.",
     .is_read_apart = true,
     .form = "even",
     .usual = "required"},
    {.key = "procedure",
     .slot = Described{"text"},
     .meaning = "Every stimulus once in an order of each participant's own; or trials placed by the answers, "
                "see `[quest_plus]` and `[staircase]`.",
     .changes = Changes::presentation,
     .of_condition = false,
     .is_read_apart = true,
     .form = R"(`"constant"`, `"quest_plus"`, `"staircase"`)",
     .usual = "`\"constant\"`"},
    {.key = "participant_form",
     .slot = Described{"boolean"},
     .meaning = "`false`: no form.",
     .changes = Changes::presentation,
     .of_condition = false,
     .is_read_apart = true,
     .usual = "true"},
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

/// `[[condition]]`, beside what else of the study it may set.
template <>
inline constexpr auto settings_of<ConditionDefinition> = std::to_array<Setting<ConditionDefinition>>({
    {.key = "name",
     .slot = &ConditionDefinition::name,
     .meaning = "Part of stimulus ids: `room-receiver-statue-soft-0512`.",
     .fault = fault_of_name,
     .required = "a text in quotes",
     .form = "at most 60 of `a-z`, `0-9`, `_`"},
    {.key = "instructions",
     .slot = &ConditionDefinition::instructions,
     .meaning = "Read before the condition's block of trials; it needs `task.blocks`, or a "
                "`[condition.task]`. Not part of the hash.",
     .changes = Changes::presentation,
     .usual = "none"},
    {.key = "isolation",
     .slot = choice<&ConditionDefinition::isolation>(),
     .meaning = "As at the top level.",
     .usual = "the study's"},
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
static_assert(are_sound<StudyDefinition>(settings_of<StudyDefinition>));

}  // namespace seamline::inline stimuli
