#pragma once
#include <filesystem>
#include <string>

#include "support/files/atomic_file.h"

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

/// What a script draws, as SVG. `script` must not set terminal or output. gnuplot sees nothing but a
/// temporary folder that only we can write to, because a script of gnuplot may run any command. Throws
/// InputError when gnuplot is missing or there is no room, std::runtime_error with what it said when it
/// fails.
[[nodiscard]] std::string drawn_svg(int width_px, int height_px, const std::string& script);

/// The same into a file; the script is kept beside it as `.gnuplot`, so that a figure can be restyled by
/// hand.
void draw_svg(const std::filesystem::path& svg, int width_px, int height_px, const std::string& script,
              Readers readers = Readers::everybody);

// Figures for one column of a paper: printed 85 mm wide, their letters are at least 6 points high.
inline constexpr double column_mm = 85;
inline constexpr int column_width_px = 480;
inline constexpr int smallest_letters_px = 12;

/// Draws such a figure, `column_width_px` wide, as SVG and beside it as PDF of 85 mm. The script is kept too:
/// `gnuplot -c FIGURE.gnuplot OUT.pdf pdf` makes the PDF, without arguments it makes the SVG. The same bytes
/// each time.
void draw_figure(const std::filesystem::path& svg, int height_px, const std::string& script,
                 Readers readers = Readers::everybody);

/// Text between double quotes of a gnuplot script, with gnuplot's own escapes and enhanced-text markup made
/// harmless.
[[nodiscard]] std::string gnuplot_text(const std::string& text);

}  // namespace seamline
