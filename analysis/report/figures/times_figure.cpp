#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/figures/figure_parts.h"

namespace seamline::analysis {

namespace {

std::string block_of(const ResponseTimes& times, TimedAnswers which, double shift_octaves) {
  std::string block = fmt::format("${} << EOD\n", word(which));
  for (const ResponseTime& row : times.rows)
    if (!row.artifact && row.which == which)
      block += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}\n", row.width_px * std::exp2(shift_octaves),
                           row.choice.lower_s, row.choice.median_s, row.choice.upper_s);
  return block + "EOD\n";
}

bool has(const ResponseTimes& times, TimedAnswers which) {
  return std::any_of(times.rows.begin(), times.rows.end(),
                     [&](const ResponseTime& row) { return !row.artifact && row.which == which; });
}

}  // namespace

std::optional<Figure> times_figure(const Analysis& analysis, const ReportNumbers& numbers,
                                   const std::filesystem::path& folder) {
  if (numbers.times.rows.empty()) return std::nullopt;
  Figure figure{.name = "response_times",
                .title = "Response times",
                .caption =
                    "Time from the image's onset to the choice: median over answers, bars from the "
                    "lower to the upper quartile, all artifacts together. Points of one width are "
                    "moved apart a little. Data: " +
                    source_text(analysis) + ".",
                .svg = folder / "response_times.svg"};
  std::string script = width_axis(tested_widths(analysis.data)) + axis_labels("time to the choice (s)") +
                       fmt::format(
                           "set yrange [0:*]\nset offsets graph 0, 0, 0.05, 0\nset key above horizontal "
                           "font ',13'\nset lmargin 8\nset rmargin 2\n"
                           "set title \"{}\" font ',13' textcolor rgb '{}'\n",
                           gnuplot_text(source_text(analysis)), plot_ink);
  std::string plots;
  std::size_t index = 0;
  for (TimedAnswers which : {TimedAnswers::right, TimedAnswers::wrong}) {
    const PlotStyle style = plot_style(index++);
    if (!has(numbers.times, which)) continue;
    script += block_of(numbers.times, which, which == TimedAnswers::right ? -0.04 : 0.04);
    plots += fmt::format(
        "{0}${1} using 1:2:(0):($4-$2) with vectors nohead lc rgb '{2}' lw 1.5 notitle, \\\n     ${1} using "
        "1:3 with linespoints lc rgb '{2}' lw 2 pt {3} ps 0.75 title '{1} choices'",
        plots.empty() ? "plot " : ", \\\n     ", word(which), style.colour, style.point);
  }
  draw_svg(figure.svg, 900, 480, script + plots + "\n", Readers::owner);
  return figure;
}

}  // namespace seamline::analysis
