#include "commands/photographs/photograph_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "commands/options/output_files.h"
#include "commands/photographs/view_options.h"
#include "renderer/views/depth_image.h"
#include "renderer/views/lens_sheet.h"
#include "renderer/views/synthesised_views.h"
#include "support/files/atomic_file.h"
#include "support/files/image.h"
#include "support/running/interrupt.h"
#include "support/running/progress.h"
#include "support/text/error.h"
#include "support/text/number_option.h"
#include "support/text/printable.h"

namespace seamline::renderer {
namespace {

struct ViewsOptions {
  std::string frame, background, mask, out;
  double max_depth_m = 0, fov_deg = 0;
  ViewOptions view;
};

constexpr const char* interleaved_file = "interleaved.png";

std::string view_file(int view) {
  return fmt::format("view-{}.png", view + 1);
}

std::string holes_file(int view) {
  return fmt::format("view-{}-holes.png", view + 1);
}

std::vector<std::string> files_of_views(int views) {
  std::vector<std::string> files{interleaved_file};
  for (int view = 0; view < views; ++view) {
    files.push_back(view_file(view));
    files.push_back(holes_file(view));
  }
  return files;
}

/// The two halves of the frame, stretched to the frame's own size.
PictureWithDepth read_frame(const ViewsOptions& options, int views) {
  const Image linear = read_image(options.frame);
  if (linear.width_px % 2 != 0 || linear.width_px < 4)
    throw input_error({.file = printable(options.frame),
                       .wanted = "a picture and its depth side by side, of an even width",
                       .found = fmt::format("{} columns", linear.width_px)});
  if (views * linear.width_px > limits::largest_picture_side_px)
    throw input_error(
        {.field = "--views",
         .wanted = fmt::format("at most {} columns in all views together", limits::largest_picture_side_px),
         .found = fmt::format("{} views of {}", views, linear.width_px)});
  const ByteImage codes = half_of(display_image(linear), true);
  Image colour(linear.width_px / 2, linear.height_px, 3);
  for (int y = 0; y < colour.height_px; ++y)
    for (int x = 0; x < colour.width_px; ++x)
      for (int channel = 0; channel < 3; ++channel)
        colour.at(x, y, channel) = linear.at(x, y, std::min(channel, linear.channels - 1));
  return {.colour = stretched(colour, false),
          .planar_m = stretched(depth_of_codes(codes, options.max_depth_m), true)};
}

Image read_beside(const std::string& file, const Image& picture, int channels) {
  const Image read = read_image(file);
  if (read.width_px != picture.width_px || read.height_px != picture.height_px)
    throw input_error(
        {.file = printable(file),
         .wanted = fmt::format("{} x {} pixels, as the frame has", picture.width_px, picture.height_px),
         .found = fmt::format("{} x {}", read.width_px, read.height_px)});
  Image out(read.width_px, read.height_px, channels);
  for (int y = 0; y < out.height_px; ++y)
    for (int x = 0; x < out.width_px; ++x)
      for (int channel = 0; channel < channels; ++channel)
        out.at(x, y, channel) = read.at(x, y, std::min(channel, read.channels - 1));
  return out;
}

/// A code of no depth at all, which the camera would stand in.
void require_depth(const Image& planar_m, const ViewsOptions& options) {
  for (const float depth_m : planar_m.values)
    if (!(depth_m > 0))
      throw input_error({.file = printable(options.frame),
                         .wanted = "depth of 1 to 255 in its right half (255 is --max-depth)",
                         .found = "0, which is in the camera itself"});
}

void run_views(const ViewsOptions& options) {
  const View view = view_of(options.view);
  if (lower_case_ending(options.frame) != ".png")
    throw input_error({.field = "frame", .wanted = "a .png", .found = printable(options.frame)});
  PictureWithDepth from = read_frame(options, view.views);
  require_depth(from.planar_m, options);
  if (!options.background.empty()) from.background = read_beside(options.background, from.colour, 3);
  if (!options.mask.empty()) from.foreground = read_beside(options.mask, from.colour, 1);
  const std::filesystem::path folder = options.out;
  prepare_output_folder(folder);
  const int width_px = from.colour.width_px;
  const double focal_px = 0.5 * width_px / std::tan(0.5 * options.fov_deg * std::numbers::pi / 180);
  Image all_eyes(view.views * width_px, from.colour.height_px, 3);
  Progress progress("views", view.views);
  std::string said;
  for (int k = 0; k < view.views; ++k) {
    stop_if_interrupted();
    const double right_m = (k - 0.5 * (view.views - 1)) * view.separation_m;
    const SynthesisedView made = view_from_depth(
        from, {.right_m = right_m, .zero_parallax_m = view.zero_parallax_m, .focal_px = focal_px});
    write_png(folder / view_file(k), display_image(made.picture));
    write_png(folder / holes_file(k), display_image(with_holes_shown(made)));
    said += fmt::format("view {}: eye {:+.4f} m, holes {:.2f} %\n", k + 1, right_m, 100 * hole_share(made));
    for (int y = 0; y < all_eyes.height_px; ++y)
      for (int x = 0; x < width_px; ++x) all_eyes.set_rgb(k * width_px + x, y, made.picture.rgb(x, y));
    progress.advance(1, "");
  }
  write_png(folder / interleaved_file, display_image(interleave(sheet_screen(view, width_px), all_eyes)));
  fmt::print("{}Views, their holes in magenta, and all under the lens sheet: {}\n", said,
             (folder / interleaved_file).string());
}

}  // namespace

void add_views_command(CLI::App& app) {
  auto options = std::make_shared<ViewsOptions>();
  CLI::App* command = app.add_subcommand("views", "views that a screen makes of a picture and its depth");
  command
      ->add_option(
          "frame", options->frame,
          ".png: the picture and, beside it on the right, its depth, each squeezed to half the width "
          "(`seamline picture --view 2d_plus_depth` writes such)")
      ->required();
  command->add_option("--out", options->out, "folder for the views")->required();
  add_number(*command, "--max-depth", options->max_depth_m, {1e-3, limits::farthest_place_m, "m"},
             "that white stands for in the depth")
      ->required();
  add_number(*command, "--fov", options->fov_deg, {1, 170, "degrees"},
             "horizontal field of view of the picture")
      ->required();
  options->view.kind = word(ViewKind::interleaved);
  add_eye_options(*command, options->view);
  command->get_option("--zero-parallax")->required();
  add_sheet_options(*command, options->view);
  CLI::Option* background =
      command->add_option("--background", options->background,
                          "picture of what is behind, of the frame's size, which fills holes");
  command
      ->add_option("--mask", options->mask,
                   "where the background is another than the picture: white; of the frame's size")
      ->needs(background);
  command->callback([options, command] {
    require_outputs_in_folder(*command, files_of_views(view_of(options->view).views));
    run_views(*options);
  });
}

}  // namespace seamline::renderer
