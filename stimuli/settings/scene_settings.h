#pragma once
#include "stimuli/definition/study_definition.h"
#include "stimuli/settings/settings_text.h"
#include "support/text/limits.h"

namespace seamline::inline stimuli {

template <>
inline constexpr std::array<std::string_view, 2> words_of<MaterialModel> = {"diffuse", "gltf"};

[[nodiscard]] std::string fault_of_cone(const LampDefinition& lamp);

/// Names of scenes and objects become parts of file names.
template <class Named>
[[nodiscard]] std::string fault_of_name(const Named& named) {
  const bool is_plain =
      named.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
  return is_plain ? "" : "lower-case letters, digits and _ (it becomes part of file names)";
}

inline constexpr NumberRange any_place{-limits::farthest_place_m, limits::farthest_place_m, "m"};
inline constexpr NumberRange any_turn{-360, 360, "degrees"};

/// `[scene.sun]`, and each of `suns`.
template <>
inline constexpr auto settings_of<SunDefinition> = std::to_array<Setting<SunDefinition>>({
    {.key = "to_sun",
     .slot = &SunDefinition::to_sun,
     .range = {-limits::farthest_place_m, limits::farthest_place_m},
     .meaning = "Direction towards the sun.",
     .wording = {.before = "sun "},
     .changes = Changes::truth,
     .is_read_apart = true,
     .form = "not zero"},
    {.key = "irradiance_w_m2",
     .slot = &SunDefinition::irradiance_w_m2,
     .range = {0, limits::strongest_light, "W/m2"},
     .meaning = "On a plane that faces the sun.",
     .wording = {.before = " "},
     .changes = Changes::truth},
    {.key = "angular_radius_deg",
     .slot = &SunDefinition::angular_radius_deg,
     .range = {0, 45, "degrees"},
     .meaning = "0: hard shadows.",
     .wording = {.before = " ", .after = "\n"},
     .changes = Changes::truth},
});

/// Each of `lamps`.
template <>
inline constexpr auto settings_of<LampDefinition> = std::to_array<Setting<LampDefinition>>({
    {.key = "position_m",
     .slot = &LampDefinition::position_m,
     .range = any_place,
     .meaning = "Where the lamp is.",
     .wording = {.before = "lamp "},
     .changes = Changes::truth,
     .required = "where the lamp is"},
    {.key = "intensity_w_sr",
     .slot = &LampDefinition::intensity_w_sr,
     .range = {0, limits::strongest_light, "W/sr"},
     .meaning = "How bright it is.",
     .wording = {.before = " "},
     .changes = Changes::truth,
     .required = "how bright the lamp is, [red, green, blue]"},
    {.key = "shines_along",
     .slot = &LampDefinition::shines_along,
     .meaning = "Makes it a spot lamp that shines along this direction.",
     .changes = Changes::truth,
     .is_read_apart = true,
     .form = "not zero",
     .usual = "none"},
    {.key = "outer_deg",
     .slot = &LampDefinition::outer_deg,
     .range = {0.1, 90, "degrees"},
     .meaning = "No light beyond this angle.",
     .changes = Changes::truth,
     .is_read_apart = true},
    {.key = "inner_deg",
     .slot = &LampDefinition::inner_deg,
     .range = {0, 90, "degrees"},
     .meaning = "Full light within this angle of the direction, at most `outer_deg`.",
     .changes = Changes::truth,
     .is_read_apart = true,
     .fault = fault_of_cone},
});

inline constexpr std::array<std::string_view, 2> words_of_projection = {"perspective", "panorama"};

/// `[scene.camera]`.
template <>
inline constexpr auto settings_of<CameraDefinition> = std::to_array<Setting<CameraDefinition>>({
    {.key = "projection",
     .slot = Described{"text"},
     .meaning = "A panorama shows all directions; it needs `width_px` = 2 `height_px`, a multiple of 64, in "
                "all scenes, and [`[look]`](#look-how-people-look-at-panoramas). Its middle column looks "
                "whither the camera does, its middle row is the horizon. No `horizontal_fov_deg` then.",
     .changes = Changes::truth,
     .of_condition = false,
     .is_read_apart = true,
     .form = R"(`"perspective"`, `"panorama"`)",
     .usual = "`\"perspective\"`"},
    {.key = "position_m",
     .slot = &CameraDefinition::position_m,
     .range = any_place,
     .meaning = "Place of the camera. The depth panorama is captured there.",
     .wording = {.before = "camera "},
     .changes = Changes::truth},
    {.key = "look_at_m",
     .slot = &CameraDefinition::look_at_m,
     .range = any_place,
     .meaning = "A point in the middle of the picture; not straight above or below the camera.",
     .wording = {.before = " "},
     .changes = Changes::truth},
    {.key = "horizontal_fov_deg",
     .slot = &CameraDefinition::horizontal_fov_deg,
     .range = {1, 170, "degrees"},
     .meaning = "Horizontal field of view.",
     .wording = {.before = " ", .after = "\n"},
     .changes = Changes::truth},
});

/// `[[scene.object]]`.
template <>
inline constexpr auto settings_of<ObjectDefinition> = std::to_array<Setting<ObjectDefinition>>({
    {.key = "name",
     .slot = &ObjectDefinition::name,
     .meaning = "Unique in its scene; part of stimulus ids.",
     .wording = {.before = "object "},
     .changes = Changes::truth,
     .fault = fault_of_name<ObjectDefinition>,
     .required = "a text in quotes",
     .form = "`a-z`, `0-9`, `_`"},
    {.key = "file",
     .slot = &ObjectDefinition::file,
     .meaning = "`builtin:statue`, `teapot`, `creature`, `beast`, `lion`, `dragon`.",
     .wording = {.before = " "},
     .changes = Changes::truth,
     .required = "a text in quotes",
     .form = "glTF 2.0, or built in"},
    {.key = "position_m",
     .slot = &ObjectDefinition::position_m,
     .range = any_place,
     .meaning = "Where the file's origin goes.",
     .wording = {.before = " "},
     .changes = Changes::truth},
    {.key = "rotation_deg",
     .slot = &ObjectDefinition::rotation_deg,
     .range = any_turn,
     .meaning = "Pitch about X, yaw about Y, roll about Z. Roll is applied first, then pitch, then yaw.",
     .wording = {.before = " "},
     .changes = Changes::truth},
    {.key = "scale",
     .slot = &ObjectDefinition::scale,
     .range = {1e-9, limits::farthest_place_m},
     .meaning = "Factor on its size.",
     .wording = {.before = " "},
     .changes = Changes::truth},
    {.key = "exempt_from_shape_rules",
     .slot = &ObjectDefinition::exempt_from_shape_rules,
     .meaning = "[`check`](scene_rules.md) leaves out its area and silhouette.",
     .changes = Changes::presentation},
    {.key = "path",
     .slot = Described{"table"},
     .meaning = "How it moves in a [clip](#clip-things-that-move).",
     .changes = Changes::truth,
     .of_condition = false,
     .usual = "none"},
    {.key = "animation",
     .slot = Described{"table"},
     .meaning = "What of its file plays in a [clip](#clip-things-that-move).",
     .changes = Changes::truth,
     .of_condition = false,
     .usual = "none"},
    {.key = "rest",
     .slot = &ObjectDefinition::rest,
     .meaning = "Lets it down until it [stands on the scene](../how-to/settling.md). Needs Bullet.",
     .wording = {.before = " rests", .written = Written::where_unusual, .yes = ""},
     .changes = Changes::truth},
});

/// Beside `environment`.
template <>
inline constexpr auto settings_of<EnvironmentDefinition> = std::to_array<Setting<EnvironmentDefinition>>({
    {.key = "environment",
     .slot = &EnvironmentDefinition::file,
     .meaning = "A map in its place: equirectangular, twice as wide as high, the centre looks along -Z, the "
                "right half is +X. `builtin:clear_sky`, `builtin:window_room`.",
     .wording = {.before = "environment map "},
     .changes = Changes::truth,
     .is_read_apart = true,
     .form = "`.exr` or `.hdr`, or built in",
     .usual = "none"},
    {.key = "environment_rotation_deg",
     .slot = &EnvironmentDefinition::rotation_deg,
     .range = any_turn,
     .meaning = "Rotates the map about +Y, counter-clockwise seen from above.",
     .wording = {.before = " "},
     .changes = Changes::truth},
    {.key = "environment_strength",
     .slot = &EnvironmentDefinition::strength,
     .range = {0, limits::strongest_light},
     .meaning = "Factor on the map's radiance.",
     .wording = {.before = " ", .after = "\n"},
     .changes = Changes::truth},
});

/// Objects, suns, camera, environment and lamps of a scene that say their own.
[[nodiscard]] std::string text_inside(const SceneDefinition& scene);
[[nodiscard]] bool is_nothing_inside(const SceneDefinition& scene);

/// Light, surfaces and exposure of a scene: of `[[scene]]`, and of a `[[condition]]` for all scenes.
template <>
inline constexpr auto settings_of<SceneDefinition> = std::to_array<Setting<SceneDefinition>>({
    {.key = "name",
     .slot = &SceneDefinition::name,
     .meaning = "Part of stimulus ids.",
     .wording = {.before = "scene "},
     .changes = Changes::truth,
     .of_condition = false,
     .is_read_apart = true,
     .fault = fault_of_name<SceneDefinition>,
     .required = "a text in quotes",
     .form = "`a-z`, `0-9`, `_`"},
    {.key = "file",
     .slot = &SceneDefinition::file,
     .meaning = "`builtin:bedroom`, `gazebo`, `atrium`, `furnished_room`, `painted_room`, `loft`, "
                "`loft_open`.",
     .wording = {.before = " "},
     .changes = Changes::truth,
     .of_condition = false,
     .is_read_apart = true,
     .required = "a text in quotes",
     .form = "glTF 2.0, or built in"},
    {.key = "artifacts",
     .slot = Described{"list of texts"},
     .meaning = "[Artifacts](../explanation/seams.md#four-kinds-of-seam) that are shown in this scene. "
                "`reflection` needs glossy objects.",
     .of_condition = false,
     .is_read_apart = true,
     .form =
         R"(`"receiver"`, `"shadow"`, `"occlusion"`, `"overlap"`, `"bounce"`, `"reflection"`, `"all"`, `"none"`)",
     .usual = "required"},
    {.key = "suns",
     .slot = Described{"list of tables"},
     .meaning = "Suns, with the keys of `[scene.sun]`.",
     .changes = Changes::truth,
     .is_read_apart = true,
     .usual = "the file's"},
    {.key = "lamps",
     .slot = Described{"list of tables"},
     .meaning = "Lamps without size, see below.",
     .changes = Changes::truth,
     .is_read_apart = true,
     .usual = "the file's"},
    {.key = "sun",
     .slot = Described{"table"},
     .meaning = "`[scene.sun]`.",
     .changes = Changes::truth,
     .of_condition = false,
     .is_read_apart = true,
     .usual = "the file's"},
    {.key = "camera",
     .slot = Described{"table"},
     .meaning = "`[scene.camera]`.",
     .changes = Changes::truth,
     .of_condition = false,
     .is_read_apart = true,
     .usual = "the file's first"},
    {.key = "object",
     .slot = Described{"three tables"},
     .meaning = "`[[scene.object]]`: left, middle, right. Another number where "
                "[`task.objects`](#task-what-a-trial-asks) says so.",
     .changes = Changes::truth,
     .of_condition = false,
     .is_read_apart = true,
     .usual = "required"},
    {.key = "environment_radiance",
     .slot = &SceneDefinition::environment_radiance,
     .range = {0, limits::strongest_light, "W/m2/sr"},
     .meaning = "Constant light from every direction.",
     .wording = {.before = " env "},
     .changes = Changes::truth,
     .is_read_apart = true},
    {.key = "ambient_occlusion",
     .slot = &SceneDefinition::ambient_occlusion,
     .meaning = "No sun and no bounce: only how much of the environment is seen.",
     .wording = {.before = " ao "},
     .changes = Changes::truth},
    {.key = "ao_distance_m",
     .slot = &SceneDefinition::ao_distance_m,
     .range = {1e-9, limits::farthest_place_m, "m"},
     .meaning = "How far ambient occlusion looks.",
     .wording = {.before = " "},
     .changes = Changes::truth},
    {.key = "bounces",
     .slot = &SceneDefinition::bounces,
     .range = {0, 1024},
     .meaning = "Diffuse scatterings after the first.",
     .wording = {.before = " bounces "},
     .changes = Changes::truth},
    {.key = "albedo",
     .slot = &SceneDefinition::albedo,
     .range = {0, 1},
     .meaning = "Of the depth mesh, and of meshes without a material.",
     .wording = {.before = " albedo "},
     .changes = Changes::truth},
    {.key = "exposure_ev",
     .slot = &SceneDefinition::exposure_ev,
     .range = {-60, 60, "stops"},
     .meaning = "display = linear * 2^exposure_ev, then sRGB, clipped at 1.",
     .wording = {.before = " ev ", .after = "\n"},
     .changes = Changes::truth},
    {.key = "",
     .slot = Part<SceneDefinition>{.text = text_inside, .is_usual = is_nothing_inside},
     .wording = {.written = Written::always}},
    {.key = "sun_radius_deg",
     .slot = &SceneDefinition::sun_radius_deg,
     .range = {0, 45, "degrees"},
     .meaning = "Angular radius of every sun.",
     .wording = {.before = "sun radius ", .after = "\n", .written = Written::where_unusual},
     .level = Quantity::sun_radius_deg,
     .changes = Changes::truth,
     .usual = "the suns'"},
    {.key = "materials",
     .slot = choice<&SceneDefinition::materials>(),
     .meaning = "Base colours alone, as in the paper; or metals, gloss and normal maps, too "
                "([table](../how-to/rendering.md#choose-a-material-model)).",
     .wording = {.before = "materials ", .after = "\n", .written = Written::where_unusual},
     .changes = Changes::truth},
    {.key = "object_metallic",
     .slot = &SceneDefinition::object_metallic,
     .range = {0, 1},
     .meaning = "Metalness of all virtual objects.",
     .beside = {"materials",
                {"gltf"},
                "materials = \"gltf\" beside it: diffuse surfaces have no such number"},
     .wording = {.before = "object metallic ", .after = "\n", .written = Written::where_unusual},
     .changes = Changes::truth,
     .usual = "the files'"},
    {.key = "object_roughness",
     .slot = &SceneDefinition::object_roughness,
     .range = {0, 1},
     .meaning = "Roughness of all virtual objects.",
     .beside = {"materials",
                {"gltf"},
                "materials = \"gltf\" beside it: diffuse surfaces have no such number"},
     .wording = {.before = "object roughness ", .after = "\n", .written = Written::where_unusual},
     .changes = Changes::truth,
     .usual = "the files'"},
});
static_assert(are_sound<SceneDefinition>(settings_of<SceneDefinition>));
static_assert(are_sound<LampDefinition>(settings_of<LampDefinition>));
static_assert(are_sound<ObjectDefinition>(settings_of<ObjectDefinition>));

}  // namespace seamline::inline stimuli
