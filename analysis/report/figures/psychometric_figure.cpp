#include "analysis/report/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/figures/figure_parts.h"
#include "analysis/report/text/threshold_text.h"
#include "analysis/scores/level_words.h"

namespace seamline::analysis {

namespace {

std::string block_of_levels(const std::string& name, const ChoiceCurve& curve, const LevelsDrawn& drawn,
                            std::int64_t most_trials) {
  std::string block = fmt::format("${} << EOD\n", name);
  for (const LevelResidual& level : curve.goodness.residuals) {
    const double n = level.counts.trials;
    block += fmt::format(
        "{:.6g} {:.6g} {:.4g} {:.6g}\n", place_of(drawn, level.counts.level), level.counts.share(),
        std::max(0.25, 0.8 * std::sqrt(n / static_cast<double>(most_trials))), level.deviance_residual);
  }
  if (curve.apart)  // no part of the sigmoid: it has no residual
    block += fmt::format("{:.6g} {:.6g} {:.4g} NaN\n", place_of(drawn, 0), curve.apart->k / curve.apart->n,
                         std::max(0.25, 0.8 * std::sqrt(curve.apart->n / static_cast<double>(most_trials))));
  return block + "EOD\n";
}

std::string block_of_band(const std::string& name, const ChoiceCurve& curve) {
  std::string block = fmt::format("${} << EOD\n", name);
  for (const BandPoint& point : curve.band)
    block += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}\n", point.level, point.fitted, point.low, point.high);
  return block + "EOD\n";
}

/// The threshold with its interval, at the height where the curve has it; cut at the axis' ends.
std::string threshold_mark(const ChoiceCurve& curve, const LevelsDrawn& drawn, const char* colour,
                           std::size_t number = 1) {
  if (!has_threshold(curve)) return "";
  const PooledFit& pooled = *curve.pooled;
  const double height = fitted_probability(pooled.fit, pooled.fit.function.threshold);
  const Interval range = drawn_range(drawn);
  const double low = std::max(pooled.threshold_ci95.low, range.low),
               high = std::min(pooled.threshold_ci95.high, range.high);
  return fmt::format(
      "set arrow {} from {:.6g},{:.6g} to {:.6g},{:.6g} heads size screen 0.004,90 front lc rgb '{}' lw "
      "1.4\n",
      number, low, height, high, height, colour);
}

/// The word of chance stands below its line, above it where the axis would strike it through.
const char* beside_chance(const TaskWords& words) {
  constexpr double letters_high = 0.2;  // of an axis from 0 to 1
  return words.chance < letters_high ? "0,0.55" : "0,-0.55";
}

/// Where the line of chance stands; of three alternatives as it always was written.
std::string chance_value(const TaskWords& words) {
  return words.of_three ? "1.0/3" : fmt::format("{:.6g}", words.chance);
}

std::string chance_height(const TaskWords& words) {
  return fmt::format("{:.4f}", words.chance);
}

double largest_residual(const std::vector<ChoiceCurve>& curves) {
  double largest = 2.6;
  for (const ChoiceCurve& curve : curves)
    for (const LevelResidual& level : curve.goodness.residuals)
      largest = std::max(largest, 1.15 * std::abs(level.deviance_residual));
  return largest;
}

std::string panel_script(const ChoiceCurve& curve, const Panel& panel, std::size_t index, double residual,
                         const LevelsDrawn& drawn, const TaskWords& words) {
  const std::string levels = fmt::format("levels{}", index), band = fmt::format("band{}", index);
  const char* colour = plot_style(index).colour;
  std::int64_t most_trials = 1;
  for (const LevelResidual& level : curve.goodness.residuals)
    most_trials = std::max(most_trials, level.counts.trials);
  const double split = panel.bottom + 0.26 * (panel.top - panel.bottom);
  const double gap = 0.035 * (panel.top - panel.bottom);
  Panel above = panel, below = panel;
  above.bottom = split + gap;
  below.top = split - gap;
  return block_of_levels(levels, curve, drawn, most_trials) + block_of_band(band, curve) +
         panel_frame(above, drawn, artifact_title(curve.artifact), words.right_choices) +
         "unset xlabel\nunset arrow\nset yrange [0:1.04]\nset ytics 0, 0.2, 1\n" + level_tics(drawn, 0) +
         threshold_mark(curve, drawn, colour) +
         fmt::format(
             "set label 1 '{6}' at {4} offset {7} textcolor rgb '{0}'\n"
             "plot {5} with lines lc rgb '{0}' lw 1 dt '.' notitle, \\\n"
             "     ${1} using 1:3:4 with filledcurves fs transparent solid 0.22 noborder lc rgb '{2}' "
             "notitle, \\\n"
             "     ${1} using 1:2 with lines lc rgb '{2}' lw 1.4 notitle, \\\n"
             "     ${3} using 1:2:3 with points pt 7 ps variable lc rgb '{2}' notitle\n",
             plot_ink, band, colour, levels, beside_line(drawn.axis, 0.012, chance_height(words)),
             chance_value(words), words.chance_word, beside_chance(words)) +
         panel_frame(below, drawn, "", "residual") +
         fmt::format(
             "unset title\nunset label 1\nunset arrow\nset yrange [-{1:.3f}:{1:.3f}]\nset ytics -{2}, {2}, "
             "{2}\n"
             "plot 0 with lines lc rgb '{0}' lw 0.8 notitle, \\\n"
             "     1.96 with lines lc rgb '{0}' lw 0.8 dt '.' notitle, -1.96 with lines lc rgb '{0}' lw 0.8 "
             "dt "
             "'.' notitle, \\\n"
             "     ${3} using 1:4 with impulses lc rgb '{4}' lw 1.4 notitle, \\\n"
             "     ${3} using 1:4 with points pt 7 ps 0.4 lc rgb '{4}' notitle\n",
             plot_ink, residual, residual >= 8 ? 4 : 2, levels, colour);
}

/// One artifact of a study with conditions: a curve each, and no residuals.
std::string condition_panel(const ReportNumbers& numbers, const PanelCurves& of, const Panel& panel,
                            const LevelsDrawn& drawn, const TaskWords& words) {
  std::string blocks, marks = "unset arrow\n", plots;
  std::int64_t most_trials = 1;
  for (const ChoiceCurve& curve : numbers.choices)
    for (const LevelResidual& level : curve.goodness.residuals)
      most_trials = std::max(most_trials, level.counts.trials);
  std::size_t line = 0;
  for (const std::size_t i : of.curves) {
    const ChoiceCurve& curve = numbers.choices[i];
    if (!curve.pooled) continue;
    const char* colour = plot_style(line++).colour;
    const std::string levels = fmt::format("levels{}", i), band = fmt::format("band{}", i);
    blocks += block_of_levels(levels, curve, drawn, most_trials) + block_of_band(band, curve);
    marks += threshold_mark(curve, drawn, colour, line);
    plots += fmt::format(
        ", \\\n     ${0} using 1:3:4 with filledcurves fs transparent solid 0.15 noborder lc rgb '{1}' "
        "notitle, \\\n     ${0} using 1:2 with lines lc rgb '{1}' lw 1.4 title \"{2}\", \\\n"
        "     ${3} using 1:2:3 with points pt 7 ps variable lc rgb '{1}' notitle",
        band, colour, gnuplot_text(curve.condition), levels);
  }
  return blocks + panel_frame(panel, drawn, of.title, words.right_choices) +
         fmt::format(
             "set yrange [0:1.04]\nset ytics 0, 0.2, 1\nset key top {1}\n{2}"
             "set label 1 '{6}' at {3} offset {7} textcolor rgb '{0}'\n"
             "plot {5} with lines lc rgb '{0}' lw 1 dt '.' notitle{4}\n",
             plot_ink, key_side(drawn.axis), marks, beside_line(drawn.axis, 0.012, chance_height(words)),
             plots, chance_value(words), words.chance_word, beside_chance(words));
}

std::string caption_of(const Analysis& analysis, bool conditions) {
  const LevelWords words = level_words(analysis.data.axis);
  const TaskWords task = task_words(analysis);
  return fmt::format(
             "{2} against {0}: points (area by number of answers), fitted psychometric "
             "function with a 95 % band (bootstrap over participants, {1} by {1}), and the threshold's 95 % "
             "interval as a bar. ",
             words.quantity, words.level, task.of_right_choices) +
         (conditions ? "One line a condition. Dotted: " + task.chance_text + ". Data: "
                     : "Below each, deviance residuals; dotted: ±1.96, and " + task.chance_text +
                           ", above. Data: ") +
         source_text(analysis) + ".";
}

}  // namespace

std::optional<Figure> psychometric_figure(const Analysis& analysis, const ReportNumbers& numbers,
                                          const std::filesystem::path& folder) {
  const auto fitted = static_cast<std::size_t>(
      std::count_if(numbers.choices.begin(), numbers.choices.end(),
                    [](const ChoiceCurve& curve) { return curve.pooled.has_value(); }));
  if (fitted == 0) return std::nullopt;
  const TaskWords words = task_words(analysis);
  Figure figure{.name = "psychometric",
                .title = words.choices_title + " by artifact",
                .caption = caption_of(analysis, numbers.conditions),
                .svg = folder / "psychometric.svg"};
  const std::vector<PanelCurves> artifacts = panels_of_curves(analysis.data);
  const PanelGrid grid = numbers.conditions ? panel_grid(artifacts.size(), 165) : panel_grid(fitted, 225);
  const LevelsDrawn drawn = levels_drawn(analysis.data);
  const double residual = largest_residual(numbers.choices);
  std::string script = level_axis_script(drawn) + multiplot(analysis);
  std::size_t place = 0;
  if (numbers.conditions)
    for (const PanelCurves& artifact : artifacts)
      script += condition_panel(numbers, artifact, grid.panels[place++], drawn, words);
  for (std::size_t i = 0; i < numbers.choices.size(); ++i)
    if (numbers.choices[i].pooled && !numbers.conditions)
      script += panel_script(numbers.choices[i], grid.panels[place++], i, residual, drawn, words);
  draw_figure(figure.svg, grid.height_px, script + "unset multiplot\n", Readers::owner);
  return figure;
}

}  // namespace seamline::analysis
