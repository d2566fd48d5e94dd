#include "commands/photographs/view_options.h"

#include <array>
#include <utility>

#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

constexpr std::array every_kind = {ViewKind::mono, ViewKind::side_by_side, ViewKind::anaglyph,
                                   ViewKind::interleaved, ViewKind::depth_image};
constexpr std::array every_matrix = {AnaglyphMatrix::dubois, AnaglyphMatrix::colour,
                                     AnaglyphMatrix::half_colour, AnaglyphMatrix::grey};

/// Options that were given, each with the key of a study that means the same.
std::vector<std::pair<const char*, const char*>> given(const ViewOptions& options) {
  std::vector<std::pair<const char*, const char*>> out;
  const auto add = [&](bool is_given, const char* option, const char* key) {
    if (is_given) out.emplace_back(option, key);
  };
  add(options.separation_m.has_value(), "--separation", "separation_m");
  add(options.zero_parallax_m.has_value(), "--zero-parallax", "zero_parallax_m");
  add(options.views.has_value(), "--views", "views");
  add(options.pitch_subpixels.has_value(), "--pitch", "pitch_subpixels");
  add(options.slant_deg.has_value(), "--slant", "slant_deg");
  add(options.offset_subpixels.has_value(), "--offset", "offset_subpixels");
  add(options.has_matrix, "--anaglyph", "matrix");
  add(options.max_depth_m.has_value(), "--max-depth", "max_depth_m");
  return out;
}

}  // namespace

void add_eye_options(CLI::App& command, ViewOptions& options) {
  add_number(command, "--separation", options.separation_m, {1e-6, 1000, "m"},
             "between neighbouring eyes (default: 0.065)");
  add_number(command, "--zero-parallax", options.zero_parallax_m, {1e-3, limits::farthest_place_m, "m"},
             "distance from the camera's plane at which all eyes see a thing at the same place");
}

void add_sheet_options(CLI::App& command, ViewOptions& options) {
  add_number(command, "--views", options.views, {2, 64}, "under the lens sheet (default: 5)");
  add_number(command, "--pitch", options.pitch_subpixels, {1, 10000, "sub-pixels"},
             "of the lenses along a row (default: 5)");
  add_number(
      command, "--slant", options.slant_deg, {-80, 80, "degrees"},
      "of the lenses from the vertical, to the right downwards (default: 18.435, one sub-pixel a row)");
  add_number(command, "--offset", options.offset_subpixels, {-10000, 10000, "sub-pixels"},
             "by which a lens begins to the left of the picture's corner (default: 0)");
}

void add_view_options(CLI::App& command, ViewOptions& options) {
  std::vector<std::string> kinds, matrices;
  for (const ViewKind kind : every_kind) kinds.emplace_back(word(kind));
  for (const AnaglyphMatrix matrix : every_matrix) matrices.emplace_back(word(matrix));
  command
      .add_option("--view", options.kind,
                  "how the picture is shown: of one eye, of two (side_by_side, each squeezed to half the "
                  "width; anaglyph, for red and cyan glasses), of several under a lens sheet (interleaved), "
                  "or with its depth beside it")
      ->check(CLI::IsMember(kinds))
      ->capture_default_str();
  add_eye_options(command, options);
  add_sheet_options(command, options);
  command.add_option("--anaglyph", options.matrix, "which colours an anaglyph takes from each eye")
      ->check(CLI::IsMember(matrices))
      ->capture_default_str()
      ->each([&options](const std::string&) { options.has_matrix = true; });
  add_number(command, "--max-depth", options.max_depth_m, {1e-3, limits::farthest_place_m, "m"},
             "that white stands for in the depth beside a picture");
}

View view_of(const ViewOptions& options) {
  View view;
  for (const ViewKind kind : every_kind)
    if (word(kind) == options.kind) view.kind = kind;
  for (const auto& [option, key] : given(options))
    if (!uses(view.kind, key))
      throw input_error({.field = option,
                         .wanted = "--view " + kinds_that_use(key) + " beside it",
                         .found = "--view " + options.kind});
  if (uses(view.kind, "zero_parallax_m") && !options.zero_parallax_m)
    throw input_error(
        {.field = "--zero-parallax",
         .wanted = "the distance in metres at which the screen seems to be, for --view " + options.kind,
         .found = "none"});
  if (uses(view.kind, "max_depth_m") && !options.max_depth_m)
    throw input_error({.field = "--max-depth",
                       .wanted = "the depth in metres that white stands for, for --view " + options.kind,
                       .found = "none"});
  if (view.kind == ViewKind::interleaved) {
    view.views = 5;
    view.sheet = five_views_sheet;
  }
  view.separation_m = options.separation_m.value_or(view.separation_m);
  view.zero_parallax_m = options.zero_parallax_m.value_or(view.zero_parallax_m);
  view.views = options.views.value_or(view.views);
  view.sheet.pitch_subpixels = options.pitch_subpixels.value_or(view.sheet.pitch_subpixels);
  view.sheet.slant_deg = options.slant_deg.value_or(view.sheet.slant_deg);
  view.sheet.offset_subpixels = options.offset_subpixels.value_or(view.sheet.offset_subpixels);
  view.max_depth_m = options.max_depth_m.value_or(view.max_depth_m);
  for (const AnaglyphMatrix matrix : every_matrix)
    if (word(matrix) == options.matrix) view.matrix = matrix;
  return view;
}

}  // namespace seamline::renderer
