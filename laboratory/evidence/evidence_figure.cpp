#include "laboratory/evidence/evidence_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "support/files/atomic_file.h"
#include "support/files/gnuplot.h"
#include "support/files/plot_panels.h"
#include "support/running/overloaded.h"
#include "support/text/csv_read.h"
#include "support/text/number_option.h"

namespace seamline::laboratory {
namespace {

namespace fs = std::filesystem;

using EvidenceRows = std::vector<std::vector<std::string>>;

EvidenceRows rows_of(const fs::path& table, const std::vector<std::string>& columns) {
  EvidenceRows rows;
  read_csv(table.string(), read_file(table), columns, [&](const CsvRow& row) { rows.push_back(row.values); });
  return rows;
}

void draw_curves(const fs::path& table, const fs::path& svg, const std::string& heading,
                 const MeanCurves& of) {
  struct Mean {
    double sum = 0;
    int rows = 0;
  };
  std::map<std::string, std::map<double, Mean>> curves;
  for (const std::vector<std::string>& row : rows_of(table, {of.curve, of.x, of.y})) {
    const std::optional<double> x = decimal_number(row[1]), y = decimal_number(row[2]);
    if (!x || !y) continue;
    Mean& mean = curves[row[0]][*x];
    mean.sum += *y;
    ++mean.rows;
  }
  PlotPanel panel{.x_label = of.x_label, .y_label = of.y_label};
  panel.powers_of_two = true;
  for (const auto& [name, means] : curves) {
    PlotLine line{.title = name, .style = panel.lines.size()};
    for (const auto& [x, mean] : means) line.points.emplace_back(x, mean.sum / mean.rows);
    panel.lines.push_back(line);
  }
  draw_svg(svg, panels_width_px(1), panels_height_px, panels_script(heading, {&panel, 1}));
}

constexpr int dots_width_px = 800;

std::string dots_script(const EvidenceRows& rows, const std::string& heading, const LabelledDots& of) {
  constexpr double letter_px = 6.8, beside_labels_px = 25;  // gnuplot takes letters for wider than they are
  std::string dots, ticks;
  int row_number = 0;
  std::size_t longest = 0;
  for (const std::vector<std::string>& row : rows) {
    const std::optional<double> x = decimal_number(row.back());
    if (!x) continue;
    const std::string label = fmt::format("{}", fmt::join(row.begin(), row.end() - 1, ", "));
    longest = std::max(longest, label.size());
    ticks += fmt::format("{}\"{}\" {}", row_number == 0 ? "" : ", ", gnuplot_text(label), row_number);
    dots += fmt::format("{:.6g} {}\n", *x, row_number++);
  }
  return fmt::format(
      "$dots << EOD\n{}EOD\nset lmargin at screen {:.3f}\nset title \"{}\"\nset xlabel \"{}\"\n"
      "set yrange [{}:-1]\nset ytics ({})\n"
      "set grid ytics linecolor '#dddddd'\nunset key\nset arrow from {:.6g}, graph 0 to {:.6g}, graph 1 nohead "
      "dashtype 3 linecolor '{}'\nplot $dots using 1:2 with points pointtype 7 linecolor '{}'\n",
      dots, (beside_labels_px + letter_px * longest) / dots_width_px, gnuplot_text(heading),
      gnuplot_text(of.x_label), row_number, ticks, of.wanted, of.wanted, plot_ink, plot_style(0).colour);
}

void draw_dots(const fs::path& table, const fs::path& svg, const std::string& heading,
               const LabelledDots& of) {
  constexpr int row_px = 20, rest_px = 110;
  std::vector<std::string> columns = of.labels;
  columns.push_back(of.x);
  EvidenceRows rows = rows_of(table, columns);
  std::erase_if(rows, [](const std::vector<std::string>& row) { return !decimal_number(row.back()); });
  if (rows.empty()) return;
  draw_svg(svg, dots_width_px, rest_px + row_px * static_cast<int>(rows.size()),
           dots_script(rows, heading, of));
}

}  // namespace

void draw_evidence(const fs::path& folder, const EvidenceFigure& figure) {
  const fs::path table = folder / figure.table, svg = fs::path(table).replace_extension(".svg");
  std::visit(Overloaded{[&](const MeanCurves& of) { draw_curves(table, svg, figure.heading, of); },
                        [&](const LabelledDots& of) { draw_dots(table, svg, figure.heading, of); }},
             figure.of);
}

}  // namespace seamline::laboratory
