#include "analysis/report/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/report/figures/figure_parts.h"
#include "analysis/report/text/threshold_text.h"
#include "analysis/scores/level_words.h"
#include "support/files/atomic_file.h"
#include "support/files/gnuplot.h"

namespace seamline::analysis {

namespace {

constexpr std::size_t plot_colours = 6;  ///< of `plot_style` that the style sheet has dark variants of
constexpr const char* ink = plot_ink;    ///< `inline_svg` replaces it by the page's text colour

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
      ", \\\n     ${0} using 1:($2-$3):(0):(2*$3) with vectors nohead lc rgb '{1}' lw 1.2 notitle, \\\n"
      "     ${0} using 1:2 with linespoints lc rgb '{1}' lw 1.4 pt {2} ps 0.5 title \"{3}\"",
      block, style.colour, style.point, gnuplot_text(title));
}

/// One artifact: a line an object.
std::string object_plots(const Analysis& analysis, const LevelsDrawn& drawn, const ArtifactScores& scores) {
  std::vector<const ObjectCurve*> objects;
  for (const ObjectCurve& object : analysis.data.objects)
    if (object.artifact == scores.artifact && object.condition == scores.condition)
      objects.push_back(&object);
  std::string blocks, plots;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::string name = fmt::format("{}{}", word(scores.artifact), i + 1);
    blocks += data_block(name, drawn, objects[i]->cells, shift(i, objects.size()));
    plots += plot_line(name, i, fmt::format("{} {}", objects[i]->object_index, objects[i]->object));
  }
  return blocks + means_drawn(analysis).lines + plots + "\n";
}

/// One artifact of a study with conditions: a line each.
std::string condition_plots(const Analysis& analysis, const LevelsDrawn& drawn, const PanelCurves& panel) {
  std::string blocks, plots;
  for (std::size_t line = 0; line < panel.curves.size(); ++line) {
    const ArtifactScores& scores = analysis.data.artifacts[panel.curves[line]];
    const std::string name = fmt::format("{}{}", word(scores.artifact), line + 1);
    blocks += data_block(name, drawn, scores.cells, shift(line, panel.curves.size()));
    plots += plot_line(name, line, scores.condition);
  }
  return blocks + means_drawn(analysis).lines + plots + "\n";
}

/// Panels of means, two a row; `plots` is what each draws.
template <class Plots>
Figure draw_panels(const Analysis& analysis, Figure figure, const std::vector<PanelCurves>& panels,
                   const Plots& plots) {
  const LevelsDrawn drawn = levels_drawn(analysis.data);
  const PanelGrid grid = panel_grid(panels.size(), keyed_panel_px);
  const MeansDrawn means = means_drawn(analysis);
  std::string script = level_axis_script(drawn) + means.axis_below_key + multiplot(analysis);
  for (std::size_t i = 0; i < panels.size(); ++i)
    script += panel_frame(grid.panels[i], drawn, panels[i].title, means.words.mean) + plots(drawn, panels[i]);
  draw_figure(figure.svg, grid.height_px, script + "unset multiplot\n", Readers::owner);
  return figure;
}

std::string dotted_in_full(const MeansDrawn& means) {
  return means.words.rated ? "Dotted: 0.5, the level of the perceptual threshold (PT), and 1.0, slightly "
                             "noticeable (SN)."
                           : means.dotted;
}

Figure object_figure(const Analysis& analysis, const std::filesystem::path& folder) {
  const LevelWords words = level_words(analysis.data.axis);
  const MeansDrawn means = means_drawn(analysis);
  std::vector<PanelCurves> panels;
  for (std::size_t i = 0; i < analysis.data.artifacts.size(); ++i) {
    const ArtifactScores& scores = analysis.data.artifacts[i];
    panels.push_back({.title = artifact_title(scores.artifact, scores.condition), .curves = {i}});
  }
  return draw_panels(
      analysis,
      {.name = "fig6_objects",
       .title = means.words.title + " by artifact and object",
       .caption =
           fmt::format(
               "{} against {}, one panel an artifact and one line an object (1 left, 2 "
               "middle, 3 right); bars: one standard error of the mean over participants. Points of one "
               "{} are moved apart a little.",
               means.words.Mean, words.quantity, words.level) +
           " " + means.dotted + " After Fig. 6 of the paper. Data: " + source_sentence(analysis),
       .svg = folder / "fig6_objects.svg"},
      panels, [&](const LevelsDrawn& drawn, const PanelCurves& panel) {
        return object_plots(analysis, drawn, analysis.data.artifacts[panel.curves.front()]);
      });
}

Figure conditions_figure(const Analysis& analysis, const std::filesystem::path& folder) {
  const LevelWords words = level_words(analysis.data.axis);
  const MeansDrawn means = means_drawn(analysis);
  return draw_panels(
      analysis,
      {.name = "fig7_averages",
       .title = means.words.title + " by artifact and condition",
       .caption =
           fmt::format(
               "{} over objects against {}, one panel an artifact and one line a "
               "condition; bars: one standard error of the mean over participants. Points of one {} are "
               "moved apart a little.",
               means.words.Mean, words.quantity, words.level) +
           " " + dotted_in_full(means) + " Data: " + source_sentence(analysis),
       .svg = folder / "fig7_averages.svg"},
      panels_of_curves(analysis.data), [&](const LevelsDrawn& drawn, const PanelCurves& panel) {
        return condition_plots(analysis, drawn, panel);
      });
}

/// Where the name of a dotted line stands: above it, below it where the point of a curve at the axis' end
/// would be covered.
const char* beside_dotted(const NoticeabilityData& data, const LevelsDrawn& drawn, double height) {
  constexpr double letters_high = 0.35, point_high = 0.05;
  const bool rises = drawn.axis.noticeability == Direction::increasing;
  const double end = rises ? drawn.levels.back() : drawn.levels.front();
  for (const ArtifactScores& scores : data.artifacts)
    for (const CellMean& cell : scores.cells)
      if (cell.level == end && cell.mean > height + point_high && cell.mean < height + letters_high)
        return "0,-0.55";
  return "0,0.45";
}

/// Names of the dotted lines, at their left ends.
std::string line_labels(const MeansDrawn& means, const NoticeabilityData& data, const LevelsDrawn& drawn) {
  const LevelAxis& axis = drawn.axis;
  if (!means.words.rated)
    return fmt::format("set label 1 '{}' at {} offset 0,-0.55 textcolor rgb '{}' front\n",
                       means.words.chance_word,
                       beside_line(axis, 0.004, fmt::format("{:.6g}", means.words.chance)), ink);
  return fmt::format(
      "set label 1 'PT  0.5' at {1} offset {3} textcolor rgb '{0}' front\n"
      "set label 2 'SN  1.0' at {2} offset {4} textcolor rgb '{0}' front\n",
      ink, beside_line(axis, 0.004, "0.5"), beside_line(axis, 0.004, "1.0"), beside_dotted(data, drawn, 0.5),
      beside_dotted(data, drawn, 1.0));
}

Figure average_figure(const Analysis& analysis, const std::filesystem::path& folder) {
  const MeansDrawn means = means_drawn(analysis);
  Figure figure{
      .name = "fig7_averages",
      .title = means.words.title + " by artifact",
      .caption = fmt::format("{} over objects against {}; bars: one standard error of the mean over "
                             "participants.",
                             means.words.Mean, level_words(analysis.data.axis).quantity) +
                 " " + dotted_in_full(means) +
                 " After Fig. 7 of the paper. Data: " + source_sentence(analysis),
      .svg = folder / "fig7_averages.svg"};
  const LevelsDrawn drawn = levels_drawn(analysis.data);
  const PanelGrid grid = panel_grid(1, 240);
  std::string script = level_axis_script(drawn) + means.axis, plots;
  for (std::size_t i = 0; i < analysis.data.artifacts.size(); ++i) {
    const ArtifactScores& scores = analysis.data.artifacts[i];
    const std::string name(word(scores.artifact));
    script += data_block(name, drawn, scores.cells, shift(i, analysis.data.artifacts.size()));
    plots += plot_line(name, i, artifact_title(scores.artifact));
  }
  script += panel_frame(grid.panels.front(), drawn, source_text(analysis), means.words.mean) +
            fmt::format("set key top {}\n{}{}{}\n", key_side(drawn.axis),
                        line_labels(means, analysis.data, drawn), means.lines, plots);
  draw_figure(figure.svg, grid.height_px, script, Readers::owner);
  return figure;
}

void replace_all(std::string& text, const std::string& old, const std::string& fresh) {
  std::string out;
  std::size_t from = 0;
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, from)) {
    out.append(text, from, at - from).append(fresh);
    from = at + old.size();
  }
  if (from > 0) text = out.append(text, from);
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
       std::array{joint_curves_figure(analysis, folder), joint_scores_figure(analysis, folder),
                  people_figure(analysis, folder), psychometric_figure(analysis, numbers, folder),
                  guessing_figure(analysis, folder), order_figure(analysis, numbers, folder),
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
