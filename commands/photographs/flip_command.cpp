#include "commands/photographs/photograph_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "commands/options/output_files.h"
#include "commands/photographs/mesh_options.h"
#include "stimuli/definition/study_definition.h"
#include "stimuli/pictures/flip.h"
#include "stimuli/pictures/flip_map.h"
#include "support/files/image.h"
#include "support/files/picture_file.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/number_option.h"
#include "support/text/printable.h"

namespace seamline::renderer {
namespace {

struct FlipOptions {
  std::string reference, test, map;
  std::vector<std::string> regions;
  double pixels_per_degree = default_pixels_per_degree, exposure_ev = 0;
};

/// A named rectangle of a picture.
struct NamedRegion {
  std::string name;
  int left_px = 0, top_px = 0, width_px = 0, height_px = 0;
};

/// "NAME=LEFT,TOP,WIDTH,HEIGHT".
NamedRegion region_of(const std::string& text, const Image& flip) {
  const auto wrong = [&](const std::string& wanted) {
    return input_error({.field = "--region", .wanted = wanted, .found = printable(text)});
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) throw wrong("NAME=LEFT,TOP,WIDTH,HEIGHT in pixels");
  std::vector<int> numbers;
  for (std::size_t from = equals + 1; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    const auto number = decimal_number(std::string_view(text).substr(from, comma - from));
    if (!number || *number != std::floor(*number) || std::abs(*number) > limits::largest_picture_side_px)
      throw wrong("NAME=LEFT,TOP,WIDTH,HEIGHT in pixels");
    numbers.push_back(static_cast<int>(*number));
    from = comma + 1;
  }
  if (numbers.size() != 4) throw wrong("NAME=LEFT,TOP,WIDTH,HEIGHT in pixels");
  const int left = numbers[0], top = numbers[1], width = numbers[2], height = numbers[3];
  if (left < 0 || top < 0 || width < 1 || height < 1 || left > flip.width_px - width ||
      top > flip.height_px - height)
    throw wrong(
        fmt::format("a rectangle inside the pictures of {} x {} pixels", flip.width_px, flip.height_px));
  return {text.substr(0, equals), left, top, width, height};
}

ByteImage seen_picture(const std::string& file, double exposure_ev) {
  const PictureFile picture = read_picture(file);
  if (lower_case_ending(file) == ".png" && !picture.profile) return read_bytes_image(file);
  for (const std::string& note : picture.notes) fmt::print(stderr, "note: {}: {}\n", printable(file), note);
  require_numbers(picture.image, file);
  return display_image(picture.image, exposure_ev);
}

/// Mean and largest FLIP of a rectangle, in one line.
void print_flip(const Image& flip, const NamedRegion& region) {
  double sum = 0, most = 0;
  for (int y = region.top_px; y < region.top_px + region.height_px; ++y)
    for (int x = region.left_px; x < region.left_px + region.width_px; ++x) {
      sum += double{flip.at(x, y)};
      most = std::max(most, double{flip.at(x, y)});
    }
  fmt::print("{}: mean {:.4f}, most {:.3f}, {} x {} pixels\n", printable(region.name),
             sum / (double{1} * region.width_px * region.height_px), most, region.width_px, region.height_px);
}

void run_flip(const FlipOptions& options) {
  const ByteImage reference = seen_picture(options.reference, options.exposure_ev);
  const ByteImage test = seen_picture(options.test, options.exposure_ev);
  const auto shape = [](const ByteImage& picture) {
    return fmt::format("{} x {} pixels of {} channels", picture.width_px, picture.height_px,
                       picture.channels);
  };
  for (const auto& [file, picture] : {std::pair{&options.reference, &reference}, {&options.test, &test}})
    if (picture->channels != 1 && picture->channels != 3)
      throw input_error({.file = *file, .wanted = "a picture of 1 or 3 channels", .found = shape(*picture)});
  if (reference.width_px != test.width_px || reference.height_px != test.height_px ||
      reference.channels != test.channels)
    throw input_error({.file = options.test,
                       .wanted = shape(reference) + ", as the first picture has",
                       .found = shape(test)});
  const FlipPicture first = flip_picture(reference, options.pixels_per_degree);
  stop_if_interrupted();
  const FlipPicture second = flip_picture(test, options.pixels_per_degree);
  stop_if_interrupted();
  const Image flip = flip_difference(first, second);
  stop_if_interrupted();
  std::vector<NamedRegion> regions = {{"picture", 0, 0, flip.width_px, flip.height_px}};
  for (const std::string& text : options.regions) regions.push_back(region_of(text, flip));
  for (const NamedRegion& region : regions) print_flip(flip, region);
  if (!options.map.empty()) write_png(options.map, flip_map(flip));
}

}  // namespace

void add_flip_command(CLI::App& app) {
  auto options = std::make_shared<FlipOptions>();
  CLI::App* command =
      app.add_subcommand("flip", "the difference between two pictures that people see (FLIP)");
  command
      ->add_option("reference", options->reference,
                   "a picture: .png as it is shown, or .exr and .hdr, shown with --exposure")
      ->required();
  command->add_option("picture", options->test, "another of the same size")->required();
  command->add_option("--region", options->regions,
                      "NAME=LEFT,TOP,WIDTH,HEIGHT in pixels from the top left: a part of which FLIP is said, "
                      "too; may be given again");
  command->add_option("--map", options->map,
                      "write FLIP as a picture (.png), from black (0) to pale yellow (1)");
  add_number(*command, "--pixels-per-degree", options->pixels_per_degree, {1, 1000},
             "at which people see the pictures")
      ->capture_default_str();
  add_number(*command, "--exposure", options->exposure_ev, {-60, 60, "stops"}, "of pictures of radiance")
      ->capture_default_str();
  command->callback([options, command] {
    if (!options->map.empty()) need_extension(options->map, {".png"}, "--map");
    require_outputs(*command, {"--map"});
    run_flip(*options);
  });
}

}  // namespace seamline::renderer
