#include "commands/depth_cameras/depth_camera_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "commands/options/command_help.h"
#include "commands/options/output_files.h"
#include "commands/options/setting_option.h"
#include "composites/objects/objects_file.h"
#include "live/running/run_headless.h"
#include "physics/rigid_world.h"
#include "support/files/assets.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::live {
namespace {

struct LiveOptions {
  std::string recording, objects_file, size, out, csv;
  std::vector<std::string> objects;
  std::vector<double> at_m, heights_m;
  sensors::Jumps jumps = sensors::Jumps::stretch;
  bool headless = false, time = false, marker_given = false;
  bool spacing_given = false, parallax_given = false, drop_given = false;
  LiveRequest request;
};

void check_size(const std::string& text) {
  const auto size = whole_pair(text, 'x');
  if (!size || size->first < 2 || size->second < 2 || size->first > limits::largest_picture_side_px ||
      size->second > limits::largest_picture_side_px)
    throw input_error(
        {.field = "--size", .wanted = "WIDTHxHEIGHT, e.g. 800x600", .found = "\"" + text + "\""});
}

/// An option that would be ignored is refused.
void check(const LiveOptions& options) {
  const auto refuse = [](const char* option, const char* wanted, const char* found) {
    throw input_error({.field = option, .wanted = wanted, .found = found});
  };
  if (options.objects.empty() && options.objects_file.empty())
    refuse("--object", "at least one --object, or --objects FILE", "neither");
  if (!options.objects.empty() && !options.objects_file.empty())
    refuse("--objects", "--object or --objects, not both", "both");
  if (options.objects.empty() && (!options.at_m.empty() || !options.heights_m.empty()))
    refuse(options.at_m.empty() ? "--height" : "--at", "--object beside it", "--objects");
  if (!options.at_m.empty() && options.at_m.size() != 3 * options.objects.size())
    refuse("--at", "three numbers for each --object", "another count");
  if (!options.heights_m.empty() && options.heights_m.size() != options.objects.size())
    refuse("--height", "one number for each --object", "another count");
  if (!options.headless && !options.out.empty()) refuse("--out", "--headless beside it", "a window");
  if (!options.headless && options.time) refuse("--time", "--headless beside it", "a window");
  if (options.headless && options.out.empty() && options.csv.empty() && !options.time)
    refuse("--headless", "--out, --csv or --time beside it", "none of them");
  if (options.marker_given && options.request.tracking != Tracking::marker)
    refuse("--marker-side", "--track marker beside it", "another way");
  if ((options.spacing_given || options.parallax_given) && options.request.settings.views == 1)
    refuse(options.spacing_given ? "--eye-spacing" : "--zero-parallax", "--views of at least 2 beside it",
           "one view");
  if (options.drop_given && !options.request.physics) refuse("--drop", "--physics beside it", "none");
  if (options.request.physics && !renderer::has_physics())
    refuse("--physics", "Seamline built with Bullet (Debian: libbullet-dev)", "a build without it");
}

LiveRequest request_of(const LiveOptions& options) {
  LiveRequest request = options.request;
  request.recording = options.recording;
  if (options.jumps == sensors::Jumps::cut) request.settings.local_mesh.cut_ratio = 1.1F;
  if (const auto size = whole_pair(options.size, 'x')) {
    request.load.width_px = size->first;
    request.load.height_px = size->second;
  }
  request.load.threads = request.settings.threads;
  request.load.most_frames = options.headless ? request.frames : 0;
  request.out = options.out;
  request.csv = options.csv;
  for (std::size_t i = 0; i < options.objects.size(); ++i) {
    RequestedObject object{.file = options.objects[i],
                           .path = resolve_named_file(options.objects[i], "--object")};
    if (!options.at_m.empty())
      object.position_m =
          Eigen::Vector3d(options.at_m[3 * i], options.at_m[3 * i + 1], options.at_m[3 * i + 2]);
    if (!options.heights_m.empty()) object.height_m = options.heights_m[i];
    request.objects.push_back(std::move(object));
  }
  if (!options.objects_file.empty()) {
    renderer::ObjectsFile file = renderer::read_objects_file(options.objects_file, {});
    request.models = std::move(file.objects);
    if (file.has_light) request.light = file.light;
  }
  return request;
}

void run_live(const LiveOptions& options, const ShowInWindow& show) {
  check(options);
  if (!options.headless && !show)
    throw input_error({.field = "live",
                       .wanted = "--headless, because this Seamline was built without a window",
                       .found = "none"});
  const LiveRequest request = request_of(options);
  if (options.headless)
    fmt::print("{}", run_headless(request));
  else
    show(request);
}

}  // namespace

void add_live_command(CLI::App& app, const ShowInWindow& show) {
  auto options = std::make_shared<LiveOptions>();
  LiveRequest& request = options->request;
  CLI::App* command =
      app.add_subcommand("live", "virtual things in a recording of depth and colour, as it plays");
  command->add_option("recording", options->recording, "folder with recording.toml")->required();
  command->add_option("--object", options->objects, ".glb, .gltf or builtin:NAME; may be given again");
  add_number(*command, "--at", options->at_m, any_place_m,
             "where each object stands, X Y Z in the world (default: what the first picture's middle shows)");
  add_number(*command, "--height", options->heights_m, {1e-6, 1e6, "m"},
             "of each object (default: a fifth of its distance)");
  command->add_option("--objects", options->objects_file,
                      "file of objects, perhaps with their light, as of composite");
  add_choice(*command, "--mapping", request.methods.mapping, every_mapping,
             "how depth comes into the picture's pixels");
  add_choice(*command, "--occlusion", request.methods.occlusion, every_occlusion,
             "who says what is in front");
  add_choice(*command, "--shadows", request.methods.shadows, every_shadows, "how light is kept away");
  add_choice(*command, "--track", request.tracking, every_tracking, "where the camera's poses come from");
  command->add_flag("--physics", request.physics,
                    "the objects fall, in the recording's time, and rest on the real surfaces that each "
                    "frame shows (needs Bullet)");
  CLI::Option* drop = add_number(*command, "--drop", request.drop_m, {0, 100, "m"},
                                 "how high above its place each object is let go (with --physics)")
                          ->capture_default_str();
  CLI::Option* marker = add_number(*command, "--marker-side", options->request.marker_side_m,
                                   {0.001, 100, "m"}, "of the marker that is tracked")
                            ->capture_default_str();
  add_formed_text(*command, "--size", options->size, "WxH", "of the picture (default: the colour camera's)",
                  check_size);
  add_number(*command, "--triangles", request.settings.local_mesh.most_triangles, {0, 80000000},
             "of the local scene, at most; 0: two for each pixel of depth")
      ->capture_default_str();
  add_choice(*command, "--jumps", options->jumps, std::array{sensors::Jumps::stretch, sensors::Jumps::cut},
             "what the local scene does where depth jumps");
  add_number(*command, "--shadow-map", request.settings.shadow_map_px, {16, 8192, "px"}, "a side")
      ->capture_default_str();
  add_number(*command, "--shadow-bias", request.settings.shadow_bias_texels, {0, 1000, "texels"},
             "that light passes near surfaces")
      ->capture_default_str();
  add_number(*command, "--depth-bias", request.settings.depth_bias, {0, 1},
             "share of the distance within which a real surface does not shade itself")
      ->capture_default_str();
  add_number(*command, "--surface-reach", request.settings.surface_reach_px, {1, 1000, "px"},
             "how far beside a pixel the depths lie through which the plane that a shadow falls on is "
             "fitted; 1: its own depth, and its neighbours for the normal")
      ->capture_default_str();
  add_number(*command, "--views", request.settings.views, {1, 64}, "eyes beside each other")
      ->capture_default_str();
  CLI::Option* spacing = add_number(*command, "--eye-spacing", request.settings.eye_spacing_m,
                                    {1e-6, 100, "m"}, "between neighbouring eyes")
                             ->capture_default_str();
  CLI::Option* parallax = add_number(*command, "--zero-parallax", request.settings.zero_parallax_m,
                                     {1e-6, 1e9, "m"}, "distance at which all views agree")
                              ->capture_default_str();
  add_number(*command, "--threads", request.settings.threads, {0, 1024}, "0: one for each core")
      ->capture_default_str();
  add_number(*command, "--frames", request.frames, {0, 1e9},
             "to show, from the first again after the last; 0: the recording once, or until you leave")
      ->capture_default_str();
  command->add_flag("--headless", options->headless, "without a window");
  command->add_option("--out", options->out, "folder for pictures; made when missing (with --headless)");
  command->add_option(
      "--csv", options->csv,
      "file for the time of each stage of each frame; with --physics also FILE_poses for the poses");
  command->add_flag("--time", options->time, "only print the times (with --headless)");
  group_options(*command, {{"Local scene", {"--mapping", "--triangles", "--jumps", "--surface-reach"}},
                           {"Shadows", {"--shadow-map", "--shadow-bias", "--depth-bias"}},
                           {"Physics and tracking", {"--drop", "--marker-side"}},
                           {"Several eyes", {"--views", "--eye-spacing", "--zero-parallax"}},
                           {"Without a window", {"--headless", "--out", "--csv", "--time", "--threads"}}});
  command->callback([options, show, marker, spacing, parallax, drop, command] {
    require_outputs(*command, {"--csv"});
    options->marker_given = marker->count() > 0;
    options->spacing_given = spacing->count() > 0;
    options->parallax_given = parallax->count() > 0;
    options->drop_given = drop->count() > 0;
    run_live(*options, show);
  });
}

}  // namespace seamline::live
