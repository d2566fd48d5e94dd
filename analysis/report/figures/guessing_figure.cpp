#include "analysis/report/figures/guessing_figure.h"

#include <fmt/format.h>

#include "analysis/report/figures/figure_parts.h"
#include "analysis/report/text/threshold_text.h"

namespace seamline::analysis {

namespace {

std::string panel_script(const Analysis& analysis, const LevelsDrawn& drawn, std::size_t index,
                         const Panel& panel) {
  const CorrectedCurve& curve = analysis.guessing.curves[index];
  const PlotStyle style = plot_style(index);
  std::string block = fmt::format("$curve{} << EOD\n", index);
  for (std::size_t w = 0; w < curve.cells.size(); ++w)
    block += gap_before(drawn, curve.level[w]) +
             fmt::format("{} {:.6g} {:.6g}\n", place_of(drawn, curve.level[w]),
                         analysis.data.artifacts[index].cells[w].mean, curve.cells[w].noticeability);
  return block + "EOD\n" + margins(panel) +
         fmt::format(
             "set title \"{0}\" font ',16' textcolor rgb '{1}' offset 0,-0.3\n"
             "plot 0.5 with lines lc rgb '{1}' lw 1.2 dt '.' notitle, 1.0 with lines lc rgb '{1}' lw 1.2 dt "
             "'.' notitle, \\\n     {2:.6g} with lines lc rgb '{1}' lw 1.2 dt (12,6) title 'floor by "
             "guessing', \\\n"
             "     $curve{3} using 1:2 with linespoints lc rgb '{4}' lw 1.5 dt (6,4) pt 6 ps 0.75 title 'as "
             "answered', \\\n"
             "     $curve{3} using 1:3 with linespoints lc rgb '{4}' lw 2 pt {5} ps 0.75 title 'corrected'\n",
             gnuplot_text(artifact_title(curve.artifact)), plot_ink, analysis.guessing.floor, index,
             style.colour, style.point);
}

/// One artifact of a study with conditions: a line each.
std::string conditions_panel(const Analysis& analysis, const LevelsDrawn& drawn, Artifact artifact,
                             const Panel& panel) {
  std::string blocks, plots;
  std::size_t line = 0;
  for (std::size_t i = 0; i < analysis.guessing.curves.size(); ++i) {
    const CorrectedCurve& curve = analysis.guessing.curves[i];
    if (curve.artifact != artifact || curve.cells.empty()) continue;
    const PlotStyle style = plot_style(line++);
    blocks += fmt::format("$curve{} << EOD\n", i);
    for (std::size_t w = 0; w < curve.cells.size(); ++w)
      blocks += gap_before(drawn, curve.level[w]) +
                fmt::format("{:.8g} {:.6g} {:.6g}\n", place_of(drawn, curve.level[w]),
                            analysis.data.artifacts[i].cells[w].mean, curve.cells[w].noticeability);
    blocks += "EOD\n";
    plots += fmt::format(
        ", \\\n     $curve{0} using 1:2 with linespoints lc rgb '{1}' lw 1.2 dt (6,4) pt 6 ps 0.5 notitle"
        ", \\\n     $curve{0} using 1:3 with linespoints lc rgb '{1}' lw 2 pt {2} ps 0.75 title \"{3}\"",
        i, style.colour, style.point, gnuplot_text(curve.condition));
  }
  return blocks + margins(panel) +
         fmt::format(
             "set title \"{0}\" font ',16' textcolor rgb '{1}' offset 0,-0.3\n"
             "plot 0.5 with lines lc rgb '{1}' lw 1.2 dt '.' notitle, 1.0 with lines lc rgb '{1}' lw 1.2 dt "
             "'.' notitle, \\\n     {2:.6g} with lines lc rgb '{1}' lw 1.2 dt (12,6) title "
             "'guessed'{3}\n",
             gnuplot_text(artifact_title(artifact)), plot_ink, analysis.guessing.floor, plots);
}

}  // namespace

std::optional<Figure> guessing_figure(const Analysis& analysis, const std::filesystem::path& folder) {
  const GuessCorrection& guessing = analysis.guessing;
  if (guessing.curves.empty() || !guessing.guessers.known()) return std::nullopt;
  Figure figure{.name = "corrected_for_guessing",
                .title = "Noticeability corrected for guessing",
                .caption =
                    "Mean noticeability as answered (dashed, hollow) and corrected for guessing "
                    "(solid). Dashed line: what people who see nothing score on average. Dotted: 0.5 "
                    "(PT) and 1.0 (SN). Data: " +
                    source_sentence(analysis),
                .svg = folder / "corrected_for_guessing.svg"};
  const bool conditions = has_conditions(analysis.data);
  const std::vector<Artifact> artifacts = drawn_artifacts(analysis.data);
  const PanelGrid grid = panel_grid(conditions ? artifacts.size() : guessing.curves.size(), 420);
  const LevelsDrawn drawn = levels_drawn(analysis.data);
  std::string script = level_axis_script(drawn) + axis_labels(drawn.axis, "mean noticeability") +
                       "set ytics 0, 1, 4\nset yrange [0:4.15]\nset key top " +
                       std::string(key_side(drawn.axis)) + " font ',12'\n" + multiplot(analysis);
  for (std::size_t i = 0; i < grid.panels.size(); ++i)
    script += conditions ? conditions_panel(analysis, drawn, artifacts[i], grid.panels[i])
                         : panel_script(analysis, drawn, i, grid.panels[i]);
  draw_svg(figure.svg, grid.width_px, grid.height_px, script + "unset multiplot\n", Readers::owner);
  return figure;
}

}  // namespace seamline::analysis
