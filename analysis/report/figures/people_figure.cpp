#include "analysis/report/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/figures/figure_parts.h"
#include "analysis/report/text/threshold_text.h"
#include "analysis/scores/level_words.h"

namespace seamline::analysis {

namespace {

/// More lines than these are a grey area: of more people every so manieth is drawn.
constexpr std::size_t most_people_drawn = 200;

std::size_t drawn_every(const ArtifactScores& scores) {
  return (scores.people.size() + most_people_drawn - 1) / most_people_drawn;
}

/// `level score`, a block of rows a person; a level without an answer breaks the line.
std::string people_block(const ArtifactScores& scores, const LevelsDrawn& drawn, std::size_t index) {
  std::string block = fmt::format("$people{} << EOD\n", index);
  for (std::size_t person = 0; person < scores.people.size(); person += drawn_every(scores)) {
    for (std::size_t w = 0; w < scores.level.size(); ++w) {
      const double value =
          scores.noticeability(static_cast<Eigen::Index>(person), static_cast<Eigen::Index>(w));
      block += gap_before(drawn, scores.level[w]) +
               (std::isnan(value) ? "\n"
                                  : fmt::format("{:.6g} {:.4g}\n", place_of(drawn, scores.level[w]), value));
    }
    block += "\n";
  }
  block += fmt::format("EOD\n$mean{} << EOD\n", index);
  for (const CellMean& cell : scores.cells)
    block += gap_before(drawn, cell.level) +
             fmt::format("{:.6g} {:.6g}\n", place_of(drawn, cell.level), cell.mean);
  return block + "EOD\n";
}

std::string people_plots(const Analysis& analysis, const LevelsDrawn& drawn, std::size_t index) {
  const ArtifactScores& scores = analysis.data.artifacts[index];
  const PlotStyle style = plot_style(index);
  return people_block(scores, drawn, index) + means_drawn(analysis).lines +
         fmt::format(
             ", \\\n     $people{0} using 1:2 with lines lc rgb '#808080' lw 0.5 notitle"
             ", \\\n     $mean{0} using 1:2 with linespoints lc rgb '{1}' lw 2.2 pt {2} ps 0.5 notitle\n",
             index, style.colour, style.point);
}

std::string caption_of(const Analysis& analysis) {
  const MeansDrawn means = means_drawn(analysis);
  std::size_t most = 0;
  for (const ArtifactScores& scores : analysis.data.artifacts) most = std::max(most, scores.people.size());
  return fmt::format(
      "{} over objects against {}: a thin line a participant{}, a thick line the mean over "
      "all "
      "participants. {} Data: {}",
      means.words.Mean, level_words(analysis.data.axis).quantity,
      most > most_people_drawn ? fmt::format(" (at most {} of {}, evenly chosen)", most_people_drawn, most)
                               : std::string(),
      means.dotted, source_sentence(analysis));
}

}  // namespace

std::optional<Figure> people_figure(const Analysis& analysis, const std::filesystem::path& folder) {
  if (analysis.adaptive || analysis.counts.used < 2) return std::nullopt;
  Figure figure{.name = "participants",
                .title = task_words(analysis).title + " of every participant",
                .caption = caption_of(analysis),
                .svg = folder / "participants.svg"};
  draw_curve_panels(
      analysis, figure.svg, {165, means_drawn(analysis).axis, task_words(analysis).mean},
      [&](const LevelsDrawn& drawn, std::size_t i) { return people_plots(analysis, drawn, i); });
  return figure;
}

}  // namespace seamline::analysis
