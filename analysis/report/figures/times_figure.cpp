#include "analysis/report/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/figures/figure_parts.h"

namespace seamline::analysis {

namespace {

std::string block_of(const ResponseTimes& times, const LevelsDrawn& drawn, TimedAnswers which, double shift) {
  std::string block = fmt::format("${} << EOD\n", word(which));
  for (const ResponseTime& row : times.rows)
    if (!row.artifact && row.which == which)
      block += gap_before(drawn, row.level) +
               fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}\n", place_of(drawn, row.level, shift),
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
                    "lower to the upper quartile, all artifacts together. Points of one " +
                    level_word(analysis.data.axis) +
                    " are moved apart a little. Data: " + source_text(analysis) + ".",
                .svg = folder / "response_times.svg"};
  const LevelsDrawn drawn = levels_drawn(analysis.data);
  const PanelGrid grid = panel_grid(1, 230);
  std::string script =
      level_axis_script(drawn) +
      panel_frame(grid.panels.front(), drawn, source_text(analysis), "time to the choice (s)") +
      "set yrange [0:*]\nset offsets graph 0, 0, 0.05, 0\nset key top right\n";
  std::string plots;
  std::size_t index = 0;
  for (TimedAnswers which : {TimedAnswers::right, TimedAnswers::wrong}) {
    const PlotStyle style = plot_style(index++);
    if (!has(numbers.times, which)) continue;
    script += block_of(numbers.times, drawn, which, which == TimedAnswers::right ? -0.04 : 0.04);
    plots += fmt::format(
        "{0}${1} using 1:2:(0):($4-$2) with vectors nohead lc rgb '{2}' lw 1.2 notitle, \\\n     ${1} using "
        "1:3 with linespoints lc rgb '{2}' lw 1.4 pt {3} ps 0.5 title '{1} choices'",
        plots.empty() ? "plot " : ", \\\n     ", word(which), style.colour, style.point);
  }
  draw_figure(figure.svg, grid.height_px, script + plots + "\n", Readers::owner);
  return figure;
}

}  // namespace seamline::analysis
