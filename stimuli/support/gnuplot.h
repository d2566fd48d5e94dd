#pragma once
#include <filesystem>
#include <string>

namespace seamline {

// The only place that knows gnuplot: it runs as a child process on a script file.

/// How a line is drawn: Okabe and Ito's palette, which colour-blind readers can tell apart, and a filled
/// point type of gnuplot's of its own.
struct PlotStyle {
  const char* colour;
  int point;
};
[[nodiscard]] PlotStyle plot_style(std::size_t index);
inline constexpr const char* plot_ink = "#333334";  ///< axes and text

/// Throws InputError, naming the Debian package, when there is no gnuplot on the PATH.
void require_gnuplot();

/// Runs a script that writes `svg` (the script is kept beside it as `.gnuplot`, so that a figure can be
/// restyled by hand). `script` must not set terminal or output. Throws InputError when gnuplot is missing,
/// std::runtime_error with what it said when it fails.
void draw_svg(const std::filesystem::path& svg, int width_px, int height_px, const std::string& script);

/// Text between double quotes of a gnuplot script, with gnuplot's own escapes and enhanced-text markup made
/// harmless.
[[nodiscard]] std::string gnuplot_text(const std::string& text);

}  // namespace seamline
