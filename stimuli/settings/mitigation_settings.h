#pragma once
#include "stimuli/definition/mitigation.h"
#include "stimuli/settings/settings_text.h"

namespace seamline::inline stimuli {

inline constexpr std::array<std::string_view, 3> words_of_occlusion_mitigation = {"none", "mask", "edges"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<ShadowMitigation> = {"none", "matte", "detected"};
template <>
inline constexpr std::array<std::string_view, 2> words_of<Blockers> = {"sheets", "layers"};

[[nodiscard]] std::string fault_of_mask_width(const Mitigation& mitigation);
[[nodiscard]] std::string fault_of_matte_width(const Mitigation& mitigation);

/// `[mitigation]`.
template <>
inline constexpr auto settings_of<Mitigation> = std::to_array<Setting<Mitigation>>({
    {.key = "occlusion",
     .slot = one_of<&Mitigation::occlusion, Occlusion::mesh, Occlusion::mask, Occlusion::edges>(
         words_of_occlusion_mitigation),
     .meaning = "Who is in front: the depth mesh; a painted mask; the mesh's outlines moved onto the "
                "photograph's edges.",
     .wording = {.before = ", occlusion ", .written = Written::where_unusual}},
    {.key = "mask_width_px",
     .slot = &Mitigation::mask_width_px,
     .range = {16, 16384, "px"},
     .meaning = "Texels around of the mask.",
     .beside = {"occlusion", {"mask", "edges"}},
     .wording = {.before = " ", .written = Written::where_used},
     .fault = fault_of_mask_width,
     .form = "even"},
    {.key = "shadow",
     .slot = choice<&Mitigation::shadow>(),
     .meaning = "Whether a real surface is in the sun: the depth mesh; a painted matte; a matte found in the "
                "photograph.",
     .wording = {.before = ", shadow ", .written = Written::where_unusual}},
    {.key = "matte_width_px",
     .slot = &Mitigation::matte_width_px,
     .range = {16, 16384, "px"},
     .meaning = "Texels around of the matte.",
     .beside = {"shadow", {"matte", "detected"}},
     .wording = {.before = " ", .written = Written::where_used},
     .fault = fault_of_matte_width,
     .form = "even"},
    {.key = "blockers",
     .slot = choice<&Mitigation::blockers>(),
     .meaning = "The paper's mesh, or one that is cut where distance jumps, with layers behind.",
     .wording = {.before = ", blockers ", .written = Written::where_unusual}},
});
static_assert(are_sound<Mitigation>(settings_of<Mitigation>));

}  // namespace seamline::inline stimuli
