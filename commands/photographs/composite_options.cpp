#include "commands/photographs/composite_options.h"

#include <algorithm>
#include <array>
#include <string>

#include "commands/options/setting_option.h"
#include "commands/photographs/asset_root_option.h"
#include "commands/photographs/transparent_option.h"
#include "sensors/files/depth_words.h"
#include "stimuli/settings/depth_settings.h"
#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

void add_photograph_options(CLI::App& command, CompositeOptions& options) {
  CompositeRequest& request = options.request;
  command
      .add_option(
          "--background", request.photograph,
          "photograph: EXR or HDR of linear radiance, or PNG or JPEG, taken as sRGB codes; turned as its "
          "EXIF orientation says")
      ->required();
  command.add_option(
      "--layer", request.layer,
      "of an EXR photograph with several: the one that is the picture, such as ViewLayer.Combined");
  command
      .add_option("--projection", options.projection,
                  "of the photograph: panorama (equirectangular, +Y up, its middle column towards -Z), "
                  "perspective, or auto: a picture twice as wide as high is a panorama")
      ->check(CLI::IsMember({"auto", "panorama", "perspective"}))
      ->capture_default_str();
  add_formed_text(
      command, "--view", options.view, "WxH",
      "of a panorama: make a perspective view of so many pixels, by --look-at and --fov (default: the "
      "result is the panorama)",
      [](const std::string& text) {
        const auto size = whole_pair(text, 'x');
        if (!size || size->first < 1 || size->second < 1 ||
            std::max(size->first, size->second) > limits::largest_picture_side_px)
          throw input_error({.field = "--view", .wanted = "a size such as 960x540", .found = text});
      });
  add_number(command, "--look-at", options.look_at_m, any_place_m,
             "point that the picture's middle shows, from the camera, in the world's axes; +Y is up")
      ->capture_default_str();
  add_number(command, "--fov", options.fov_deg, {1, 170, "degrees"},
             "horizontal field of view of a perspective photograph without --camera, or of --view")
      ->capture_default_str();
  add_number(
      command, "--roll", request.roll_deg, {-180, 180, "degrees"},
      "of the camera about its axis, clockwise as seen from behind it: the picture's horizon leans to the "
      "left");
  command.add_option(
      "--camera", request.depth.camera,
      "the photograph's camera (TOML file or preset, as of register): then --depth has its pixels, as "
      "the registered.exr that register writes");
  command.add_option(
      "--scene", request.scene_file,
      "glTF file whose first camera is the photograph's, and whose suns and lamps light it where no "
      "others are given; positions are then that file's");
}

void add_depth_options(CLI::App& command, CompositeOptions& options) {
  command
      .add_option(
          "--depth", options.mesh.depth,
          "depth around the camera: EXR, PFM, NPY or TIFF of metres, or whole numbers of 16 bits (PNG, PGM, TIFF, "
          "NPY) with --metres-per-step or --depth-unit; an equirectangular map, or of the photograph's view. Maps below 2048 texels a row are interpolated "
          "linearly onto a sphere of 2048 vertices (the paper's section 3.2)")
      ->required();
  command
      .add_option("--depth-view", options.depth_view,
                  "of the depth map: panorama, photograph (the photograph's own view), or auto: twice as "
                  "wide as high is a panorama")
      ->check(CLI::IsMember({"auto", "panorama", "photograph"}))
      ->capture_default_str();
  add_choice(command, "--depth-kind", options.depth_kind,
             std::array{sensors::DepthConvention::radial, sensors::DepthConvention::planar},
             "radial: lengths of rays; planar: distances along the camera's axis; auto: radial of panoramas, "
             "planar of photographs' views",
             "auto");
  add_depth_file_options(command, options.depth, options.request.depth);
  add_mesh_options(command, options.mesh);
  add_yaw_option(command, options.mesh);
  add_choice(command, "--jumps", options.jumps, std::array{sensors::Jumps::stretch, sensors::Jumps::cut},
             "where depth of the photograph's view jumps: stretch a sheet, or cut a gap");
  add_number(command, "--jump-ratio", options.jump_ratio, {1.0001, 1000},
             "of depths between which --jumps cut cuts")
      ->capture_default_str();
  command
      .add_option(
          "--repair", options.repair,
          "of depth of the photograph's own view, whose noise would be shaded: none, nearest (holes alone), "
          "median, joint_bilateral (guided by the photograph) or planes")
      ->check(CLI::IsMember(option_words<sensors::RepairMethod>()))
      ->capture_default_str();
  add_number(
      command, "--depth-width", options.depth_width_px, {2, 16384, "px"},
      "see the local scene through a panorama so wide, captured from the whole depth map (default: the whole "
      "map)");
  add_number(
      command, "--depth-samples", options.depth_samples, {512, 134217728, "samples"},
      "see the local scene through so many depth samples, spent where wrong depth would show: in shadows of "
      "and on the objects, and where things are in front of them; a panorama of width W has W x W / 2");
  command
      .add_option(
          "--seamless", options.seamless,
          "choose that width: the smallest whose thresholds all artifacts present meet; of the paper (Table "
          "1), or of the thresholds.json of a report")
      ->expected(0, 1)
      ->type_name("[FILE]");
  command.add_option("--condition", options.request.condition,
                     "of the study of --seamless, where it has several");
}

void add_object_options(CLI::App& command, CompositeOptions& options) {
  command.add_option("--object", options.object, "one object: .glb, .gltf or builtin:NAME");
  command.add_option(
      "--objects", options.objects,
      "several objects, and perhaps their light: a TOML file (documentation/how-to/composite.md)");
  add_number(
      command, "--position", options.position_m, any_place_m,
      "where the object's origin is (with --height: the middle of its lowest level), from the panorama's "
      "centre or the camera: right, up, back; with --scene in that file's world (default: it stands on the "
      "real surface that the picture's middle shows, and where is printed)");
  add_number(command, "--rotation", options.rotation_deg, {-1e9, 1e9, "degrees"},
             "pitch about X, yaw about Y, roll about Z")
      ->capture_default_str();
  add_number(command, "--scale", options.scale, {1e-9, 1e9},
             "of the object; its file's unit is then so many metres")
      ->capture_default_str();
  command.add_flag("--rest", options.rest,
                   "the object is let down from there and stands where it comes to rest on the depth map "
                   "(needs Bullet)");
  add_number(command, "--height", options.height_m, {1e-9, 1e9, "m"},
             "in place of --scale: the object is so tall, and stands on --position");
  add_choice(command, "--materials", options.materials,
             std::array{MaterialModel::gltf, MaterialModel::diffuse},
             "of the object: gltf (metals, gloss, textures) or diffuse (base colours alone)");
  add_transparent_option(command, options.transparent, "of the objects");
  add_number(command, "--object-albedo", options.object_albedo, {0, 1}, "of its meshes without a material")
      ->capture_default_str();
  add_number(command, "--metallic", options.metallic, {0, 1},
             "in place of the object's own (default: its own)");
  add_number(command, "--roughness", options.roughness, {0, 1},
             "in place of the object's own (default: its own)");
  add_asset_root_option(command, options.asset_root);
}

void add_light_options(CLI::App& command, CompositeOptions& options) {
  CompositeRequest& request = options.request;
  CLI::Option* to_sun =
      add_sun_options(command, options.sun, "direction towards a sun, in the world's axes",
                      "on a plane facing that sun, R G B, in the photograph's own unit of light");
  add_sun_radius_option(command, options.sun, to_sun);
  add_number(
      command, "--lamp", options.lamp, {-limits::strongest_light, limits::strongest_light},
      "a lamp without size: its place X Y Z in metres, as --position, and R G B in W/sr; several go into "
      "the file of --objects");
  add_number(
      command, "--virtual-lamp", options.virtual_lamp, {-limits::strongest_light, limits::strongest_light},
      "a lamp that exists only with the objects, so that real surfaces brighten: X Y Z and R G B as of "
      "--lamp; no object is needed beside it");
  add_number(
      command, "--virtual-sun", options.virtual_sun, {-limits::strongest_light, limits::strongest_light},
      "a sun that exists only with the objects: X Y Z towards it, and R G B in W/m2 on a plane facing it");
  CLI::Option* constant =
      add_number(command, "--environment", options.environment, {0, limits::strongest_light, "W/m2/sr"},
                 "radiance R G B from every direction in which the depth map has nothing (default: black)");
  CLI::Option* map = command.add_option(
      "--environment-map", options.environment_map,
      "radiance by direction: .exr, .hdr or builtin:NAME, equirectangular, +Y up, its middle column "
      "towards -Z");
  map->excludes(constant);
  add_number(command, "--environment-rotation", options.rotation_of_map_deg, {-360, 360, "degrees"},
             "of that map about +Y, counter-clockwise seen from above")
      ->capture_default_str()
      ->needs(map);
  command.add_flag(
      "--light-from-photograph", request.light.from_photograph,
      "the panorama itself is the light: every surface sends what it shows of it; the default of "
      "panoramas where no light is given; beside it a sun may be given");
  command.add_option("--light-panorama", request.light.panorama,
                     "the same by another panorama, taken at the photograph's place; scaled to be as bright");
  add_number(
      command, "--clipped-light", request.light.clipped_factor, {1, 1e6},
      "how many times as bright as shown the white light sources of a panorama of codes are (default: so that "
      "no surface has to be whiter than white, which is said)");
  command.add_flag("--keep-sun", options.keeps_sun,
                   "leave a panorama's sun in it (default: it is split off, and printed)");
  add_number(command, "--albedo", request.albedo, {0, 1}, "of the local scene's surfaces, which are diffuse")
      ->capture_default_str();
  add_number(command, "--bounces", request.bounces, {0, 1024}, "further scatterings after the first")
      ->capture_default_str();
}

void add_answer_options(CLI::App& command, CompositeOptions& options) {
  CompositeRequest& request = options.request;
  constexpr std::array occlusions = {Occlusion::mesh, Occlusion::depth_test, Occlusion::depth_buffer,
                                     Occlusion::nobody};
  add_choice(command, "--occlusion", request.occlusion, occlusions,
             "who is in front: the mesh, a depth test in metres a pixel (linear between the map's texels), "
             "the same in a depth buffer, or always the object (none)");
  add_setting(command, "--depth-buffer-bits", "buffer_bits", request.buffer, "of --occlusion depth_buffer");
  add_setting(command, "--depth-buffer-near", "buffer_near_m", request.buffer, "its nearer plane");
  add_setting(command, "--depth-buffer-far", "buffer_far_m", request.buffer, "its farther plane");
  command.add_option(
      "--occlusion-mask", request.occlusion_mask,
      "who is in front, given: .png or .exr, white where something real stands before all objects; by "
      "direction (twice as wide as high) or of the photograph's shape, in any resolution");
  command
      .add_option("--shadows", options.shadows,
                  "that objects cast onto real surfaces: cast, or none: occlusion only, where everything but "
                  "the objects keeps the photograph's bytes, whatever the depth's noise")
      ->check(CLI::IsMember({"cast", "none"}))
      ->capture_default_str();
  command.add_option("--shadow-matte", request.shadow_matte,
                     "where the sun does not reach real surfaces, given: white in shadow; likewise");
}

void add_sampling_options(CLI::App& command, CompositeOptions& options) {
  CompositeRequest& request = options.request;
  add_choice(command, "--estimator", options.estimator, std::array{Estimator::fast, Estimator::path},
             "fast (filtered bounce light), path (every path traced), or auto: fast, but path beside "
             "--occlusion none or --shadows none and where a lens leaves the picture's corners empty",
             "auto");
  add_number(command, "--error", options.error, {1e-5, 1},
             "sample until the picture's estimated error is below this, in display units (one 8-bit step is "
             "0.0039)");
  add_number(command, "--spp", request.spp, {1, 65536}, "samples a pixel, without --error")
      ->capture_default_str();
  add_number(command, "--seed", request.seed, any_seed, "seed of the samples")->capture_default_str();
  add_number(command, "--threads", request.threads, {0, 1024},
             "0: one for each core; the picture is the same")
      ->capture_default_str();
  command.add_flag("--additive", request.additive, "Debevec's additive form instead of the ratio");
}

void add_output_options(CLI::App& command, CompositeOptions& options) {
  CompositeRequest& request = options.request;
  command.add_option("--out", request.out, "picture to write: .png for the screen, .exr of linear radiance")
      ->required();
  add_number(command, "--exposure", request.exposure_ev, {-60, 60, "stops"},
             "for .png, the report, and display units of errors")
      ->capture_default_str();
  command.add_option("--layers", request.layers,
                     "all layers as one multi-part .exr: composite, photograph, ratio, with_objects, "
                     "without_objects, objects, depth_m, holes");
  command.add_option(
      "--local-scene", request.local_scene,
      "the local scene alone (.png), grey by the angle at which the camera sees its triangles");
  command.add_option("--samples-picture", request.samples_picture,
                     "where the samples of --depth-samples went: a dot each over the picture (.png)");
  command.add_option("--report", request.report,
                     "a page (.html): depth used, triangles, seconds, and FLIP against full depth as a map");
  add_number(command, "--pixels-per-degree", request.pixels_per_degree, {1, 1000},
             "at which FLIP sees the picture")
      ->capture_default_str();
}

}  // namespace

void add_composite_options(CLI::App& command, CompositeOptions& options) {
  add_photograph_options(command, options);
  add_depth_options(command, options);
  add_object_options(command, options);
  add_light_options(command, options);
  add_answer_options(command, options);
  add_sampling_options(command, options);
  add_output_options(command, options);
}

}  // namespace seamline::renderer
