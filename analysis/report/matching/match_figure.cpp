#include "analysis/report/matching/match_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>

#include "analysis/scores/level_axis.h"
#include "support/files/gnuplot.h"

namespace seamline::analysis {
namespace {

std::string row_title(const CurveMatches& curve) {
  return std::string(word(curve.artifact)) + (curve.condition.empty() ? "" : ", " + curve.condition);
}

/// A tic at each level at which a match began or ended, every second one or so with its number.
std::string tics_of_matches(const MatchAnalysis& analysis, const LevelAxis& axis) {
  constexpr std::size_t most_numbers = 8;
  std::set<double> levels;
  for (const study::MatchRecord& match : analysis.matches) levels.insert({match.level, match.start_level});
  const std::size_t every = 1 + (levels.size() - 1) / most_numbers;
  std::string tics;
  std::size_t at = 0;
  for (const double level : levels) {
    tics += fmt::format("{}\"{}\" {:.9g}", tics.empty() ? "" : ", ",
                        at % every == 0 ? gnuplot_text(tested_text(axis, level)) : "",
                        along_axis(axis.quantity, level));
    ++at;
  }
  return tics;
}

/// Points of a curve's participants, spread a little below its row so that equal ones are seen.
std::string rows_of_people(const MatchAnalysis& analysis, const CurveMatches& curve, double row) {
  constexpr double spread = 0.3, below = 0.12;
  std::string block;
  int number = 0;
  for (const PersonMatches& person : analysis.of_people) {
    if (person.artifact != curve.artifact || person.condition != curve.condition) continue;
    const double share = (number++ + 0.5) / curve.people;
    block += fmt::format("{:.9g} {:.6g}\n", person.mean, row + below + spread * share);
  }
  return block;
}

}  // namespace

Figure draw_matches(const MatchAnalysis& analysis, const std::filesystem::path& folder) {
  const LevelAxis axis = level_axis(analysis.log);
  Figure figure{.name = "matches",
                .title = "Matched levels",
                .caption =
                    "Levels at which the seam is just seen. Small points: the mean of each participant. "
                    "Large points: the mean over participants, with its 95 % interval.",
                .svg = folder / "matches.svg"};
  std::string people = "$people << EOD\n", means = "$means << EOD\n", names;
  double row = 0;
  for (const CurveMatches& curve : analysis.curves) {
    people += rows_of_people(analysis, curve, row);
    const MatchMean& mean = curve.threshold;
    means += fmt::format("{:.9g} {:.6g} {:.9g} {:.9g}\n", mean.mean, row, mean.low.value_or(mean.mean),
                         mean.high.value_or(mean.mean));
    names += fmt::format("{}\"{}\" {}", names.empty() ? "" : ", ", gnuplot_text(row_title(curve)), row);
    row += 1;
  }
  constexpr int row_px = 46, frame_px = 90;
  const std::string script =
      people + "EOD\n" + means + "EOD\n" +
      fmt::format(
          "set border 3 lc rgb '{0}'\nset tics nomirror out textcolor rgb '{0}'\nset xtics ({1})\n"
          "set ytics ({2})\nset yrange [{3}:-0.5]\nset offsets 0.3, 0.3, 0, 0\nset xlabel \"{4}\" "
          "textcolor rgb '{0}'\nset key off\n",
          plot_ink, tics_of_matches(analysis, axis), names, row - 0.4, gnuplot_text(axis_title(axis))) +
      fmt::format(
          "plot $people using 1:2 with points pt 7 ps 0.3 lc rgb '#808080', \\\n     $means using "
          "1:2:3:4 with xerrorbars pt {0} ps 0.8 lw 1.6 lc rgb '{1}'\n",
          plot_style(0).point, plot_style(0).colour);
  draw_figure(figure.svg, frame_px + row_px * static_cast<int>(analysis.curves.size()), script,
              Readers::owner);
  return figure;
}

}  // namespace seamline::analysis
