#include "analysis/report/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "analysis/report/figures/figure_parts.h"
#include "analysis/report/text/threshold_text.h"
#include "analysis/scores/level_words.h"

namespace seamline::analysis {

namespace {

constexpr int model_points = 60;

bool has_numbers(const Analysis& analysis) {
  return analysis.joint && analysis.joint->fit.estimated();
}

/// Whether a curve of a fit with numbers has its own.
bool has_curve(const JointAnalysis& joint, std::size_t curve) {
  return joint.fit.estimated(static_cast<int>(curve));
}

std::string model_block(const JointAnalysis& joint, std::size_t index) {
  std::string block = fmt::format("$model{} << EOD\n", index);
  const std::vector<double> levels = levels_of_curve(joint.data, static_cast<int>(index));
  if (has_curve(joint, index) && levels.size() > 1) {
    const auto [low, high] = std::minmax_element(levels.begin(), levels.end());
    for (int i = 0; i <= model_points; ++i) {
      const double x = *low + (*high - *low) * i / model_points;
      const MeanBand counted =
          mean_band(joint.fit, joint.left_out, static_cast<int>(index), JointMean::as_counted, x);
      const MeanBand seen = mean_band(joint.fit, joint.left_out, static_cast<int>(index), JointMean::seen, x);
      block += fmt::format("{:.8g} {:.6g} {:.6g} {:.6g} {:.6g}\n", level_at(joint.axis, x), counted.mean,
                           counted.low, counted.high, seen.mean);
    }
  }
  return block + "EOD\n";
}

std::string points_block(const ArtifactScores& scores, const LevelsDrawn& drawn, std::size_t index) {
  std::string block = fmt::format("$points{} << EOD\n", index);
  for (const CellMean& cell : scores.cells)
    block += fmt::format("{:.6g} {:.6g} {:.6g}\n", place_of(drawn, cell.level), cell.mean,
                         std::isnan(cell.sem) ? 0.0 : cell.sem);
  return block + "EOD\n";
}

std::string curve_plots(const Analysis& analysis, const LevelsDrawn& drawn, std::size_t index) {
  const JointAnalysis& joint = *analysis.joint;
  const PlotStyle style = plot_style(index);
  std::string plots = means_drawn(analysis).lines;
  if (has_curve(joint, index))
    plots += fmt::format(
        ", \\\n     $model{0} using 1:3:4 with filledcurves fs transparent solid 0.22 noborder lc rgb '{1}' "
        "notitle"
        ", \\\n     $model{0} using 1:2 with lines lc rgb '{1}' lw 1.4 title 'model'"
        ", \\\n     $model{0} using 1:5 with lines lc rgb '{1}' lw 1.2 dt (6,4) title 'seen'",
        index, style.colour);
  plots += fmt::format(
      ", \\\n     $points{0} using 1:($2-$3):(0):(2*$3) with vectors nohead lc rgb '{1}' lw 1.2 notitle"
      ", \\\n     $points{0} using 1:2 with points lc rgb '{1}' pt {2} ps 0.5 title 'answers'\n",
      index, style.colour, style.point);
  return model_block(joint, index) + points_block(analysis.data.artifacts[index], drawn, index) + plots;
}

/// Rows `level observed expected` of one score.
std::string score_block(const JointAnalysis& joint, const LevelsDrawn& drawn, std::size_t index, int score) {
  std::map<double, double> answers;
  for (const ScoreCell& cell : joint.goodness->cells)
    if (cell.curve == static_cast<int>(index)) answers[cell.x] += cell.observed;
  std::string block = fmt::format("$score{}x{} << EOD\n", index, score);
  for (const ScoreCell& cell : joint.goodness->cells) {
    if (cell.curve != static_cast<int>(index) || cell.score != score || !(answers[cell.x] > 0)) continue;
    const double level = std::isfinite(cell.x) ? level_at(joint.axis, cell.x) : 0;
    block += gap_before(drawn, level) + fmt::format("{:.6g} {:.6g} {:.6g}\n", place_of(drawn, level),
                                                    cell.observed / answers[cell.x],
                                                    cell.expected / answers[cell.x]);
  }
  return block + "EOD\n";
}

std::string score_plots(const JointAnalysis& joint, const LevelsDrawn& drawn, std::size_t index) {
  constexpr std::array<const char*, 5> names = {"0", "1", "2", "3", "4"};
  std::string blocks, plots;
  for (int score = 0; score <= joint.data.ratings; ++score) {
    const PlotStyle style = plot_style(static_cast<std::size_t>(score));
    blocks += score_block(joint, drawn, index, score);
    plots += fmt::format(
        "{0}$score{1}x{2} using 1:3 with lines lc rgb '{3}' lw 1.4 notitle, \\\n"
        "     $score{1}x{2} using 1:2 with points lc rgb '{3}' pt {4} ps 0.5 {5}",
        plots.empty() ? "plot " : ", \\\n     ", index, score, style.colour, style.point,
        index == 0 ? fmt::format("title '{}'", names[score]) : "notitle");
  }
  return blocks + plots + "\n";
}

}  // namespace

std::optional<Figure> joint_curves_figure(const Analysis& analysis, const std::filesystem::path& folder) {
  if (!has_numbers(analysis)) return std::nullopt;
  const MeansDrawn means = means_drawn(analysis);
  Figure figure{
      .name = "joint_curves",
      .title = means.words.title + " by the joint model",
      .caption = fmt::format(
          "{} over {} against {}{} the joint model (line, with a pointwise 95 % band over "
          "participants). Dashed: of what is seen, without lucky guesses. {} "
          "Data: {}",
          means.words.Mean, analysis.adaptive ? "people" : "objects",
          level_words(analysis.data.axis).quantity,
          analysis.adaptive ? " by" : ": answers (points; bars: one standard error over participants) and",
          means.dotted, source_sentence(analysis)),
      .svg = folder / "joint_curves.svg"};
  draw_curve_panels(analysis, figure.svg, {keyed_panel_px, means.axis_below_key, means.words.mean},
                    [&](const LevelsDrawn& drawn, std::size_t i) { return curve_plots(analysis, drawn, i); });
  return figure;
}

std::optional<Figure> joint_scores_figure(const Analysis& analysis, const std::filesystem::path& folder) {
  // Without ratings the shares of right answers are all there is, and the figure above has them.
  if (!has_numbers(analysis) || !analysis.joint->goodness || !task_words(analysis).rated) return std::nullopt;
  Figure figure{
      .name = "joint_scores",
      .title = "Scores observed and expected",
      .caption = fmt::format(
          "Share of each score against {}: observed (points) and expected by the joint model (lines). "
          "0: {}; 1 to 4: right with this rating. Data: {}.",
          level_words(analysis.data.axis).quantity, task_words(analysis).wrong, source_text(analysis)),
      .svg = folder / "joint_scores.svg"};
  draw_curve_panels(
      analysis, figure.svg,
      {165, "set ytics 0, 0.2, 1\nset yrange [0:1.3]\nset key maxrows 2 top right\n", "share of answers"},
      [&](const LevelsDrawn& drawn, std::size_t i) { return score_plots(*analysis.joint, drawn, i); });
  return figure;
}

}  // namespace seamline::analysis
