#include "support/files/gnuplot.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "support/files/temporary_folder.h"
#include "support/running/child_process.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"
#include "support/text/printable.h"

namespace seamline {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_label = 300;  ///< letters; more leave any figure

InputError no_gnuplot() {
  return input_error({.file = "gnuplot",
                      .field = "",
                      .wanted = "the program gnuplot, which draws the figures (Debian package gnuplot-nox)",
                      .found = "none on the PATH"});
}

/// Runs `gnuplot SCRIPT`; its errors are its output. A user's own settings (`-d`: none) would make other
/// bytes of the same figure.
ChildResult run_gnuplot(const std::string& script) {
  const std::optional<ChildResult> result =
      run_child({.command = {"gnuplot", "-d", script}, .keeps_errors = true});
  if (!result) throw no_gnuplot();
  stop_if_interrupted();  // Ctrl-C ends gnuplot too
  return *result;
}

/// A text as gnuplot reads it between single quotes.
std::string quoted(const std::string& text) {
  std::string safe = "'";
  for (const char letter : text) safe += letter == '\'' ? "''" : std::string(1, letter);
  return safe + "'";
}

bool is_whole_svg(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \n");
  return end != std::string::npos && text.substr(0, end + 1).ends_with("</svg>");
}

/// As a file of its own: it writes `name`, or the file that its caller names.
std::string whole_script(const std::string& name, int width_px, int height_px, const std::string& script) {
  return fmt::format(
      "set encoding utf8\nset terminal svg size {},{} dynamic enhanced font 'Helvetica,Arial,"
      "DejaVu Sans,sans-serif,14' butt linewidth 1.2\nset output ARGC > 0 ? ARG1 : '{}'\n{}",
      width_px, height_px, name, script);
}

bool is_whole_pdf(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \n");
  return text.starts_with("%PDF") && text.substr(0, end + 1).ends_with("%%EOF");
}

/// Cairo writes the time; the same figure has the same bytes.
void set_date(std::string& pdf) {
  constexpr std::string_view key = "/CreationDate (D:", none = "19700101000000";
  if (const std::size_t at = pdf.find(key); at != std::string::npos)
    pdf.replace(at + key.size(), none.size(), none);
}

/// The same script makes the SVG, or with a second argument the PDF.
std::string figure_script(const std::string& name, int height_px, const std::string& script) {
  constexpr double cm_of_px = 0.1 * column_mm / column_width_px;
  constexpr double points_of_px = 72 / 2.54 * cm_of_px, cairo_dpi = 96;
  return fmt::format(
      "set encoding utf8\n"
      "if (ARGC > 1) {{ set terminal pdfcairo size {0:.4f}cm,{1:.4f}cm enhanced font 'Helvetica,{2}' "
      "fontscale "
      "{3:.5f} linewidth {4:.4f} pointscale {5:.4f} dashlength 0.6 }} else {{ set terminal svg size {6},{7} "
      "dynamic "
      "enhanced font 'Helvetica,Arial,DejaVu Sans,sans-serif,{2}' butt linewidth 1.2 }}\n"
      "set output ARGC > 0 ? ARG1 : '{8}'\n{9}",
      column_width_px * cm_of_px, height_px * cm_of_px, smallest_letters_px, points_of_px * 72 / cairo_dpi,
      1.2 * points_of_px, 1.15 * points_of_px, column_width_px, height_px, name, script);
}

/// `shown` is what a complaint names.
std::string svg_of(const std::string& script, const std::string& shown) {
  const TemporaryFolder folder;
  const fs::path script_file = folder / "script", caller = folder / "call", svg = folder / "svg";
  write_file_atomically(script_file, script);
  write_file_atomically(caller,
                        fmt::format("call {} {}\n", quoted(script_file.string()), quoted(svg.string())));
  const ChildResult drawn = run_gnuplot(caller.string());
  if (drawn.status != 0) throw std::runtime_error("gnuplot failed on " + shown + ": " + drawn.output);
  std::string text = fs::exists(svg) ? read_file(svg) : std::string();
  if (!is_whole_svg(text))  // gnuplot does not notice a disk that is full
    throw input_error({.file = shown, .wanted = "room for a figure", .found = "a full disk"});
  return text;
}

}  // namespace

PlotStyle plot_style(std::size_t index) {
  constexpr std::array<PlotStyle, 7> styles = {{{"#0072B2", 7},
                                                {"#D55E00", 5},
                                                {"#009E73", 9},
                                                {"#CC79A7", 13},
                                                {"#E69F00", 11},
                                                {"#56B4E9", 15},
                                                {"#7F7F7F", 7}}};
  return styles[index % styles.size()];
}

void require_gnuplot() {
  const char* path = std::getenv("PATH");
  std::string folders = path == nullptr ? "/usr/local/bin:/usr/bin:/bin" : path;
  for (std::size_t begin = 0; begin <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', begin), folders.size());
    if (access((fs::path(folders.substr(begin, end - begin)) / "gnuplot").c_str(), X_OK) == 0) return;
    begin = end + 1;
  }
  throw no_gnuplot();
}

std::string drawn_svg(int width_px, int height_px, const std::string& script) {
  return svg_of(whole_script("figure.svg", width_px, height_px, script), "a figure");
}

void draw_svg(const fs::path& svg, int width_px, int height_px, const std::string& script, Readers readers) {
  // The script that is kept names no folder and can be moved with the report.
  const std::string whole = whole_script(svg.filename().string(), width_px, height_px, script);
  write_file_atomically(fs::path(svg).replace_extension(".gnuplot"), whole, readers);
  write_file_atomically(svg, svg_of(whole, svg.string()), readers);
}

void draw_figure(const fs::path& svg, int height_px, const std::string& script, Readers readers) {
  const std::string whole = figure_script(svg.filename().string(), height_px, script);
  const TemporaryFolder folder;
  const fs::path script_file = folder / "script", caller = folder / "call", svg_file = folder / "svg",
                 pdf_file = folder / "pdf";
  write_file_atomically(script_file, whole);
  write_file_atomically(caller, fmt::format("call {0} {1}\nunset output\nreset\ncall {0} {2} 'pdf'\n",
                                            quoted(script_file.string()), quoted(svg_file.string()),
                                            quoted(pdf_file.string())));
  const ChildResult run = run_gnuplot(caller.string());
  if (run.status != 0) throw std::runtime_error("gnuplot failed on " + svg.string() + ": " + run.output);
  const std::string drawn = fs::exists(svg_file) ? read_file(svg_file) : std::string();
  std::string pdf = fs::exists(pdf_file) ? read_file(pdf_file) : std::string();
  if (!is_whole_svg(drawn) || !is_whole_pdf(pdf))
    throw input_error({.file = svg.string(), .wanted = "room for a figure", .found = "a full disk"});
  set_date(pdf);
  write_file_atomically(fs::path(svg).replace_extension(".gnuplot"), whole, readers);
  write_file_atomically(fs::path(svg).replace_extension(".pdf"), pdf, readers);
  write_file_atomically(svg, drawn, readers);
}

std::string gnuplot_text(const std::string& text) {
  std::string blank, safe;
  for (const char c : text) {
    const bool control = static_cast<unsigned char>(c) < ' ' || c == '\x7f';  // a NUL ends gnuplot's line
    blank += control ? ' ' : c;
  }
  for (char c : clean_text(blank, longest_label)) {
    if (c == '\\' || c == '"' || c == '`') c = c == '"' ? '\'' : ' ';
    if (std::string_view("^_@&~{}").find(c) != std::string_view::npos) safe += "\\\\";
    safe += c;
  }
  return safe;
}

}  // namespace seamline
