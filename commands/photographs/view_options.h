#pragma once
#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "stimuli/definition/views/view.h"

namespace seamline::renderer {

/// How a picture is shown, as options: those of a study's `[view]`.
struct ViewOptions {
  std::string kind = "mono", matrix = "dubois";
  std::optional<double> separation_m, zero_parallax_m, pitch_subpixels, slant_deg, offset_subpixels,
      max_depth_m;
  std::optional<int> views;
  bool has_matrix = false;
};

/// `--separation`, `--zero-parallax`: eyes of which a picture is made.
void add_eye_options(CLI::App& command, ViewOptions& options);
/// `--views`, `--pitch`, `--slant`, `--offset`: a lens sheet, that of five views where nothing is said.
void add_sheet_options(CLI::App& command, ViewOptions& options);
/// `--view`, `--anaglyph` and `--max-depth` beside those.
void add_view_options(CLI::App& command, ViewOptions& options);

/// The view that the options name. Throws InputError at an option that the kind ignores, and where one is
/// missing that it needs.
[[nodiscard]] View view_of(const ViewOptions& options);

}  // namespace seamline::renderer
