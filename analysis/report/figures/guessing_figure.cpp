#include "analysis/report/figures/figures.h"

#include <fmt/format.h>

#include "analysis/report/figures/figure_parts.h"
#include "analysis/report/text/threshold_text.h"

namespace seamline::analysis {

namespace {

std::string corrected_block(const Analysis& analysis, const LevelsDrawn& drawn, std::size_t index) {
  const CorrectedCurve& curve = analysis.guessing.curves[index];
  std::string block = fmt::format("$curve{} << EOD\n", index);
  for (std::size_t w = 0; w < curve.cells.size(); ++w)
    block += gap_before(drawn, curve.level[w]) +
             fmt::format("{:.8g} {:.6g} {:.6g}\n", place_of(drawn, curve.level[w]),
                         analysis.data.artifacts[index].cells[w].mean, curve.cells[w].noticeability);
  return block + "EOD\n";
}

/// As answered and corrected; each condition's line where there are several.
std::string corrected_plots(const Analysis& analysis, const LevelsDrawn& drawn, const PanelCurves& panel,
                            std::size_t place) {
  const bool conditions = has_conditions(analysis.data);
  std::string blocks, plots;
  std::size_t line = conditions ? 0 : place;
  for (const std::size_t i : panel.curves) {
    const CorrectedCurve& curve = analysis.guessing.curves[i];
    if (curve.cells.empty()) continue;
    const PlotStyle style = plot_style(line++);
    blocks += corrected_block(analysis, drawn, i);
    plots += fmt::format(
        ", \\\n     $curve{0} using 1:2 with linespoints lc rgb '{1}' lw 1 dt (6,4) pt {2} ps 0.5 {3}"
        ", \\\n     $curve{0} using 1:3 with linespoints lc rgb '{1}' lw 1.4 pt {4} ps 0.5 title \"{5}\"",
        i, style.colour, style.point - 1, conditions ? "notitle" : "title 'as answered'", style.point,
        conditions ? gnuplot_text(curve.condition) : "corrected");
  }
  return blocks + means_drawn(analysis).lines +
         fmt::format(", \\\n     {:.6g} with lines lc rgb '{}' lw 1 dt (12,6) title 'guessed'{}\n",
                     analysis.guessing.floor, plot_ink, plots);
}

}  // namespace

std::optional<Figure> guessing_figure(const Analysis& analysis, const std::filesystem::path& folder) {
  const GuessCorrection& guessing = analysis.guessing;
  if (guessing.curves.empty() || !guessing.guessers.known()) return std::nullopt;
  const MeansDrawn means = means_drawn(analysis);
  Figure figure{.name = "corrected_for_guessing",
                .title = means.words.title + " corrected for guessing",
                .caption = means.words.Mean +
                           " as answered (dashed, hollow) and corrected for guessing "
                           "(solid). Dashed line: what people who see nothing score on average. " +
                           means.dotted + " Data: " + source_sentence(analysis),
                .svg = folder / "corrected_for_guessing.svg"};
  const std::vector<PanelCurves> panels = panels_of_curves(analysis.data);
  const PanelGrid grid = panel_grid(panels.size(), keyed_panel_px);
  const LevelsDrawn drawn = levels_drawn(analysis.data);
  std::string script = level_axis_script(drawn) + means.axis_below_key + multiplot(analysis);
  for (std::size_t i = 0; i < panels.size(); ++i)
    script += panel_frame(grid.panels[i], drawn, panels[i].title, means.words.mean) +
              corrected_plots(analysis, drawn, panels[i], i);
  draw_figure(figure.svg, grid.height_px, script + "unset multiplot\n", Readers::owner);
  return figure;
}

}  // namespace seamline::analysis
