#pragma once
#include "stimuli/definition/methods/pipeline.h"
#include "stimuli/settings/settings_text.h"

namespace seamline::inline stimuli {

template <>
inline constexpr std::array<std::string_view, 7> words_of<Occlusion> = {
    "mesh", "depth_test", "depth_buffer", "ghosts", "mask", "edges", "none"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<PipelineShadows> = {"traced", "shadow_map",
                                                                              "occlusion_field"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<ShadowFilter> = {"none", "pcf", "pcss"};
template <>
inline constexpr std::array<std::string_view, 4> words_of<PipelineNormals> = {
    "mesh", "truth", "cross_products", "triangle_mean"};
template <>
inline constexpr std::array<std::string_view, 2> words_of<PipelineLights> = {"as_given", "median_cut"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<PipelineCompositing> = {"ratio", "additive",
                                                                                  "dark_layer"};

/// A count that median cut, which halves, can reach.
[[nodiscard]] std::string fault_of_light_count(const Pipeline& pipeline);

/// `[pipeline]`.
template <>
inline constexpr auto settings_of<Pipeline> = std::to_array<Setting<Pipeline>>({
    {.key = "occlusion",
     .slot = one_of<&Pipeline::occlusion, Occlusion::mesh, Occlusion::depth_test, Occlusion::ghosts>(),
     .meaning = "Rays; a test a pixel against measured depth; the mesh drawn first into a depth buffer.",
     .wording = {.before = ", occlusion ", .written = Written::where_unusual}},
    {.key = "shadows",
     .slot = choice<&Pipeline::shadows>(),
     .meaning = "Rays; pictures of depth from each sun and lamp; spherical harmonics around the object.",
     .wording = {.before = ", shadows ", .written = Written::where_unusual}},
    {.key = "shadow_filter",
     .slot = choice<&Pipeline::shadow_filter>(),
     .meaning = "One texel; 3 x 3 texels; soft shadows.",
     .beside = {"shadows", {"shadow_map"}},
     .wording = {.before = " ", .written = Written::where_used}},
    {.key = "shadow_map_px",
     .slot = &Pipeline::shadow_map_px,
     .range = {8, 8192, "px"},
     .meaning = "A side of the map.",
     .beside = {"shadows", {"shadow_map"}},
     .wording = {.before = " ", .after = " px", .written = Written::where_used},
     .level = Quantity::shadow_map_px},
    {.key = "shadow_bias_texels",
     .slot = &Pipeline::shadow_bias_texels,
     .range = {0, 100, "texels"},
     .meaning = "Light passes what is nearer by less than this.",
     .beside = {"shadows", {"shadow_map"}},
     .wording = {.before = " bias ", .written = Written::where_used},
     .level = Quantity::shadow_bias_texels},
    {.key = "field_bands",
     .slot = &Pipeline::field_bands,
     .range = {1, 8, "bands"},
     .meaning = "Of the spherical harmonics.",
     .beside = {"shadows", {"occlusion_field"}},
     .wording = {.before = " ", .after = " bands", .written = Written::where_used},
     .level = Quantity::field_bands},
    {.key = "field_shells",
     .slot = &Pipeline::field_shells,
     .range = {1, 64, "shells"},
     .meaning = "Around the object.",
     .beside = {"shadows", {"occlusion_field"}},
     .wording = {.before = " ", .after = " shells", .written = Written::where_used},
     .level = Quantity::field_shells},
    {.key = "normals",
     .slot = choice<&Pipeline::normals>(),
     .meaning =
         "The triangle's; the true surface's; of neighbouring depth samples; the mean about each vertex.",
     .wording = {.before = ", normals ", .written = Written::where_unusual}},
    {.key = "lights",
     .slot = choice<&Pipeline::lights>(),
     .meaning = "`\"median_cut\"`: suns in place of the environment.",
     .wording = {.before = ", lights ", .written = Written::where_unusual}},
    {.key = "light_count",
     .slot = &Pipeline::light_count,
     .range = {1, 1024, "lights"},
     .meaning = "Of median cut.",
     .beside = {"lights", {"median_cut"}},
     .wording = {.before = " ", .written = Written::where_used},
     .level = Quantity::light_count,
     .fault = fault_of_light_count,
     .form = "a power of two"},
    {.key = "compositing",
     .slot = choice<&Pipeline::compositing>(),
     .meaning = "Photograph times with over without; plus with minus without; times 1 - opacity where the "
                "object is between light and surface.",
     .wording = {.before = ", compositing ", .written = Written::where_unusual}},
    {.key = "shadow_opacity",
     .slot = &Pipeline::shadow_opacity,
     .range = {0, 1},
     .meaning = "Of the layer.",
     .beside = {"compositing", {"dark_layer"}},
     .wording = {.before = " ", .written = Written::where_used}},
});
static_assert(are_sound<Pipeline>(settings_of<Pipeline>));

}  // namespace seamline::inline stimuli
