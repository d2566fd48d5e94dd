#include "commands/photographs/photograph_commands.h"

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "commands/options/command_help.h"
#include "commands/options/output_files.h"
#include "commands/photographs/composite_options.h"
#include "composites/objects/objects_file.h"
#include "support/files/assets.h"
#include "support/text/error.h"
#include "support/text/shell_word.h"

namespace seamline::renderer {
namespace {

Eigen::Vector3d as_vector(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

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
  const bool in_file = given("--objects");
  const char* where =
      in_file ? "the TOML file of --objects, which says it of each object" : "--object beside it";
  given.refuse({"--position", "--rotation", "--scale", "--height", "--materials", "--object-albedo",
                "--metallic", "--roughness", "--rest"},
               given("--object") && !in_file, where, in_file ? "--objects " + options.objects : "none");
  given.refuse({"--scale"}, !given("--height"), "--scale or --height, not both", "both");
  given.refuse({"--metallic", "--roughness"}, options.materials == MaterialModel::gltf,
               "--materials gltf beside it", "--materials diffuse");
  given.refuse({"--jumps"}, camera || options.depth_view != "panorama", "depth of the photograph's own view",
               "a panorama");
  given.refuse({"--fov"}, !camera, "no --camera beside it, whose file has the lens",
               options.request.depth.camera);
  given.refuse({"--yaw", "--depth-view"}, !camera, "a panoramic depth map",
               "depth of the camera " + options.request.depth.camera);
  given.refuse({"--jump-ratio"}, options.jumps == sensors::Jumps::cut, "--jumps cut beside it",
               "--jumps " + std::string(stimuli::word(options.jumps)));
  given.refuse({"--depth-buffer-bits", "--depth-buffer-near", "--depth-buffer-far"},
               options.request.occlusion == Occlusion::depth_buffer, "--occlusion depth_buffer beside it",
               "--occlusion " + std::string(word(options.request.occlusion)));
  given.refuse({"--occlusion"}, !given("--occlusion-mask"),
               "no --occlusion-mask beside it, which answers the same", "both");
  given.refuse({"--shadow-matte", "--additive"}, options.shadows == "cast", "--shadows cast beside it",
               "--shadows none");
  given.refuse({"--look-at", "--fov"}, !given("--scene"), "no --scene beside it, whose camera it is",
               "--scene " + options.request.scene_file);
  given.refuse({"--spp"}, !given("--error"), "--spp or --error, not both", "both");
  given.refuse({"--depth-width"}, !given("--seamless"), "--depth-width or --seamless, not both", "both");
  given.refuse({"--depth-samples"}, !given("--depth-width") && !given("--seamless"),
               "--depth-samples, --depth-width or --seamless, one of them", "two");
  given.refuse({"--samples-picture"}, given("--depth-samples"), "--depth-samples beside it", "none");
  given.refuse({"--condition"}, !options.seamless.empty() && options.seamless != "paper",
               "--seamless thresholds.json beside it", "none");
  given.refuse({"--pixels-per-degree"}, given("--report"), "--report beside it, for its FLIP", "none");
}

PlacedModel model_of(const CompositeOptions& options, const Given& given) {
  PlacedModel model;
  model.file = options.object;
  model.path = resolve_named_file(options.object, "--object");
  model.position_m = as_vector(options.position_m);
  model.has_place = given("--position");
  model.rotation_deg = as_vector(options.rotation_deg);
  model.scale = options.scale;
  if (given("--height")) model.height_m = options.height_m;
  model.stands = given("--height") || !model.has_place;
  model.rest = options.rest;
  model.materials = options.materials;
  model.transparency = transparency_of(options.transparent).value_or(Transparency::refused);
  model.albedo = options.object_albedo;
  if (given("--metallic")) model.metallic = options.metallic;
  if (given("--roughness")) model.roughness = options.roughness;
  return model;
}

LampDefinition lamp_of(const std::array<double, 6>& values, const char* option) {
  LampDefinition lamp;
  lamp.position_m = {values[0], values[1], values[2]};
  lamp.intensity_w_sr = {values[3], values[4], values[5]};
  for (const double intensity : lamp.intensity_w_sr)
    if (intensity < 0)
      throw input_error(
          {.field = option, .wanted = "an intensity of at least 0 W/sr", .found = std::to_string(intensity)});
  return lamp;
}

/// Light of the options, in place of that of a scene file.
void take_light(const CompositeOptions& options, const Given& given, PhotoLightRequest& light) {
  SceneDefinition& scene = light.given;
  scene.environment_radiance = options.environment;
  if (given("--to-sun")) {
    scene.suns = {sun_of(options.sun)};
    if (options.sun.irradiance == std::array<double, 3>{0, 0, 0})
      throw input_error({.field = "--sun-irradiance", .wanted = "a sun that shines", .found = "0 0 0"});
  }
  if (given("--environment-map"))
    scene.environment = EnvironmentDefinition{
        .file = options.environment_map,
        .path = resolve_named_file(options.environment_map, "--environment-map", BuiltinKind::environment),
        .rotation_deg = options.rotation_of_map_deg};
  if (given("--lamp")) scene.lamps = {lamp_of(options.lamp, "--lamp")};
  light.has_given =
      given("--to-sun") || given("--environment") || given("--environment-map") || given("--lamp");
  light.splits_sun = !options.keeps_sun;
}

/// Light of the options that exists only with the objects.
void take_added_light(const CompositeOptions& options, const Given& given, SceneDefinition& added) {
  if (given("--virtual-lamp")) added.lamps = {lamp_of(options.virtual_lamp, "--virtual-lamp")};
  if (!given("--virtual-sun")) return;
  const auto& v = options.virtual_sun;
  const Eigen::Vector3d to_sun(v[0], v[1], v[2]);
  if (!(to_sun.norm() > 0) || v[3] < 0 || v[4] < 0 || v[5] < 0)
    throw input_error({.field = "--virtual-sun",
                       .wanted = "a direction, and an irradiance of at least 0 W/m2",
                       .found = "a direction of no length, or less than 0"});
  added.suns = {SunDefinition{to_sun.normalized(), {v[3], v[4], v[5]}, 0}};
}

void take_objects(const CompositeOptions& options, const Given& given, CompositeRequest& request) {
  take_light(options, given, request.light);
  take_added_light(options, given, request.light.added);
  if (given("--object")) {
    request.objects = {model_of(options, given)};
    return;
  }
  if (options.objects.empty()) return;  // place: a file that is not there yet
  const ObjectsFile file = read_objects_file(options.objects, options.asset_root);
  request.objects = file.objects;
  if (const auto transparency = transparency_of(options.transparent))
    for (PlacedModel& model : request.objects)
      if (model.transparency == Transparency::refused) model.transparency = *transparency;
  if (file.added) {
    if (request.light.added.suns || request.light.added.lamps)
      throw input_error({.file = options.objects,
                         .field = "virtual_light",
                         .wanted = "virtual light in the file or in the options, not in both",
                         .found = "both"});
    request.light.added = *file.added;
  }
  if (!file.has_light) return;
  if (request.light.has_given)
    throw input_error({.file = options.objects,
                       .field = "light",
                       .wanted = "light in the file or in the options, not in both",
                       .found = "both"});
  request.light.given = file.light;
  request.light.has_given = true;
}

CompositeRequest request_of(const CompositeOptions& options, const CLI::App& command, const Given& given) {
  check_given(options, given);
  CompositeRequest request = options.request;
  if (options.projection != "auto")
    request.projection = options.projection == "panorama" ? Projection::panorama : Projection::perspective;
  PhotoDepthRequest& depth = request.depth;
  depth.file = options.mesh.depth;
  depth.density = options.mesh.density;
  depth.tolerance = options.mesh.tolerance;
  depth.yaw_texels = options.mesh.yaw_texels;
  if (options.depth_view != "auto")
    depth.view = options.depth_view == "panorama" ? DepthView::panorama : DepthView::photograph;
  if (options.depth_kind) depth.convention = options.depth_kind;
  take_depth_options(options.depth, command, depth);
  if (options.jumps == sensors::Jumps::cut) depth.cut_ratio = options.jump_ratio;
  if (given("--view")) request.view_px = whole_pair(options.view, 'x');
  if (given("--look-at")) request.look_at_m = as_vector(options.look_at_m);
  if (given("--fov")) request.fov_deg = options.fov_deg;
  request.shadows = options.shadows == "cast";
  if (options.repair != "none") request.repair = options.repair;
  if (given("--depth-width")) {
    if (options.depth_width_px % 2 != 0)
      throw input_error({.field = "--depth-width",
                         .wanted = "an even width",
                         .found = std::to_string(options.depth_width_px)});
    request.depth_width_px = options.depth_width_px;
  }
  if (given("--depth-samples")) request.depth_samples = options.depth_samples;
  request.seamless = given("--seamless");
  if (request.seamless && !options.seamless.empty() && options.seamless != "paper")
    request.thresholds = options.seamless;
  if (options.estimator) request.estimator = options.estimator;
  if (given("--error")) request.error = options.error;
  take_objects(options, given, request);
  return request;
}

void run_composite(const CompositeOptions& options, const CLI::App& command) {
  const Given given(command);
  const bool has_added = given("--virtual-lamp") || given("--virtual-sun");
  if (given("--object") == given("--objects") && !(has_added && !given("--object")))
    throw input_error({.field = "--object",
                       .wanted = "one of --object FILE and --objects FILE.toml, or a virtual light alone",
                       .found = given("--object") ? "both" : "neither"});
  need_extension(options.request.out, {".png", ".exr"});
  if (given("--layers")) need_extension(options.request.layers, {".exr"}, "--layers");
  if (given("--local-scene")) need_extension(options.request.local_scene, {".png"}, "--local-scene");
  if (given("--samples-picture"))
    need_extension(options.request.samples_picture, {".png"}, "--samples-picture");
  if (given("--report")) need_extension(options.request.report, {".html"}, "--report");
  require_outputs(command, {"--out", "--layers", "--local-scene", "--samples-picture", "--report"});
  make_composite(request_of(options, command, given),
                 {.line = [](const std::string& line) { fmt::print("{}\n", line); },
                  .note = [](const std::string& note) { fmt::print(stderr, "note: {}\n", note); }});
}

/// What `place` leaves to `composite`, whose command line is the same but for the first word.
constexpr std::array left_to_composite = {
    "--object",          "--out",      "--layers",         "--report",       "--local-scene",
    "--error",           "--spp",      "--estimator",      "--depth-width",  "--depth-samples",
    "--samples-picture", "--seamless", "--occlusion-mask", "--shadow-matte", "--shadows",
    "--occlusion",       "--seed",     "--condition"};

/// The command line of `composite` with what `place` was given, but for its objects.
std::string shared_command(const CLI::App& place) {
  std::string line = "seamline composite";
  for (const CLI::Option* option : place.get_options()) {
    const std::string name = "--" + option->get_single_name();
    if (option->count() == 0 || name == "--objects" || name == "--add" || name == "--asset-root") continue;
    line += " " + name;
    if (option->get_items_expected_max() == 0) continue;  // a flag
    for (const std::string& value : option->results()) line += " " + shell_word(value);
  }
  return line;
}

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
  PlaceRequest request{.photo = {},
                       .objects_file = options.objects,
                       .asset_root = options.asset_root,
                       .command = shared_command(command),
                       .added = added,
                       .said =
                           [](const std::string& sentence) {
                             fmt::print("{}\n", sentence);
                             std::fflush(stdout);
                           },
                       .note = [](const std::string& note) { fmt::print(stderr, "note: {}\n", note); }};
  CompositeOptions photo = options;
  const bool is_there = std::filesystem::exists(options.objects);
  if (!is_there) photo.objects.clear();
  if (!is_there && added.empty()) request.added = {"builtin:statue"};
  request.photo = request_of(photo, command, given);
  in_window(request);
}

/// --help shows what most composites need, and names these groups.
void group_composite_options(CLI::App& command) {
  group_options(
      command,
      {{"Photograph", {"--projection", "--layer", "--roll", "--camera", "--scene"}},
       {"Depth map",
        {"--depth-view", "--depth-kind", "--mesh", "--tolerance", "--yaw", "--jumps", "--jump-ratio",
         "--repair", "--depth-width", "--depth-samples", "--condition", "--depth-channel", "--nothing"}},
       {"Estimated depth",
        {"--depth-value", "--depth-scale", "--depth-shift", "--depth-point", "--depth-reference"}},
       {"Object's surface", {"--materials", "--object-albedo", "--metallic", "--roughness", "--asset-root"}},
       {"Light",
        {"--sun-radius", "--lamp", "--environment", "--environment-rotation", "--light-panorama",
         "--keep-sun", "--clipped-light", "--virtual-lamp", "--virtual-sun", "--albedo", "--bounces"}},
       {"Who is in front, and shadows",
        {"--occlusion", "--depth-buffer-bits", "--depth-buffer-near", "--depth-buffer-far",
         "--occlusion-mask", "--shadows", "--shadow-matte"}},
       {"Sampling", {"--estimator", "--spp", "--seed", "--threads", "--additive"}},
       {"More output", {"--layers", "--local-scene", "--samples-picture", "--pixels-per-degree"}}});
}

}  // namespace

void add_place_command(CLI::App& app, PlaceInWindow in_window) {
  auto options = std::make_shared<CompositeOptions>();
  auto added = std::make_shared<std::vector<std::string>>();
  CLI::App* command =
      app.add_subcommand("place", "put objects on the real surfaces of a photograph, in a window");
  add_composite_options(*command, *options);
  group_composite_options(*command);
  for (const char* name : left_to_composite) command->get_option(name)->group("")->required(false);
  options->objects = "objects.toml";
  command->get_option("--objects")
      ->description(
          "the file that is changed (TOML, documentation/how-to/composite.md), or made where it is not there")
      ->capture_default_str();
  command->add_option(
      "--add", *added,
      "an object to put there besides: .glb, .gltf or builtin:NAME; may be given again (a new file without any "
      "begins with builtin:statue)");
  command->callback(
      [options, added, command, in_window] { run_place(*options, *added, *command, in_window); });
}

void add_composite_command(CLI::App& app) {
  auto options = std::make_shared<CompositeOptions>();
  CLI::App* command =
      app.add_subcommand("composite", "put objects into a photograph or a panorama, through its depth");
  add_composite_options(*command, *options);
  group_composite_options(*command);
  command->callback([options, command] { run_composite(*options, *command); });
}

}  // namespace seamline::renderer
