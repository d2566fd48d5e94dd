#pragma once
#include "stimuli/definition/moving/clip_definition.h"
#include "stimuli/definition/moving/file_moment.h"
#include "stimuli/settings/settings_text.h"
#include "support/text/limits.h"

namespace seamline::inline stimuli {

template <>
inline constexpr std::array<std::string_view, 2> words_of<ClipQuestion> = {"during", "after"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<ObjectMotion> = {"line", "turn", "keys"};
inline constexpr std::array<std::string_view, 2> words_of_plays = {"loop", "once"},
                                                 words_of_then = {"back", "stop"};

/// `[clip]`.
template <>
inline constexpr auto settings_of<ClipDefinition> = std::to_array<Setting<ClipDefinition>>({
    {.key = "frames",
     .slot = &ClipDefinition::frames,
     .range = {2, 999, "frames"},
     .meaning = "Frames of a clip.",
     .wording = {.before = "clip ", .after = " frames "},
     .changes = Changes::truth,
     .of_condition = false},
    {.key = "frames_per_s",
     .slot = &ClipDefinition::frames_per_s,
     .range = {1, 240, "frames per second"},
     .meaning = "Frames a second.",
     .wording = {.after = " per s "},
     .changes = Changes::truth,
     .of_condition = false},
    {.key = "plays",
     .slot = one_of<&ClipDefinition::loops, true, false>(words_of_plays),
     .meaning = "What follows the last frame: the first, or nothing more.",
     .wording = {.after = " question "},
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "question",
     .slot = choice<&ClipDefinition::question>(),
     .meaning = "When people may answer. `\"after\"` needs `plays = \"once\"`.",
     .wording = {.after = "\n"},
     .changes = Changes::presentation,
     .of_condition = false},
});
static_assert(are_sound<ClipDefinition>(settings_of<ClipDefinition>));

inline constexpr NumberRange places_m = {-limits::farthest_place_m, limits::farthest_place_m, "m"};

/// `path` of an object: on a line.
template <>
inline constexpr auto settings_of<LineMotion> = std::to_array<Setting<LineMotion>>({
    {.key = "to_m",
     .slot = &LineMotion::to_m,
     .range = places_m,
     .meaning = "It goes from `position_m` to there.",
     .wording = {.before = "line to "},
     .of_condition = false,
     .required = "where the line ends"},
    {.key = "speed_m_s",
     .slot = &LineMotion::speed_m_s,
     .range = {0, 100, "m/s"},
     .meaning = "Its speed; left out where `object_speed_m_s` is the level.",
     .wording = {.before = " at "},
     .level = Quantity::object_speed_m_s,
     .of_condition = false,
     .usual = "required"},
    {.key = "then",
     .slot = one_of<&LineMotion::comes_back, true, false>(words_of_then),
     .meaning = "What it does at the end of the line.",
     .of_condition = false},
    {.key = "",
     .slot = &LineMotion::comes_back,
     .wording = {.written = Written::where_unusual, .no = " and stops"},
     .of_condition = false},
});
static_assert(are_sound<LineMotion>(settings_of<LineMotion>));

/// About its own vertical.
template <>
inline constexpr auto settings_of<TurnMotion> = std::to_array<Setting<TurnMotion>>({
    {.key = "speed_deg_s",
     .slot = &TurnMotion::speed_deg_s,
     .range = {-3600, 3600, "degrees/s"},
     .meaning = "Turn about its own vertical, counter-clockwise from above.",
     .wording = {.before = "turn "},
     .of_condition = false},
});

template <>
inline constexpr auto settings_of<ObjectPose> = std::to_array<Setting<ObjectPose>>({
    {.key = "position_m",
     .slot = &ObjectPose::position_m,
     .range = places_m,
     .meaning = "Where it is then.",
     .wording = {.before = " "},
     .of_condition = false},
    {.key = "rotation_deg",
     .slot = &ObjectPose::rotation_deg,
     .range = {-36000, 36000, "degrees"},
     .meaning = "How it is turned then.",
     .wording = {.before = " "},
     .of_condition = false},
});

/// One of `keys`; beside the rows of its pose.
template <>
inline constexpr auto settings_of<MotionKey> = std::to_array<Setting<MotionKey>>({
    {.key = "time_s",
     .slot = &MotionKey::time_s,
     .range = {-600, 600, "s"},
     .meaning = "When it is there.",
     .wording = {.before = " "},
     .of_condition = false},
});

/// One of `keys` of a camera's `path`.
template <>
inline constexpr auto settings_of<CameraKey> = std::to_array<Setting<CameraKey>>({
    {.key = "time_s",
     .slot = &CameraKey::time_s,
     .range = {-600, 600, "s"},
     .meaning = "When it is there.",
     .wording = {.before = " "},
     .of_condition = false},
    {.key = "position_m",
     .slot = &CameraKey::position_m,
     .range = places_m,
     .meaning = "Where it is then.",
     .wording = {.before = " "},
     .of_condition = false},
    {.key = "look_at_m",
     .slot = &CameraKey::look_at_m,
     .range = places_m,
     .meaning = "What it looks at then.",
     .wording = {.before = " "},
     .of_condition = false},
});

/// `[[scene.node]]`: a node of the background.
template <>
inline constexpr auto settings_of<PlacedNode> = std::to_array<Setting<PlacedNode>>({
    {.key = "name",
     .slot = &PlacedNode::name,
     .meaning = "The node's name in the scene's file. What hangs on it moves with it.",
     .of_condition = false,
     .required = "a name of a node"},
    {.key = "position_m",
     .slot = &PlacedNode::position_m,
     .range = places_m,
     .meaning = "How far it stands from where the file has it, along its parent's axes.",
     .of_condition = false},
    {.key = "rotation_deg",
     .slot = &PlacedNode::rotation_deg,
     .range = {-36000, 36000, "degrees"},
     .meaning = "How it is turned about its own origin: pitch, yaw, roll.",
     .of_condition = false},
    {.key = "path",
     .slot = Described{"table"},
     .meaning = "How it moves in a clip, as an object's, from there.",
     .of_condition = false},
});

/// `animation` of an object or of a scene.
template <>
inline constexpr auto settings_of<FileAnimation> = std::to_array<Setting<FileAnimation>>({
    {.key = "name",
     .slot = &FileAnimation::name,
     .meaning = "The animation's name in the file; its number from 0 where it has none.",
     .of_condition = false,
     .usual = "the only one"},
    {.key = "from_s",
     .slot = &FileAnimation::from_s,
     .range = {0, 600, "s"},
     .meaning = "Where the part of it begins that is played.",
     .of_condition = false},
    {.key = "to_s",
     .slot = &FileAnimation::to_s,
     .range = {0, 600, "s"},
     .meaning = "Where that part ends.",
     .of_condition = false,
     .usual = "its end"},
    {.key = "repeats",
     .slot = &FileAnimation::repeats,
     .meaning = "Begins anew at `from_s`; needs `to_s`. Else it stands at its end.",
     .of_condition = false},
    {.key = "speed",
     .slot = &FileAnimation::speed,
     .range = {-100, 100},
     .meaning = "Its seconds in one second.",
     .of_condition = false},
});
static_assert(are_sound<FileAnimation>(settings_of<FileAnimation>));

/// From key to key.
template <>
inline constexpr auto settings_of<KeyedMotion> = std::to_array<Setting<KeyedMotion>>({
    {.key = "keys",
     .slot = Described{"list of tables"},
     .meaning = "`time_s`, `position_m`, `rotation_deg`; straight lines between.",
     .of_condition = false,
     .form = "2 to 1000",
     .usual = "required"},
});

}  // namespace seamline::inline stimuli
