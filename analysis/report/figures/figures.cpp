#include "analysis/report/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/report/figures/figure_parts.h"
#include "analysis/report/figures/guessing_figure.h"
#include "analysis/report/figures/psychometric_figure.h"
#include "analysis/report/figures/times_figure.h"
#include "analysis/report/text/threshold_text.h"
#include "analysis/scores/level_words.h"
#include "support/files/atomic_file.h"
#include "support/files/gnuplot.h"

namespace seamline::analysis {

namespace {

constexpr std::size_t plot_colours = 6;  ///< of `plot_style` that the style sheet has dark variants of
constexpr const char* ink = plot_ink;    ///< `inline_svg` replaces it by the page's text colour

std::string axes(const Analysis& analysis) {
  return level_axis_script(levels_drawn(analysis.data)) +
         axis_labels(analysis.data.axis, "mean noticeability") +
         "set ytics 0, 1, 4\nset mytics 2\nset yrange [0:4.15]\n";
}

/// A data block `level mean sem`, the levels moved so that error bars of several lines stay apart.
std::string data_block(const std::string& name, const LevelsDrawn& drawn, const std::vector<CellMean>& cells,
                       double shift) {
  std::string block = fmt::format("${} << EOD\n", name);
  for (const CellMean& cell : cells)
    block += gap_before(drawn, cell.level) + fmt::format("{:.6g} {:.6g} {:.6g}\n",
                                                         place_of(drawn, cell.level, shift), cell.mean,
                                                         std::isnan(cell.sem) ? 0.0 : cell.sem);
  return block + "EOD\n";
}

/// How far line `index` of `count` is moved, in octaves.
double shift(std::size_t index, std::size_t count) {
  return 0.06 * (static_cast<double>(index) - (static_cast<double>(count) - 1) / 2);
}

std::string plot_line(const std::string& block, std::size_t index, const std::string& title) {
  const PlotStyle style = plot_style(index);
  return fmt::format(
      "${0} using 1:($2-$3):(0):(2*$3) with vectors nohead lc rgb '{1}' lw 1.5 notitle, \\\n"
      "     ${0} using 1:2 with linespoints lc rgb '{1}' lw 2 pt {2} ps 0.75 title \"{3}\"",
      block, style.colour, style.point, gnuplot_text(title));
}

std::string object_panel(const Analysis& analysis, const ArtifactScores& scores) {
  const Artifact artifact = scores.artifact;
  const LevelsDrawn drawn = levels_drawn(analysis.data);
  std::vector<const ObjectCurve*> objects;
  for (const ObjectCurve& object : analysis.data.objects)
    if (object.artifact == artifact && object.condition == scores.condition) objects.push_back(&object);
  std::string blocks, plots;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::string name = fmt::format("{}{}", word(artifact), i + 1);
    blocks += data_block(name, drawn, objects[i]->cells, shift(i, objects.size()));
    const std::string title = fmt::format("{} {}", objects[i]->object_index, objects[i]->object);
    plots += (i == 0 ? "plot " : ", \\\n     ") + plot_line(name, i, title);
  }
  return blocks +
         fmt::format("set title \"{}\" font ',16' textcolor rgb '{}' offset 0,-0.3\n",
                     gnuplot_text(artifact_title(artifact, scores.condition)), ink) +
         plots + "\n";
}

/// One artifact of a study with conditions: a line each.
std::string conditions_panel(const Analysis& analysis, Artifact artifact) {
  const LevelsDrawn drawn = levels_drawn(analysis.data);
  const std::size_t count = analysis.data.conditions.size();
  std::string blocks, plots;
  std::size_t line = 0;
  for (const ArtifactScores& scores : analysis.data.artifacts) {
    if (scores.artifact != artifact) continue;
    const std::string name = fmt::format("{}{}", word(artifact), line + 1);
    blocks += data_block(name, drawn, scores.cells, shift(line, count));
    plots += ", \\\n     " + plot_line(name, line++, scores.condition);
  }
  return blocks + fmt::format(
                      "set title \"{0}\" font ',16' textcolor rgb '{1}' offset 0,-0.3\n"
                      "plot 0.5 with lines lc rgb '{1}' lw 1.2 dt '.' notitle, 1.0 with lines lc rgb '{1}' "
                      "lw 1.2 dt '.' "
                      "notitle{2}\n",
                      gnuplot_text(artifact_title(artifact)), ink, plots);
}

/// Panels in rows of two, margins in pixels, so that labels keep their room whatever the number of panels.
Figure draw_panels(const Analysis& analysis, Figure figure, const std::vector<std::string>& panel_scripts) {
  const std::size_t panels = panel_scripts.size();
  const std::size_t columns = panels > 1 ? 2 : 1, rows = (panels + columns - 1) / columns;
  const double width_px = columns == 1 ? 640 : 1080, height_px = 30 + 400.0 * static_cast<double>(rows);
  std::string script =
      axes(analysis) +
      fmt::format(
          "set multiplot layout {},{} title \"{}\" font ',13' textcolor rgb '{}' "
          "margins {:.4f},{:.4f},{:.4f},{:.4f} spacing {:.4f},{:.4f}\nset key top {} font ',12'\n",
          rows, columns, gnuplot_text(source_text(analysis)), ink, 66 / width_px, 1 - 14 / width_px,
          76 / height_px, 1 - 78 / height_px, 92 / width_px, 128 / height_px, key_side(analysis.data.axis));
  for (const std::string& panel : panel_scripts) script += panel;
  draw_svg(figure.svg, static_cast<int>(width_px), static_cast<int>(height_px), script + "unset multiplot\n",
           Readers::owner);
  return figure;
}

Figure object_figure(const Analysis& analysis, const std::filesystem::path& folder) {
  const LevelWords words = level_words(analysis.data.axis);
  std::vector<std::string> panels;
  for (const ArtifactScores& scores : analysis.data.artifacts)
    panels.push_back(object_panel(analysis, scores));
  return draw_panels(
      analysis,
      {.name = "fig6_objects",
       .title = "Noticeability by artifact and object",
       .caption =
           fmt::format(
               "Mean noticeability against {}, one panel an artifact and one line an object (1 left, 2 "
               "middle, 3 right); bars: one standard error of the mean over participants. Points of one "
               "{} are moved apart a little.",
               words.quantity, words.level) +
           " After Fig. 6 of the paper. Data: " + source_sentence(analysis),
       .svg = folder / "fig6_objects.svg"},
      panels);
}

Figure conditions_figure(const Analysis& analysis, const std::filesystem::path& folder) {
  const LevelWords words = level_words(analysis.data.axis);
  std::vector<std::string> panels;
  for (const Artifact artifact : drawn_artifacts(analysis.data))
    panels.push_back(conditions_panel(analysis, artifact));
  return draw_panels(
      analysis,
      {.name = "fig7_averages",
       .title = "Noticeability by artifact and condition",
       .caption =
           fmt::format(
               "Mean noticeability over objects against {}, one panel an artifact and one line a "
               "condition; bars: one standard error of the mean over participants. Points of one {} are "
               "moved apart a little.",
               words.quantity, words.level) +
           " Dotted: 0.5, the level of the perceptual threshold (PT), and 1.0, slightly noticeable (SN). "
           "Data: " +
           source_sentence(analysis),
       .svg = folder / "fig7_averages.svg"},
      panels);
}

Figure average_figure(const Analysis& analysis, const std::filesystem::path& folder) {
  Figure figure{
      .name = "fig7_averages",
      .title = "Noticeability by artifact",
      .caption =
          fmt::format("Mean noticeability over objects against {}; bars: one standard error of the mean over "
                      "participants.",
                      level_words(analysis.data.axis).quantity) +
          " Dotted: 0.5, the level of the perceptual threshold (PT), and 1.0, slightly "
          "noticeable (SN). After Fig. 7 of the paper. Data: " +
          source_sentence(analysis),
      .svg = folder / "fig7_averages.svg"};
  const LevelsDrawn drawn = levels_drawn(analysis.data);
  std::string script = axes(analysis), plots;
  for (std::size_t i = 0; i < analysis.data.artifacts.size(); ++i) {
    const ArtifactScores& scores = analysis.data.artifacts[i];
    const std::string name(word(scores.artifact));
    script += data_block(name, drawn, scores.cells, shift(i, analysis.data.artifacts.size()));
    plots += ", \\\n     " + plot_line(name, i, artifact_title(scores.artifact));
  }
  script += fmt::format(
      "set title \"{0}\" font ',13' textcolor rgb '{1}'\nset key top {3} font ',13'\nset lmargin 7\nset "
      "rmargin 2\n"
      "set label 1 'PT  0.5' at {4} offset 0,0.45 font ',11' textcolor rgb '{1}' "
      "front\n"
      "set label 2 'SN  1.0' at {5} offset 0,0.45 font ',11' textcolor rgb '{1}' "
      "front\n"
      "plot 0.5 with lines lc rgb '{1}' lw 1.2 dt '.' notitle, 1.0 with lines lc rgb '{1}' lw 1.2 dt '.' "
      "notitle{2}\n",
      gnuplot_text(source_text(analysis)), ink, plots, key_side(drawn.axis),
      beside_line(drawn.axis, 0.004, "0.5"), beside_line(drawn.axis, 0.004, "1.0"));
  draw_svg(figure.svg, 900, 540, script, Readers::owner);
  return figure;
}

void replace_all(std::string& text, const std::string& old, const std::string& fresh) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + fresh.size()))
    text.replace(at, old.size(), fresh);
}

}  // namespace

std::vector<Figure> draw_figures(const Analysis& analysis, const ReportNumbers& numbers,
                                 const std::filesystem::path& folder) {
  std::vector<Figure> figures;
  const bool conditions = numbers.conditions;
  if (!analysis.adaptive)
    figures.push_back(conditions ? conditions_figure(analysis, folder) : average_figure(analysis, folder));
  if (analysis.adaptive || !conditions) figures.push_back(object_figure(analysis, folder));
  for (std::optional<Figure>& figure :
       std::array{psychometric_figure(analysis, numbers, folder), guessing_figure(analysis, folder),
                  times_figure(analysis, numbers, folder)})
    if (figure) figures.push_back(std::move(*figure));
  return figures;
}

std::string inline_svg(const Figure& figure) {
  std::string svg = read_file(figure.svg);
  svg.erase(0, std::min(svg.find("<svg"), svg.size()));
  for (const char* quote : {"'", "\""}) {
    replace_all(svg, fmt::format("id={}", quote), fmt::format("id={}{}-", quote, figure.name));
    replace_all(svg, fmt::format("href={}#", quote), fmt::format("href={}#{}-", quote, figure.name));
  }
  replace_all(svg, "url(#", "url(#" + figure.name + "-");
  for (const char* plain : {"black", "white"})
    replace_all(svg, fmt::format("color=\"{}\"", plain), "color=\"inherit\"");
  replace_all(svg, "rgb( 51,  51,  52)", "currentColor");
  replace_all(svg, "rgb(51,51,52)", "currentColor");
  replace_all(svg, ink, "currentColor");
  // Lines take the page's colours: on a dark page each is a lighter one of the same hue (page_style.cpp).
  for (std::size_t i = 0; i < plot_colours; ++i) {
    const std::string colour = plot_style(i).colour;
    const auto part = [&](std::size_t at) { return std::stoi(colour.substr(at, 2), nullptr, 16); };
    const std::string variable = fmt::format("var(--line-{})", i);
    replace_all(svg, fmt::format("rgb({:3d}, {:3d}, {:3d})", part(1), part(3), part(5)), variable);
    replace_all(svg, fmt::format("rgb({},{},{})", part(1), part(3), part(5)), variable);
  }
  return svg;
}

}  // namespace seamline::analysis
