#pragma once
#include "stimuli/settings/estimate_settings.h"
#include "stimuli/settings/noise_settings.h"
#include "stimuli/settings/pipeline_settings.h"
#include "stimuli/settings/repair_settings.h"

namespace seamline::inline stimuli {

template <>
inline constexpr std::array<std::string_view, 4> words_of<DepthSource> = {"panorama", "pinhole", "file",
                                                                          "stereo"};
template <>
inline constexpr std::array<std::string_view, 8> words_of<Reduction> = {
    "sample", "minimum", "maximum", "median", "edge_aware", "boxes", "jumps", "budgeted"};
template <>
inline constexpr auto words_of<sensors::DepthConvention> = sensors::words_of_conventions;
template <>
inline constexpr std::array<std::string_view, 2> words_of<RepairGuide> = {"own_light", "photograph"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<Registration> = {"none", "points", "mesh"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<Jumps> = {"stretch", "cut", "layer"};

/// A word that is another than before begins with a buffer of its own.
void choose_occlusion(DepthChain& chain, std::size_t place);
[[nodiscard]] std::string buffer_text(const DepthChain& chain);

[[nodiscard]] std::string fault_of_far_plane(const sensors::DepthBuffer& buffer);
[[nodiscard]] std::string fault_of_jump_ratio(const DepthChain& chain);
[[nodiscard]] std::string fault_of_disparities(const StereoSource& stereo);
[[nodiscard]] std::string fault_of_block(const StereoSource& stereo);

template <>
inline constexpr auto settings_of<sensors::LensDistortion> = std::to_array<Setting<sensors::LensDistortion>>({
    {.key = "", .slot = &sensors::LensDistortion::k1, .wording = {.before = " lens "}},
    {.key = "", .slot = &sensors::LensDistortion::k2, .wording = {.before = " "}},
    {.key = "", .slot = &sensors::LensDistortion::p1, .wording = {.before = " "}},
    {.key = "", .slot = &sensors::LensDistortion::p2, .wording = {.before = " "}},
    {.key = "", .slot = &sensors::LensDistortion::k3, .wording = {.before = " "}},
});

/// Of a pinhole or a file. What has no key follows from `size_px` and the ways to say how wide it looks.
template <>
inline constexpr auto settings_of<sensors::PinholeCamera> = std::to_array<Setting<sensors::PinholeCamera>>({
    {.key = "", .slot = &sensors::PinholeCamera::width_px, .wording = {.written = Written::always}},
    {.key = "", .slot = &sensors::PinholeCamera::height_px, .wording = {.before = " x "}},
    {.key = "size_px",
     .slot = Described{"[width, height]"},
     .range = {2, 8192, "px, width even"},
     .meaning = "Size of the depth map. A preset of another size keeps its field of view.",
     .usual = "the preset's"},
    {.key = "field_of_view_deg",
     .slot = Described{"number"},
     .range = {1, 170, "degrees"},
     .meaning = "Horizontal field of view. Give one of this, `texels_per_degree` and `fx`.",
     .level = Quantity::depth_field_of_view_deg,
     .usual = "the preset's"},
    {.key = "texels_per_degree",
     .slot = Described{"number"},
     .range = {1e-3, 1e4, "texels per degree"},
     .meaning = "Resolution on the axis.",
     .level = Quantity::texels_per_degree,
     .usual = "the preset's"},
    {.key = "fx",
     .slot = &sensors::PinholeCamera::fx_px,
     .range = {1e-3, 1e6, "pixels"},
     .meaning = "Focal length in pixels.",
     .wording = {.before = " fx "},
     .is_read_apart = true,
     .usual = "the preset's"},
    {.key = "fy",
     .slot = &sensors::PinholeCamera::fy_px,
     .range = {1e-3, 1e6, "pixels"},
     .meaning = "Vertical focal length.",
     .wording = {.before = " fy "},
     .is_read_apart = true,
     .usual = "`fx`"},
    {.key = "cx",
     .slot = &sensors::PinholeCamera::cx_px,
     .range = {-1e6, 1e6, "pixels"},
     .meaning = "Principal point. The centre of the first pixel is (0.5, 0.5).",
     .wording = {.before = " cx "},
     .usual = "the middle"},
    {.key = "cy",
     .slot = &sensors::PinholeCamera::cy_px,
     .range = {-1e6, 1e6, "pixels"},
     .meaning = "The same, downwards.",
     .wording = {.before = " cy "},
     .usual = "the middle"},
    {.key = "skew",
     .slot = &sensors::PinholeCamera::skew_px,
     .range = {-1e6, 1e6, "pixels"},
     .meaning = "Skew.",
     .wording = {.before = " skew ", .written = Written::where_unusual}},
    {.key = "distortion",
     .slot = Described{"five numbers"},
     .range = {-1e3, 1e3},
     .meaning = "[k1, k2, p1, p2, k3] (Brown).",
     .usual = "none"},
    {.key = "",
     .slot = part<&sensors::PinholeCamera::distortion>(),
     .wording = {.written = Written::where_unusual}},
});

template <>
inline constexpr auto settings_of<sensors::SensorRange> = std::to_array<Setting<sensors::SensorRange>>({
    {.key = "", .slot = &sensors::SensorRange::nearest_m, .wording = {.before = " range "}},
    {.key = "", .slot = &sensors::SensorRange::farthest_m, .wording = {.before = " "}},
    {.key = "range_m",
     .slot = Described{"[nearest, farthest]"},
     .range = {0, 1e9, "m"},
     .meaning = "What lies outside is a hole.",
     .usual = "the preset's"},
});

/// `depth.pose`.
template <>
inline constexpr auto settings_of<SensorPose> = std::to_array<Setting<SensorPose>>({
    {.key = "position_m",
     .slot = &SensorPose::position_m,
     .range = {-1e3, 1e3, "m"},
     .meaning = "In the photograph's camera: x right, y down, z forward.",
     .wording = {.before = " pose "}},
    {.key = "rotation_deg",
     .slot = &SensorPose::rotation_deg,
     .range = {-360, 360, "degrees"},
     .meaning = "Pitch, yaw and roll, as of objects.",
     .wording = {.before = " "}},
});

template <>
inline constexpr auto settings_of<PanoramaSource> = std::to_array<Setting<PanoramaSource>>({
    {.key = "reduction",
     .slot = choice<&PanoramaSource::reduction>(),
     .meaning =
         "Of a panorama: what a texel takes from a finer map. `\"edge_aware\"` is the median of the "
         "larger side of a jump; `\"boxes\"` are [planes and "
         "boxes](../papers/paper_002.md#planes-and-boxes-in-place-of-a-map). `\"jumps\"` and "
         "`\"budgeted\"` [spend as many samples](../how-to/depth_budget.md) as the map has where depth "
         "jumps, or where wrong depth would show.",
     .wording = {.before = "panorama "}},
    {.key = "reduction_factor",
     .slot = &PanoramaSource::reduction_factor,
     .range = {2, 64},
     .meaning = "The finer map is so many times as wide.",
     .wording = {.before = " "},
     .is_read_apart = true,
     .usual = "4"},
    {.key = "", .slot = &PanoramaSource::lowest_elevation_deg, .wording = {.before = " elevation "}},
    {.key = "", .slot = &PanoramaSource::highest_elevation_deg, .wording = {.before = " "}},
    {.key = "", .slot = part<&PanoramaSource::range>(), .wording = {.written = Written::always}},
    {.key = "", .slot = optional_part<&PanoramaSource::noise>(), .wording = {.written = Written::always}},
    {.key = "",
     .slot = optional_part<&PanoramaSource::file>(),
     .wording = {.written = Written::where_unusual}},
});

template <>
inline constexpr auto settings_of<PinholeSource> = std::to_array<Setting<PinholeSource>>({
    {.key = "", .slot = part<&PinholeSource::camera>(), .wording = {.before = "pinhole "}},
    {.key = "convention",
     .slot = choice<&PinholeSource::convention>(),
     .meaning = "Distance from the camera's plane, or length of the ray: of a source without noise or with "
                "the generic model. Required of a file.",
     .wording = {.before = " "},
     .is_read_apart = true},
    {.key = "", .slot = part<&PinholeSource::range>(), .wording = {.written = Written::always}},
    {.key = "", .slot = part<&PinholeSource::pose>(), .wording = {.written = Written::always}},
    {.key = "pose",
     .slot = Described{"table"},
     .meaning = "Where the sensor is: `position_m` and `rotation_deg`, as of objects.",
     .usual = "the preset's"},
    {.key = "projector_m",
     .slot = &PinholeSource::projector_m,
     .range = {-1e3, 1e3, "m"},
     .meaning = "Of structured light: its projector in the sensor's frame. Its shadow has no depth.",
     .wording = {.before = " projector ", .written = Written::where_unusual},
     .is_read_apart = true,
     .usual = "the preset's"},
    {.key = "", .slot = optional_part<&PinholeSource::noise>(), .wording = {.written = Written::always}},
});

template <>
inline constexpr auto settings_of<FileSource> = std::to_array<Setting<FileSource>>({
    {.key = "file",
     .slot = &FileSource::file,
     .meaning = "Of a file: the depth map. `{scene}` and `{object}` in its name stand for those of a "
                "stimulus: [one file for each object's photograph](../how-to/estimated_depth.md).",
     .wording = {.before = "file "},
     .is_read_apart = true,
     .form = "EXR, PNG, PGM, TIFF, PFM, NPY",
     .usual = "required"},
    {.key = "projection",
     .slot = Described{"text"},
     .meaning =
         "Of a file: what it is a map of. A panorama is `depth_width_px` wide, radial, and has no camera.",
     .form = R"(`"pinhole"`, `"panorama"`)",
     .usual = "`\"pinhole\"`"},
    {.key = "", .slot = part<&FileSource::camera>(), .wording = {.before = " "}},
    {.key = "convention",
     .slot = choice<&FileSource::convention>(),
     .meaning = "Distance from the camera's plane, or length of the ray.",
     .wording = {.before = " "},
     .is_read_apart = true},
    {.key = "", .slot = part<&FileSource::range>(), .wording = {.written = Written::always}},
    {.key = "", .slot = part<&FileSource::pose>(), .wording = {.written = Written::always}},
    {.key = "metres_per_step",
     .slot = &FileSource::metres_per_step,
     .range = {1e-9, 1e9, "m"},
     .meaning = "Of a file: metres a step.",
     .wording = {.before = " step "},
     .usual = "required of whole numbers"},
    {.key = "packing",
     .slot = choice<&FileSource::packing>(),
     .meaning = "Of a file: `\"red_green\"` where 16 bits lie in two channels.",
     .wording = {.before = " "}},
    {.key = "",
     .slot = optional_part<&FileSource::estimate>(),
     .wording = {.written = Written::where_unusual}},
});

template <>
inline constexpr auto settings_of<StereoSource> = std::to_array<Setting<StereoSource>>({
    {.key = "", .slot = part<&StereoSource::camera>(), .wording = {.before = "stereo "}},
    {.key = "", .slot = part<&StereoSource::range>(), .wording = {.written = Written::always}},
    {.key = "", .slot = part<&StereoSource::pose>(), .wording = {.written = Written::always}},
    {.key = "baseline_m",
     .slot = &StereoSource::baseline_m,
     .range = {1e-4, 10, "m"},
     .meaning = "Of stereo: from the left camera, whose depth it is, to the right one.",
     .wording = {.before = " baseline "},
     .is_read_apart = true,
     .usual = "required"},
    {.key = "disparities_px",
     .slot = &StereoSource::disparities_px,
     .range = {16, 1024, "px, a multiple of 16"},
     .meaning = "Of stereo: disparities from 0 that are searched. What is nearer than "
                "`fx baseline_m / disparities_px` is not found.",
     .wording = {.before = " disparities "},
     .fault = fault_of_disparities},
    {.key = "block_px",
     .slot = &StereoSource::block_px,
     .range = {1, 21, "px, odd"},
     .meaning = "Of stereo: side of the blocks that are compared.",
     .wording = {.before = " block "},
     .fault = fault_of_block},
    {.key = "stereo_samples",
     .slot = &StereoSource::samples_per_pixel,
     .range = {1, 65536},
     .meaning = "Of stereo: samples a pixel of its two pictures, which have noise as a camera's do.",
     .wording = {.before = " samples "}},
    {.key = "estimate_share",
     .slot = &StereoSource::share,
     .range = {0, 1},
     .meaning = "As of a file.",
     .wording = {.before = " share ", .written = Written::where_unusual},
     .level = Quantity::estimate_share},
});

/// Of `occlusion = "depth_buffer"`.
template <>
inline constexpr auto settings_of<sensors::DepthBuffer> = std::to_array<Setting<sensors::DepthBuffer>>({
    {.key = "buffer_bits",
     .slot = &sensors::DepthBuffer::bits,
     .range = {8, 32, "bits"},
     .meaning = "Of `\"depth_buffer\"`: its steps.",
     .wording = {.before = " "}},
    {.key = "buffer_near_m",
     .slot = &sensors::DepthBuffer::nearest_m,
     .range = {1e-6, 1e9, "m"},
     .meaning = "Of `\"depth_buffer\"`: its nearer plane.",
     .wording = {.before = " "}},
    {.key = "buffer_far_m",
     .slot = &sensors::DepthBuffer::farthest_m,
     .range = {1e-6, 1e9, "m"},
     .meaning = "Of `\"depth_buffer\"`: its farther plane.",
     .wording = {.before = " "},
     .fault = fault_of_far_plane},
});

/// `[depth]`, beside its sources.
template <>
inline constexpr auto settings_of<DepthChain> = std::to_array<Setting<DepthChain>>({
    {.key = "repair",
     .slot = choice<&DepthChain::repair>(),
     .meaning = "What fills or smooths depth. A table has `method` and the parameters below.",
     .wording = {.before = "repair "},
     .is_read_apart = true},
    {.key = "registration",
     .slot = choice<&DepthChain::registration>(),
     .meaning = "Brings depth into the photograph's camera. Without it the mesh stands where the sensor is.",
     .wording = {.before = "; registration "}},
    {.key = "border_extrusion_px",
     .slot = &DepthChain::border_extrusion_px,
     .range = {0, 64, "px"},
     .meaning = "How far the outermost depths are extended.",
     .beside = {"registration", {"mesh"}},
     .wording = {.before = " "}},
    {.key = "jumps",
     .slot = choice<&DepthChain::jumps>(),
     .meaning =
         "Between neighbours that differ by more than `jump_ratio`: a sheet, nothing, or nothing and a "
         "second surface behind the near one.",
     .wording = {.before = "; jumps "}},
    {.key = "jump_ratio",
     .slot = &DepthChain::jump_ratio,
     .range = {1, 1e6},
     .meaning = "Above 1.",
     .beside = {"jumps", {"cut", "layer"}, "jumps = \"cut\" or \"layer\": sheets have no ratio"},
     .wording = {.before = " "},
     .fault = fault_of_jump_ratio},
    {.key = "layer_px",
     .slot = &DepthChain::layer_px,
     .range = {1, 1024, "px"},
     .meaning = "How far behind an edge the second surface reaches.",
     .beside = {"jumps", {"layer"}},
     .wording = {.before = " "}},
    {.key = "calibration_error_deg",
     .slot = &DepthChain::calibration_error_deg,
     .range = {0, 45, "degrees"},
     .meaning = "The sensor's pose is wrong by this rotation, about an axis that `seed` draws.",
     .wording = {.before = "; calibration error "},
     .level = Quantity::calibration_error_deg},
    {.key = "calibration_error_m",
     .slot = &DepthChain::calibration_error_m,
     .range = {0, 10, "m"},
     .meaning = "The sensor's pose is wrong by this displacement, in a direction that `seed` draws.",
     .wording = {.before = " "},
     .level = Quantity::calibration_error_m},
    {.key = "delay_ms",
     .slot = &DepthChain::delay_ms,
     .range = {0, 10000, "ms"},
     .meaning =
         "Age of the depth. In a study with [`[clip]`](#clip-things-that-move), also of a panorama: depth "
         "of what stood there then.",
     .wording = {.before = "; delay "},
     .level = Quantity::depth_delay_ms},
    {.key = "velocity_m_s",
     .slot = &DepthChain::velocity_m_s,
     .range = {-1e3, 1e3, "m/s"},
     .meaning = "Motion of the rig while the depth grows old.",
     .wording = {.before = " "}},
    {.key = "noise_sigmas",
     .slot = &DepthChain::noise_sigmas,
     .range = {0, 100},
     .meaning = "The adaptive mesh may err by so many standard deviations of the noise where that is more "
                "than `mesh_tolerance`.",
     .wording = {.before = "; sigmas "}},
    {.key = "", .slot = &DepthChain::seed, .wording = {.before = " seed "}},
    {.key = "repair_guide",
     .slot = choice<&DepthChain::guide>(),
     .meaning = "Guide image of the joint bilateral filter. `own_light`: albedo times cosine, seen from the "
                "sensor. `photograph`: the background, in the sensor's pixels.",
     .beside = {"repair", {"joint_bilateral"}},
     .wording = {.before = "; guide ", .written = Written::where_unusual}},
    {.key = "repair_after",
     .slot = &DepthChain::repair_after,
     .meaning = "Repairs the registered picture and not the sensor's.",
     .wording = {.before = "; repair after registration", .written = Written::where_unusual, .yes = ""}},
    {.key = "occlusion",
     .slot =
         Choice<DepthChain>{
             .words = words_among<Occlusion::mesh, Occlusion::depth_test, Occlusion::depth_buffer>,
             .place = [](const DepthChain& chain) { return place_of(chain.occlusion); },
             .choose = choose_occlusion,
             .parameters = buffer_text},
     .meaning = "Who is in front: the mesh, or a test a pixel of depth against the object's. A sensor beside "
                "the photograph needs a registration for a test.",
     .wording = {.before = "; occlusion ", .written = Written::where_unusual}},
});
static_assert(are_sound<DepthChain>(settings_of<DepthChain>));
static_assert(are_sound<PinholeSource>(settings_of<PinholeSource>));
static_assert(are_sound<StereoSource>(settings_of<StereoSource>));

}  // namespace seamline::inline stimuli
