#include "sets/pages/errors_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "sets/pages/page_frame.h"
#include "sets/set_errors.h"
#include "support/files/atomic_file.h"
#include "support/files/confined_path.h"
#include "support/files/gnuplot.h"
#include "support/running/progress.h"
#include "support/text/counted.h"
#include "support/text/error.h"
#include "support/text/html.h"

namespace seamline::renderer {
namespace {

constexpr int width_px = 900, height_px = 520;

/// Point types of gnuplot: circle, square, triangle, diamond, each hollow and filled.
struct PointType {
  int hollow, filled;
};
constexpr std::array<PointType, 4> point_types = {{{6, 7}, {4, 5}, {8, 9}, {12, 13}}};

std::string block_name(Artifact artifact, const char* what) {
  return fmt::format("${}_{}", word(artifact), what);
}

/// A data block of one artifact; empty when there is nothing in it.
template <class Error>
std::string block(const SetErrors& errors, Artifact artifact, const char* what, const Error& error) {
  std::string lines;
  for (const StimulusErrorRow& row : errors.rows) {
    const std::optional<double> value = error(row);
    if (row.artifact != artifact || !row.seconds || !value || !(*value > 0) || !(*row.seconds > 0)) continue;
    lines += fmt::format("{:.6g} {:.6g}\n", *row.seconds, *value);
  }
  return lines.empty() ? "" : fmt::format("{} << EOD\n{}EOD\n", block_name(artifact, what), lines);
}

/// Smallest and largest of what is drawn, a third beyond both.
struct Range {
  double from = 1.0 / 255, to = 1.0 / 255;
  void add(double value) {
    if (!(value > 0)) return;
    from = std::min(from, value / 1.33);
    to = std::max(to, value * 1.33);
  }
};

/// Labels that a narrow range of a logarithmic axis still has some of.
std::string ticks() {
  std::string list;
  for (const char* decade : {"1e-4", "1e-3", "1e-2", "1e-1", "1", "10", "100", "1000"})
    for (const char* step : {"1", "2", "3", "5"})
      list += fmt::format("{}{}*{}", list.empty() ? "" : ", ", step, decade);
  return "(" + list + ")";
}

/// Both axes: seconds and errors of every stimulus.
std::string axes(const SetErrors& errors) {
  Range seconds{1e30, 0}, error;
  error.add(1.0 / 255);
  for (const StimulusErrorRow& row : errors.rows) {
    seconds.add(row.seconds.value_or(0));
    error.add(row.estimated.value_or(0));
    if (row.measured) error.add(row.measured->rmse);
  }
  return fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\nset xtics {}\nset ytics {}\n", seconds.from,
                     seconds.to, error.from, error.to, ticks(), ticks());
}

std::string script(const SetErrors& errors) {
  std::string data, plots;
  std::size_t index = 0;
  for (const Artifact artifact : every_artifact) {
    const std::string estimated =
        block(errors, artifact, "estimated", [](const StimulusErrorRow& row) { return row.estimated; });
    const std::string measured =
        block(errors, artifact, "true", [](const StimulusErrorRow& row) -> std::optional<double> {
          return row.measured ? std::optional(row.measured->rmse) : std::nullopt;
        });
    if (estimated.empty() && measured.empty()) continue;
    const PointType type = point_types[index % point_types.size()];
    const auto plot = [&](const char* what, int point) {
      plots += fmt::format("{} with points pointtype {} pointsize 0.9 linecolor '{}' title '{}, {}', \\\n",
                           block_name(artifact, what), point, plot_style(index).colour, word(artifact), what);
    };
    if (!estimated.empty()) plot("estimated", type.hollow);
    if (!measured.empty()) plot("true", type.filled);
    data += estimated + measured;
    ++index;
  }
  if (plots.empty()) return "";
  return fmt::format(
      "{}set logscale xy\nset border 3 linecolor '{}'\nset tics nomirror textcolor '{}'\nset grid linecolor "
      "'#dddddd' linetype 1 linewidth 0.5\nset key outside right top\nset xlabel 'seconds of the stimulus'\n"
      "set ylabel 'RMSE (display units)'\nset format y '%g'\nset format x '%g'\n{}plot {}1.0/255 with lines "
      "dashtype 3 linecolor '{}' title 'one 8-bit "
      "step'\n",
      data, plot_ink, plot_ink, axes(errors), plots, plot_ink);
}

/// Error against seconds, log-log, as SVG text to put into a page: one colour an artifact, estimated hollow,
/// true filled, one 8-bit step dotted. None when there is no gnuplot, or nothing to draw.
std::optional<std::string> errors_figure(const SetErrors& errors) {
  const std::string text = script(errors);
  if (text.empty()) return std::nullopt;
  try {
    require_gnuplot();
  } catch (const InputError&) {
    return std::nullopt;
  }
  const std::string svg = drawn_svg(width_px, height_px, text);
  return svg.substr(std::min(svg.find("<svg"), svg.size()));
}

namespace fs = std::filesystem;

std::string number(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "&ndash;";
}

std::string summary(const SetErrors& e) {
  const SetSeconds& s = e.seconds;
  std::string text = fmt::format(
      "<p>{} of {} x {} pixels; {} of work on {} ({}), {:.0f} million rays.</p>\n"
      "<table><thead><tr><th>Where the time went</th><th>seconds</th><th>share</th></tr></thead><tbody>",
      counted(e.rows.size(), "stimulus", "stimuli"), e.width_px, e.height_px, duration_text(s.total()),
      counted(e.threads, "thread"), html_escape(e.machine), e.rays * 1e-6);
  const auto line = [&](const char* what, double seconds) {
    text += fmt::format("<tr><td>{}</td><td>{:.1f}</td><td>{:.0f} %</td></tr>", what, seconds,
                        s.total() > 0 ? 100 * seconds / s.total() : 0.0);
  };
  line("references, and what their scenes share", s.references);
  line("truth of each object", s.truth);
  line("depth maps and meshes", s.meshes);
  line("stimuli", s.stimuli);
  text += fmt::format("</tbody><tfoot><tr><td>total</td><td>{:.1f}</td><td></td></tr></tfoot></table>\n",
                      s.total());
  const int measured = e.measured();
  if (measured == 0)
    return text +
           "<p>The true error of no stimulus was measured (<code>seamline render --true-error "
           "PATTERN</code> does it).</p>\n";
  return text + fmt::format(
                    "<p>The true error of {0} of {1} stimuli was measured. It exceeds the estimate in {2} of "
                    "these {0} ({3:.0f} %), in {4} by more than twice its own standard error.</p>\n",
                    measured, e.rows.size(), e.above_estimate(), 100.0 * e.above_estimate() / measured,
                    e.clearly_above_estimate());
}

std::string figure(const SetErrors& errors) {
  const std::optional<std::string> svg = errors_figure(errors);
  if (!svg)
    return "<p>There is no figure: gnuplot (Debian package gnuplot-nox) was not found, or no error is "
           "known.</p>\n";
  return "<figure>" + *svg +
         "<figcaption>Error against the seconds of a stimulus' own pass. Hollow: as estimated while "
         "rendering, noise and bias. Filled: against a long reference. Dotted: one 8-bit step, "
         "1/255.</figcaption></figure>\n";
}

std::string row_text(const StimulusErrorRow& row) {
  const auto& m = row.measured;
  const bool above = m && row.estimated && m->rmse > *row.estimated;
  return fmt::format(
      "<tr><td>{}</td><td>{}</td><td>{:.2f}</td><td>{}</td><td>{}</td><td>{}</td><td{}>{}</td><td>{}</td>",
      html_escape(row.id), number(row.seconds, 2), row.rays * 1e-6, row.spp, number(row.estimated, 4),
      number(row.estimated_worst_tile, 4), above ? " class=\"above\"" : "",
      m ? fmt::format("{:.4f} &plusmn; {:.4f}", m->rmse, m->standard_error) : "&ndash;",
      m ? fmt::format("{:.4f}", m->worst_tile) : "&ndash;");
}

std::string paragraphs(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& said : sentences) text += "<p>" + html_escape(said) + "</p>\n";
  return text;
}

std::string table(const SetErrors& errors) {
  std::string text =
      "<div class=\"scroll\"><table><thead><tr><th>stimulus</th><th>seconds</th><th>million rays</th>"
      "<th>samples a pixel</th><th>estimated error</th><th>in the worst tile</th><th>true error</th>"
      "<th>in the worst tile</th>";
  if (errors.of_clips) text += "<th>of changes between frames</th>";
  text += "</tr></thead><tbody>\n";
  std::int64_t rays = 0;
  for (const StimulusErrorRow& row : errors.rows) {
    text += row_text(row) + (errors.of_clips ? "<td>" + number(row.change, 4) + "</td>" : "") + "</tr>\n";
    rays += row.rays;
  }
  return text + fmt::format(
                    "</tbody><tfoot><tr><td>{}</td><td>{:.1f}</td><td>{:.1f}</td><td></td><td></td>"
                    "<td></td><td></td><td></td>{}</tr></tfoot></table></div>\n",
                    counted(errors.rows.size(), "stimulus", "stimuli"), errors.seconds.stimuli, rays * 1e-6,
                    errors.of_clips ? "<td></td>" : "");
}

/// Of each artifact the measured stimulus with the largest worst tile, its picture inside the page.
std::string worst_tiles(const fs::path& set_folder, const SetErrors& errors) {
  std::map<Artifact, const StimulusErrorRow*> worst;
  for (const StimulusErrorRow& row : errors.rows) {
    if (!row.measured) continue;
    const StimulusErrorRow*& known = worst[row.artifact];
    if (known == nullptr || row.measured->worst_tile > known->measured->worst_tile) known = &row;
  }
  std::string text;
  for (const auto& [artifact, row] : worst) {
    const fs::path picture = set_folder / ("worst-tile-" + row->id + ".png");
    if (!lies_below(picture, set_folder)) continue;  // there is none, or a link to what is not of the set
    text += fmt::format(
        "<figure><img alt=\"worst tile of {0}\" src=\"data:image/png;base64,{1}\"><figcaption>{2}: the worst "
        "tile of {0}. Left as rendered, middle the path reference with {3} samples a pixel, right their "
        "difference times 8 about mid-grey; the reference's own noise is in the two last.</figcaption>"
        "</figure>\n",
        html_escape(row->id), base64(read_file(picture)), word(artifact), row->measured->reference_spp);
  }
  return text.empty() ? "" : "<h2>Worst tiles</h2>\n" + text;
}

}  // namespace

void write_errors_page(const fs::path& set_folder) {
  const SetErrors errors = read_set_errors(set_folder);
  write_file_atomically(set_folder / "errors.csv", csv_text(errors_table(errors)));
  write_file_atomically(
      set_folder / "errors.html",
      html_page(
          "Errors and run time: " + html_escape(errors.study_name),
          summary(errors) + "<h2>Error against run time</h2>\n" + figure(errors) +
              "<h2>Every stimulus</h2>\n<p class=\"soft\">Errors are root mean squares in display units (0 "
              "to 1; one 8-bit step is 0.0039). Seconds and rays are of the stimulus' own pass. The true "
              "error is against the path estimator with another seed, without that reference's noise, plus "
              "or minus its standard error; the rounding to 8 bits (0.0011) is part of it. A true error "
              "above its estimate is in orange.</p>\n" +
              paragraphs(sentences_on_rare_light(errors)) +
              paragraphs(sentences_on_noisy_references(errors)) + paragraphs(sentences_on_changes(errors)) +
              table(errors) + worst_tiles(set_folder, errors)));
}

}  // namespace seamline::renderer
