#include "renderer/commands/pictures/composite_command.h"

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "renderer/commands/pictures/asset_root_option.h"
#include "renderer/commands/pictures/mesh_options.h"
#include "renderer/commands/pictures/place_request.h"
#include "renderer/composite/composite_request.h"
#include "renderer/composite/objects_file.h"
#include "renderer/commands/pictures/place_request.h"
#include "support/files/assets.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

using Three = std::array<double, 3>;

Eigen::Vector3d as_vector(const Three& v) {
  return {v[0], v[1], v[2]};
}

/// What the command line says, before it is a request.
struct CompositeOptions {
  CompositeRequest request;
  MeshCommandOptions mesh;
  std::string projection = "auto", depth_view = "auto", depth_kind = "auto", view, jumps = "stretch",
              occlusion = "mesh", estimator = "auto", seamless, asset_root;
  std::string object, objects, materials = "gltf", environment_map;
  Three position_m{0, 0, -3}, rotation_deg{0, 0, 0}, look_at_m{0, 0, -1}, to_sun{0, 1, 0},
      irradiance{0, 0, 0}, environment{0, 0, 0};
  std::array<double, 6> lamp{0, 0, 0, 0, 0, 0};
  bool rest = false;
  double scale = 1, height_m = 1, fov_deg = 60, sun_radius_deg = 0, object_albedo = 0.5, metallic = 0,
         roughness = 0, rotation_of_map_deg = 0, jump_ratio = 1.1, metres_per_step = 1, error = 0.0039;
  int depth_width_px = 0;
  bool keeps_sun = false;
};

/// Which options were given: some mean something only beside others, and what would be ignored is refused.
class Given {
 public:
  explicit Given(const CLI::App& command) : command_(command) {}

  [[nodiscard]] bool operator()(const char* name) const { return command_.get_option(name)->count() > 0; }
  void refuse(std::initializer_list<const char*> names, bool unless, const std::string& wanted,
              const std::string& found) const {
    if (unless) return;
    for (const char* name : names)
      if ((*this)(name)) throw input_error({.field = name, .wanted = wanted, .found = found});
  }

 private:
  const CLI::App& command_;
};

void check_given(const CompositeOptions& options, const Given& given) {
  const bool camera = given("--camera");
  const char* file = "the TOML file of --objects, which says it of each object";
  given.refuse({"--position", "--rotation", "--scale", "--height", "--materials", "--object-albedo",
                "--metallic", "--roughness", "--rest"},
               !given("--objects"), file, "--objects " + options.objects);
  if (given("--object") == given("--objects"))
    throw input_error({.field = "--object",
                       .wanted = "one of --object FILE and --objects FILE.toml",
                       .found = given("--object") ? "both" : "neither"});
  given.refuse({"--scale"}, !given("--height"), "--scale or --height, not both", "both");
  given.refuse({"--metallic", "--roughness"}, options.materials == "gltf", "--materials gltf beside it",
               "--materials diffuse");
  given.refuse({"--jumps"}, camera || options.depth_view != "panorama", "depth of the photograph's own view",
               "a panorama");
  given.refuse({"--fov"}, !camera, "no --camera beside it, whose file has the lens",
               options.request.depth.camera);
  given.refuse({"--yaw", "--depth-view"}, !camera, "a panoramic depth map",
               "depth of the camera " + options.request.depth.camera);
  given.refuse({"--jump-ratio"}, options.jumps == "cut", "--jumps cut beside it", "--jumps " + options.jumps);
  given.refuse({"--depth-buffer-bits", "--depth-buffer-near", "--depth-buffer-far"},
               options.occlusion == "depth_buffer", "--occlusion depth_buffer beside it",
               "--occlusion " + options.occlusion);
  given.refuse({"--occlusion"}, !given("--occlusion-mask"),
               "no --occlusion-mask beside it, which answers the same", "both");
  given.refuse({"--look-at", "--fov"}, !given("--scene"), "no --scene beside it, whose camera it is",
               "--scene " + options.request.scene_file);
  given.refuse({"--spp"}, !given("--error"), "--spp or --error, not both", "both");
  given.refuse({"--depth-width"}, !given("--seamless"), "--depth-width or --seamless, not both", "both");
  given.refuse({"--condition"}, !options.seamless.empty() && options.seamless != "paper",
               "--seamless thresholds.json beside it", "none");
  given.refuse({"--pixels-per-degree"}, given("--report"), "--report beside it, for its FLIP", "none");
}

PlacedModel model_of(const CompositeOptions& options, const Given& given) {
  PlacedModel model;
  model.file = options.object;
  model.path = resolve_named_file(options.object, "--object");
  model.position_m = as_vector(options.position_m);
  model.rotation_deg = as_vector(options.rotation_deg);
  model.scale = options.scale;
  if (given("--height")) {
    model.height_m = options.height_m;
    model.stands = true;
  }
  model.rest = options.rest;
  model.materials = options.materials == "gltf" ? MaterialModel::gltf : MaterialModel::diffuse;
  model.albedo = options.object_albedo;
  if (given("--metallic")) model.metallic = options.metallic;
  if (given("--roughness")) model.roughness = options.roughness;
  return model;
}

LampDefinition lamp_of(const std::array<double, 6>& values) {
  LampDefinition lamp;
  lamp.position_m = {values[0], values[1], values[2]};
  lamp.intensity_w_sr = {values[3], values[4], values[5]};
  for (const double intensity : lamp.intensity_w_sr)
    if (intensity < 0)
      throw input_error({.field = "--lamp",
                         .wanted = "an intensity of at least 0 W/sr",
                         .found = std::to_string(intensity)});
  return lamp;
}

/// Light of the options, in place of that of a scene file.
void take_light(const CompositeOptions& options, const Given& given, PhotoLightRequest& light) {
  SceneDefinition& scene = light.given;
  scene.environment_radiance = options.environment;
  if (given("--to-sun")) {
    if (!(as_vector(options.to_sun).norm() > 0))
      throw input_error({.field = "--to-sun", .wanted = "a direction that is not zero", .found = "0 0 0"});
    if (options.irradiance == Three{0, 0, 0})
      throw input_error({.field = "--sun-irradiance", .wanted = "a sun that shines", .found = "0 0 0"});
    scene.suns = {
        SunDefinition{as_vector(options.to_sun).normalized(), options.irradiance, options.sun_radius_deg}};
  }
  if (given("--environment-map"))
    scene.environment = EnvironmentDefinition{
        .file = options.environment_map,
        .path = resolve_named_file(options.environment_map, "--environment-map", BuiltinKind::environment),
        .rotation_deg = options.rotation_of_map_deg};
  if (given("--lamp")) scene.lamps = {lamp_of(options.lamp)};
  light.has_given =
      given("--to-sun") || given("--environment") || given("--environment-map") || given("--lamp");
  light.splits_sun = !options.keeps_sun;
}

void take_objects(const CompositeOptions& options, const Given& given, CompositeRequest& request) {
  take_light(options, given, request.light);
  if (given("--objects") && options.objects.empty()) return;  // place: a file that is not there yet
  if (!given("--objects")) {
    request.objects = {model_of(options, given)};
    return;
  }
  const ObjectsFile file = read_objects_file(options.objects, options.asset_root);
  request.objects = file.objects;
  if (!file.has_light) return;
  if (request.light.has_given)
    throw input_error({.file = options.objects,
                       .field = "light",
                       .wanted = "light in the file or in the options, not in both",
                       .found = "both"});
  request.light.given = file.light;
  request.light.has_given = true;
}

CompositeRequest request_of(const CompositeOptions& options, const Given& given) {
  check_given(options, given);
  CompositeRequest request = options.request;
  if (options.projection != "auto")
    request.projection = options.projection == "panorama" ? Projection::panorama : Projection::perspective;
  PhotoDepthRequest& depth = request.depth;
  depth.file = options.mesh.depth;
  depth.density = density_of(options.mesh);
  depth.tolerance = options.mesh.tolerance;
  depth.yaw_texels = options.mesh.yaw_texels;
  if (options.depth_view != "auto")
    depth.view = options.depth_view == "panorama" ? DepthView::panorama : DepthView::photograph;
  if (options.depth_kind != "auto")
    depth.convention =
        options.depth_kind == "radial" ? sensors::DepthConvention::radial : sensors::DepthConvention::planar;
  if (given("--metres-per-step")) depth.metres_per_step = options.metres_per_step;
  if (options.jumps == "cut") depth.cut_ratio = options.jump_ratio;
  if (given("--view")) request.view_px = whole_pair(options.view, 'x');
  if (given("--look-at")) request.look_at_m = as_vector(options.look_at_m);
  if (given("--fov")) request.fov_deg = options.fov_deg;
  request.occlusion = options.occlusion == "none"         ? PhotoOcclusion::none
                      : options.occlusion == "depth_test" ? PhotoOcclusion::depth_test
                      : options.occlusion == "mesh"       ? PhotoOcclusion::mesh
                                                          : PhotoOcclusion::depth_buffer;
  if (given("--depth-width")) {
    if (options.depth_width_px % 2 != 0)
      throw input_error({.field = "--depth-width",
                         .wanted = "an even width",
                         .found = std::to_string(options.depth_width_px)});
    request.depth_width_px = options.depth_width_px;
  }
  request.seamless = given("--seamless");
  if (request.seamless && !options.seamless.empty() && options.seamless != "paper")
    request.thresholds = options.seamless;
  if (options.estimator != "auto")
    request.estimator = options.estimator == "fast" ? Estimator::fast : Estimator::path;
  if (given("--error")) request.error = options.error;
  take_objects(options, given, request);
  return request;
}

void run_composite(const CompositeOptions& options, const CLI::App& command) {
  const Given given(command);
  need_extension(options.request.out, {".png", ".exr"});
  if (given("--layers")) need_extension(options.request.layers, {".exr"}, "--layers");
  if (given("--local-scene")) need_extension(options.request.local_scene, {".png"}, "--local-scene");
  if (given("--report")) need_extension(options.request.report, {".html"}, "--report");
  make_composite(request_of(options, given));
}

void add_photograph_options(CLI::App& command, CompositeOptions& options) {
  CompositeRequest& request = options.request;
  command
      .add_option(
          "--background", request.photograph,
          "photograph: EXR or HDR of linear radiance, or PNG or JPEG, taken as sRGB codes; turned as its "
          "EXIF orientation says")
      ->required();
  command
      .add_option("--projection", options.projection,
                  "of the photograph: panorama (equirectangular, +Y up, its middle column towards -Z), "
                  "perspective, or "
                  "auto: a picture twice as wide as high is a panorama")
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
          "depth around the camera: .exr of metres, or .png and .pgm of 16 bits with --metres-per-step; an "
          "equirectangular map, or of the photograph's view. Maps below 2048 texels a row are interpolated "
          "linearly onto a sphere of 2048 vertices (the paper's section 3.2)")
      ->required();
  command
      .add_option("--depth-view", options.depth_view,
                  "of the depth map: panorama, photograph (the photograph's own view), or auto: twice as "
                  "wide as high "
                  "is a panorama")
      ->check(CLI::IsMember({"auto", "panorama", "photograph"}))
      ->capture_default_str();
  command
      .add_option(
          "--depth-kind", options.depth_kind,
          "radial: lengths of rays; planar: distances along the camera's axis; auto: radial of panoramas, "
          "planar of photographs' views")
      ->check(CLI::IsMember({"auto", "radial", "planar"}))
      ->capture_default_str();
  add_number(
      command, "--metres-per-step", options.metres_per_step, {1e-9, 1e9, "m"},
      "what 1 in the depth map is worth: 0.001 for millimetres (default: 1 of .exr; of whole numbers it must "
      "be given)");
  add_mesh_options(command, options.mesh);
  add_yaw_option(command, options.mesh);
  command
      .add_option("--jumps", options.jumps,
                  "where depth of the photograph's view jumps: stretch a sheet, or cut a gap")
      ->check(CLI::IsMember({"stretch", "cut"}))
      ->capture_default_str();
  add_number(command, "--jump-ratio", options.jump_ratio, {1.0001, 1000},
             "of depths between which --jumps cut cuts")
      ->capture_default_str();
  add_number(
      command, "--depth-width", options.depth_width_px, {2, 16384, "px"},
      "see the local scene through a panorama so wide, captured from the whole depth map (default: the whole "
      "map)");
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
  command.add_option("--objects", options.objects,
                     "several objects, and perhaps their light: a TOML file (documentation/composite.md)");
  add_number(
      command, "--position", options.position_m, any_place_m,
      "where the object's origin is (with --height: the middle of its lowest level), from the panorama's "
      "centre or the camera: right, up, back; with --scene in that file's world")
      ->capture_default_str();
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
  command
      .add_option("--materials", options.materials,
                  "of the object: gltf (metals, gloss, textures) or diffuse (base colours alone)")
      ->check(CLI::IsMember({"gltf", "diffuse"}))
      ->capture_default_str();
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
  CLI::Option* to_sun = add_number(command, "--to-sun", options.to_sun, {-1e9, 1e9},
                                   "direction towards a sun, in the world's axes");
  CLI::Option* irradiance =
      add_number(command, "--sun-irradiance", options.irradiance, {0, limits::strongest_light, "W/m2"},
                 "on a plane facing that sun, R G B, in the photograph's own unit of light");
  to_sun->needs(irradiance);
  irradiance->needs(to_sun);
  add_number(command, "--sun-radius", options.sun_radius_deg, {0, 45, "degrees"},
             "angular radius of that sun")
      ->capture_default_str()
      ->needs(to_sun);
  add_number(
      command, "--lamp", options.lamp, {-limits::strongest_light, limits::strongest_light},
      "a lamp without size: its place X Y Z in metres, as --position, and R G B in W/sr; several go into "
      "the file of --objects");
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
  command.add_flag("--keep-sun", options.keeps_sun,
                   "leave a panorama's sun in it (default: it is split off, and printed)");
  add_number(command, "--albedo", request.albedo, {0, 1}, "of the local scene's surfaces, which are diffuse")
      ->capture_default_str();
  add_number(command, "--bounces", request.bounces, {0, 1024}, "further scatterings after the first")
      ->capture_default_str();
}

void add_answer_options(CLI::App& command, CompositeOptions& options) {
  CompositeRequest& request = options.request;
  command
      .add_option(
          "--occlusion", options.occlusion,
          "who is in front: the mesh, a depth test in metres a pixel (linear between the map's texels), the "
          "same in a depth buffer, or always the object (none)")
      ->check(CLI::IsMember({"mesh", "depth_test", "depth_buffer", "none"}))
      ->capture_default_str();
  add_number(command, "--depth-buffer-bits", request.buffer.bits, {8, 32, "bits"},
             "of --occlusion depth_buffer")
      ->capture_default_str();
  add_number(command, "--depth-buffer-near", request.buffer.nearest_m, {1e-6, 1e9, "m"}, "its nearer plane")
      ->capture_default_str();
  add_number(command, "--depth-buffer-far", request.buffer.farthest_m, {1e-6, 1e9, "m"}, "its farther plane")
      ->capture_default_str();
  command.add_option(
      "--occlusion-mask", request.occlusion_mask,
      "who is in front, given: .png or .exr, white where something real stands before all objects; by "
      "direction (twice as wide as high) or of the photograph's shape, in any resolution");
  command.add_option("--shadow-matte", request.shadow_matte,
                     "where the sun does not reach real surfaces, given: white in shadow; likewise");
}

void add_sampling_options(CLI::App& command, CompositeOptions& options) {
  CompositeRequest& request = options.request;
  command
      .add_option("--estimator", options.estimator,
                  "fast (filtered bounce light), path (every path traced), or auto: fast where it can")
      ->check(CLI::IsMember({"auto", "fast", "path"}))
      ->capture_default_str();
  add_number(command, "--error", options.error, {1e-5, 1},
             "sample until the picture's estimated error is below this, in display units (one 8-bit step is "
             "0.0039)");
  add_number(command, "--spp", request.spp, {1, 65536}, "samples a pixel, without --error")
      ->capture_default_str();
  add_number(command, "--seed", request.seed, {0, 2147483647}, "seed of the samples")->capture_default_str();
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
  command.add_option("--report", request.report,
                     "a page (.html): depth used, triangles, seconds, and FLIP against full depth as a map");
  add_number(command, "--pixels-per-degree", request.pixels_per_degree, {1, 1000},
             "at which FLIP sees the picture")
      ->capture_default_str();
}

/// What `place` leaves to `composite`, whose command line is the same but for the first word.
constexpr std::array left_to_composite = {
    "--object",         "--out",          "--layers",    "--report",      "--local-scene",
    "--error",          "--spp",          "--estimator", "--depth-width", "--seamless",
    "--occlusion-mask", "--shadow-matte", "--occlusion", "--seed",        "--condition"};

void run_place(const CompositeOptions& options, const std::vector<std::string>& added,
               const CLI::App& command, PlaceInWindow in_window) {
  if (in_window == nullptr)
    throw input_error(
        {.field = "place",
         .wanted = "a build with a window (libimgui-dev, libglfw3-dev, libgl-dev, libfreetype-dev)",
         .found = "one without"});
  const Given given(command);
  for (const char* name : left_to_composite)
    if (given(name))
      throw input_error({.field = name,
                         .wanted = "options of photograph, depth, camera and light",
                         .found = "one of composite"});
  PlaceRequest request{
      .photo = {}, .objects_file = options.objects, .asset_root = options.asset_root, .added = added};
  CompositeOptions photo = options;
  const bool is_there = std::filesystem::exists(options.objects);
  if (!is_there) photo.objects.clear();
  request.photo = request_of(photo, given);
  in_window(request);
}

}  // namespace

void add_place_command(CLI::App& app, PlaceInWindow in_window) {
  auto options = std::make_shared<CompositeOptions>();
  auto added = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand(
      "place", "put objects on the real surfaces of a photograph, in a window, for composite --objects");
  add_photograph_options(*command, *options);
  add_depth_options(*command, *options);
  add_object_options(*command, *options);
  add_light_options(*command, *options);
  add_answer_options(*command, *options);
  add_sampling_options(*command, *options);
  add_output_options(*command, *options);
  for (const char* name : left_to_composite) command->get_option(name)->group("")->required(false);
  command->get_option("--objects")
      ->required()
      ->description(
          "the file that is changed (TOML, documentation/composite.md); it need not be there beside --add");
  command->add_option("--add", *added,
                      "an object to put there besides: .glb, .gltf or builtin:NAME; may be given again");
  command->callback(
      [options, added, command, in_window] { run_place(*options, *added, *command, in_window); });
}

void add_composite_command(CLI::App& app) {
  auto options = std::make_shared<CompositeOptions>();
  CLI::App* command =
      app.add_subcommand("composite", "put objects into a photograph or a panorama, through its depth");
  add_photograph_options(*command, *options);
  add_depth_options(*command, *options);
  add_object_options(*command, *options);
  add_light_options(*command, *options);
  add_answer_options(*command, *options);
  add_sampling_options(*command, *options);
  add_output_options(*command, *options);
  command->callback([options, command] { run_composite(*options, *command); });
}

}  // namespace seamline::renderer
