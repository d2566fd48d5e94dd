#pragma once
#include "sensors/repair/repair.h"
#include "stimuli/settings/settings_text.h"

namespace seamline::inline stimuli {

/// `depth.repair`, of each method.
template <>
inline constexpr auto settings_of<sensors::MedianRepair> = std::to_array<Setting<sensors::MedianRepair>>({
    {.key = "radius_px",
     .slot = &sensors::MedianRepair::radius_px,
     .range = {1, 50, "px"},
     .meaning = "Half of the window.",
     .wording = {.before = " radius ", .after = " px"}},
    {.key = "fills",
     .slot = &sensors::MedianRepair::fills,
     .meaning = "Whether holes get a depth.",
     .wording = {.before = ", ", .yes = "fills holes", .no = "fills no holes"}},
});

template <>
inline constexpr auto settings_of<sensors::JointBilateralRepair> =
    std::to_array<Setting<sensors::JointBilateralRepair>>({
        {.key = "radius_px",
         .slot = &sensors::JointBilateralRepair::radius_px,
         .range = {1, 50, "px"},
         .meaning = "Half of the window.",
         .wording = {.before = " radius ", .after = " px"}},
        {.key = "sigma_px",
         .slot = &sensors::JointBilateralRepair::sigma_px,
         .range = {1e-9, 1e9, "px"},
         .meaning = "Width of the weight by place.",
         .wording = {.before = ", sigma ", .after = " px"}},
        {.key = "sigma_colour",
         .slot = &sensors::JointBilateralRepair::sigma_colour,
         .range = {1e-9, 1e9},
         .meaning = "Width of the weight by colour, in the guide's units.",
         .wording = {.before = " and "}},
        {.key = "fills",
         .slot = &sensors::JointBilateralRepair::fills,
         .meaning = "Whether holes get a depth.",
         .wording = {.before = ", ", .yes = "fills holes", .no = "fills no holes"}},
        {.key = "least_weight",
         .slot = &sensors::JointBilateralRepair::least_weight,
         .range = {1e-9, 1e9},
         .meaning = "A hole is filled where the weights sum up to this.",
         .beside = {.key = "fills", .is_refused = false},
         .wording = {.before = " from weight ", .written = Written::where_used}},
    });

template <>
inline constexpr auto settings_of<sensors::PlaneRepair> = std::to_array<Setting<sensors::PlaneRepair>>({
    {.key = "most_planes",
     .slot = &sensors::PlaneRepair::most_planes,
     .range = {1, 100, "planes"},
     .meaning = "Planes that are looked for.",
     .wording = {.before = " most "}},
    {.key = "least_share",
     .slot = &sensors::PlaneRepair::least_share,
     .range = {1e-6, 1},
     .meaning = "Share of all pixels that a plane needs.",
     .wording = {.before = ", share "}},
    {.key = "tolerance_m",
     .slot = &sensors::PlaneRepair::tolerance_m,
     .range = {1e-9, 1e3, "m"},
     .meaning = "How far a pixel may be from its plane, along the ray.",
     .wording = {.before = ", tolerance ", .after = " m"}},
    {.key = "tolerance_relative",
     .slot = &sensors::PlaneRepair::tolerance_relative,
     .range = {0, 1},
     .meaning = "Added: this share of the depth.",
     .wording = {.before = " and "}},
    {.key = "draws",
     .slot = &sensors::PlaneRepair::draws,
     .range = {1, 100000},
     .meaning = "Samples of three pixels for each plane.",
     .wording = {.before = ", draws "}},
    {.key = "seed",
     .slot = &sensors::PlaneRepair::seed,
     .range = {0, 2147483647},
     .meaning = "Seed of these samples.",
     .wording = {.before = ", seed "}},
});

template <>
inline constexpr std::array<std::string_view, 5> words_of<sensors::RepairMethod> = {
    "none", "nearest", "median", "joint_bilateral", "planes"};

static_assert(are_sound<sensors::JointBilateralRepair>(settings_of<sensors::JointBilateralRepair>));
static_assert(are_sound<sensors::PlaneRepair>(settings_of<sensors::PlaneRepair>));

}  // namespace seamline::inline stimuli
