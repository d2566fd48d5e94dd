#pragma once
#include "stimuli/definition/views/view.h"
#include "stimuli/settings/settings_text.h"
#include "support/text/limits.h"

namespace seamline::inline stimuli {

template <>
inline constexpr std::array<std::string_view, 6> words_of<ViewKind> = {
    "mono", "side_by_side", "anaglyph", "interleaved", "2d_plus_depth", "omnidirectional"};
template <>
inline constexpr std::array<std::string_view, 2> words_of<Parallax> = {"truth", "depth"};
template <>
inline constexpr std::array<std::string_view, 4> words_of<AnaglyphMatrix> = {"colour", "half_colour", "grey",
                                                                             "dubois"};

/// Under `kind = "interleaved"`, in the same table.
template <>
inline constexpr auto settings_of<LensSheet> = std::to_array<Setting<LensSheet>>({
    {.key = "pitch_subpixels",
     .slot = &LensSheet::pitch_subpixels,
     .range = {1, 10000, "sub-pixels"},
     .meaning = "Width of a lens along a row. Beside `kind = \"interleaved\"`.",
     .wording = {.before = ", pitch "}},
    {.key = "slant_deg",
     .slot = &LensSheet::slant_deg,
     .range = {-80, 80, "degrees"},
     .meaning = "Lean of the lenses; positive: to the right downwards. Beside `kind = \"interleaved\"`.",
     .wording = {.before = " slant "}},
    {.key = "offset_subpixels",
     .slot = &LensSheet::offset_subpixels,
     .range = {-10000, 10000, "sub-pixels"},
     .meaning = "A lens' left edge in the screen's first row. Beside `kind = \"interleaved\"`.",
     .wording = {.before = " offset "}},
});

[[nodiscard]] std::string sheet_text(const View& view);
[[nodiscard]] bool is_usual_sheet(const View& view);
[[nodiscard]] std::string panel_text(const View& view);
[[nodiscard]] bool names_no_panel(const View& view);

/// `[view]`. A study may name what only some of its conditions use, so that what is idle is refused by
/// study_file_view.cpp.
template <>
inline constexpr auto settings_of<View> = std::to_array<Setting<View>>({
    {.key = "kind",
     .slot = choice<&View::kind>(),
     .meaning = "How the picture is shown.",
     .wording = {.written = Written::where_unusual},
     .changes = Changes::truth},
    {.key = "max_depth_m",
     .slot = &View::max_depth_m,
     .range = {1e-3, limits::farthest_place_m, "m"},
     .meaning = "The depth that white stands for.",
     .beside = {.key = "kind", .words = {"2d_plus_depth"}, .is_refused = false},
     .wording = {.before = ", depth up to ", .after = " m", .written = Written::where_used},
     .changes = Changes::truth,
     .usual = "required"},
    {.key = "",
     .slot = &View::views,
     .beside = {.key = "kind",
                .words = {"side_by_side", "anaglyph", "interleaved", "omnidirectional"},
                .is_refused = false},
     .wording = {.before = ", ", .after = " views", .written = Written::where_used}},
    {.key = "separation_m",
     .slot = &View::separation_m,
     .range = {1e-6, 1000, "m"},
     .meaning = "Between neighbouring eyes.",
     .beside = {.key = "kind",
                .words = {"side_by_side", "anaglyph", "interleaved", "omnidirectional"},
                .is_refused = false},
     .wording = {.before = " ", .after = " m apart", .written = Written::where_used},
     .changes = Changes::truth},
    {.key = "zero_parallax_m",
     .slot = &View::zero_parallax_m,
     .range = {1e-3, limits::farthest_place_m, "m in front of the eyes"},
     .meaning = "Distance at which the screen seems to be.",
     .beside = {.key = "kind", .words = {"side_by_side", "anaglyph", "interleaved"}, .is_refused = false},
     .wording = {.before = ", zero parallax ", .after = " m", .written = Written::where_used},
     .changes = Changes::truth,
     .usual = "required"},
    {.key = "views",
     .slot = &View::views,
     .range = {2, 64, "views"},
     .meaning = "Number of eyes.",
     .beside = {.key = "kind", .words = {"interleaved", "omnidirectional"}, .is_refused = false},
     .changes = Changes::truth},
    {.key = "matrix",
     .slot = choice<&View::matrix>(),
     .meaning = "Colours of the glasses' picture.",
     .beside = {.key = "kind", .words = {"anaglyph"}, .is_refused = false},
     .wording = {.before = ", matrix ", .written = Written::where_used},
     .changes = Changes::truth},
    {.key = "parallax",
     .slot = choice<&View::parallax>(),
     .meaning =
         "Where the parallax of real surfaces comes from: a photograph for each eye, or one photograph on "
         "the depth mesh.",
     .beside = {.key = "kind", .words = {"omnidirectional"}, .is_refused = false},
     .wording = {.before = ", parallax by ", .written = Written::where_unusual},
     .changes = Changes::truth},
    {.key = "",
     .slot = Part<View>{.text = sheet_text, .is_usual = is_usual_sheet},
     .beside = {.key = "kind", .words = {"interleaved"}, .is_refused = false},
     .wording = {.written = Written::where_used}},
    {.key = "preset",
     .slot = Described{"text"},
     .meaning = "Five views, pitch 5, slant 18.435 degrees.",
     .beside = {.key = "kind", .words = {"interleaved"}, .is_refused = false},
     .changes = Changes::truth,
     .form = "`\"five_views\"`",
     .usual = "none"},
    {.key = "panel_px",
     .slot = Described{"[width, height]"},
     .range = {8, 65536, "px each"},
     .meaning = "The screen, one for the whole study. Required under a lens sheet.",
     .beside = {.key = "kind",
                .words = {"side_by_side", "anaglyph", "interleaved", "2d_plus_depth"},
                .is_refused = false},
     .changes = Changes::truth,
     .usual = "any screen"},
    {.key = "",
     .slot = Part<View>{.text = panel_text, .is_usual = names_no_panel},
     .beside = {.key = "kind",
                .words = {"side_by_side", "anaglyph", "interleaved", "2d_plus_depth"},
                .is_refused = false},
     .wording = {.written = Written::where_used}},
});
static_assert(are_sound<View>(settings_of<View>));

}  // namespace seamline::inline stimuli
