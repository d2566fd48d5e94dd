#include "sets/pages/seams_page.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>

#include "sets/pages/clip_seams.h"
#include "sets/pages/page_frame.h"
#include "sets/set_seams.h"
#include "support/files/atomic_file.h"
#include "support/files/gnuplot.h"
#include "support/files/plot_panels.h"
#include "support/text/error.h"
#include "support/text/html.h"

namespace seamline::renderer {
namespace {

constexpr double octaves_apart = 2;  // of a level that stands apart, from the smallest other one
constexpr int panel_height_px = 230, beside_px = 108, above_and_below_px = 146, column_gap_px = 62;
constexpr double digit_px = 8, label_gap_px = 8;

using Values = std::array<double, seam_steps.size()>;
/// Area or band.
struct What {
  const char* y_label;
  bool first_row;  ///< of its condition: it has titles, and room for the key
  std::function<const Values&(const SeamCell&)> values;
};

class SeamsFigure {
 public:
  explicit SeamsFigure(const SetSeams& seams) : seams_(seams) {
    for (const SeamCell& cell : seams.cells) {
      add(artifacts_, cell.artifact);
      add(conditions_, cell.condition);
      levels_.insert(cell.level);
    }
    const int columns = static_cast<int>(artifacts_.size()), rows = 2 * static_cast<int>(conditions_.size());
    // As wide as the page, and wider where panels would become too small.
    panel_width_px_ = std::max(250, (900 - beside_px - (columns - 1) * column_gap_px) / columns);
    const int row_gap_px = conditions_.size() > 1 ? 84 : 58;
    grid_ = {.columns = columns,
             .rows = rows,
             .width_px = beside_px + columns * panel_width_px_ + (columns - 1) * column_gap_px,
             .height_px = above_and_below_px + rows * panel_height_px + (rows - 1) * row_gap_px,
             .row_gap_px = row_gap_px};
  }

  std::string svg() const {
    const What area{.y_label = "area (px)",
                    .first_row = true,
                    .values = [](const SeamCell& cell) -> const Values& { return cell.area_px; }};
    const What band{.y_label = "widest band (px)",
                    .first_row = false,
                    .values = [](const SeamCell& cell) -> const Values& { return cell.widest_band_px; }};
    std::vector<PlotPanel> panels;
    for (const std::string& condition : conditions_)
      for (const What& what : {area, band})
        for (const Artifact artifact : artifacts_) panels.push_back(panel(artifact, condition, what));
    panels.front().key = PlotKey::shown;
    for (std::size_t i = panels.size() - artifacts_.size(); i < panels.size(); ++i)
      panels[i].x_label = level_title();
    const std::string heading = fmt::format("{}, {} x {} px, {:g} px per degree", seams_.study_name,
                                            seams_.width_px, seams_.height_px, seams_.pixels_per_degree);
    const std::string text =
        drawn_svg(grid_.width_px, grid_.height_px, panels_script(heading, panels, grid_));
    return text.substr(std::min(text.find("<svg"), text.size()));
  }

 private:
  template <class Value>
  static void add(std::vector<Value>& known, const Value& value) {
    if (std::find(known.begin(), known.end(), value) == known.end()) known.push_back(value);
  }

  [[nodiscard]] bool linear() const { return facts(seams_.quantity).axis == Axis::linear; }

  [[nodiscard]] std::string level_title() const {
    const QuantityFacts& about = facts(seams_.quantity);
    const std::string name(about.name);
    return about.unit.empty() || about.unit == about.name ? name : fmt::format("{} ({})", name, about.unit);
  }

  [[nodiscard]] double place_of(double level) const {
    if (!stands_apart(facts(seams_.quantity).axis, level)) return level;
    const auto other = std::find_if(levels_.begin(), levels_.end(), [](double l) { return l > 0; });
    return (other == levels_.end() ? 1 : *other) * std::exp2(-octaves_apart);
  }

  /// A tick a level; its label is left out where it would meet the one before.
  [[nodiscard]] std::vector<PlotTick> ticks() const {
    const auto along = [&](double place) { return linear() ? place : std::log(place); };
    const double first = along(place_of(*levels_.begin())), last = along(place_of(*levels_.rbegin()));
    const double px_per_unit = last > first ? 0.88 * panel_width_px_ / (last - first) : 0;
    std::vector<PlotTick> list;
    double free_from_px = -1e9;
    for (const double level : levels_) {
      const double place = place_of(level);
      std::string label =
          stands_apart(facts(seams_.quantity).axis, level) ? "none" : fmt::format("{}", level);
      const double half_px = digit_px / 2 * label.size();
      const double middle_px = px_per_unit * (along(place) - first);
      if (middle_px - half_px < free_from_px)
        label.clear();
      else
        free_from_px = middle_px + half_px + label_gap_px;
      list.push_back({place, label});
    }
    return list;
  }

  [[nodiscard]] PlotPanel panel(Artifact artifact, const std::string& condition, const What& what) const {
    PlotPanel panel{.y_label = artifact == artifacts_.front() ? what.y_label : "",
                    .key_left = facts(seams_.quantity).noticeability == Direction::increasing,
                    .key = PlotKey::none,
                    .linear_x = linear(),
                    .x_ticks = ticks()};
    if (what.first_row) {
      panel.title = std::string(word(artifact)) + (condition.empty() ? "" : ", " + condition);
      panel.key = PlotKey::room;
    }
    for (std::size_t i = 0; i < seam_steps.size(); ++i) {
      PlotLine line{.title = fmt::format("> {} steps", seam_steps[i]), .style = i}, apart{.style = i};
      for (const SeamCell& cell : seams_.cells)
        if (cell.artifact == artifact && cell.condition == condition)
          (stands_apart(facts(seams_.quantity).axis, cell.level) ? apart : line)
              .points.emplace_back(place_of(cell.level), what.values(cell)[i]);
      panel.lines.push_back(std::move(line));
      if (!apart.points.empty()) panel.lines.push_back(std::move(apart));
    }
    for (const SeamCell& cell : seams_.cells)
      for (const double value : what.values(cell)) {
        if (!(value > 0)) continue;
        if (!panel.y_room) panel.y_room = {value, value};
        panel.y_room = {std::min(panel.y_room->first, value), std::max(panel.y_room->second, value)};
      }
    // A narrow axis would have one tick.
    if (panel.y_room && panel.y_room->second < 4 * panel.y_room->first)
      panel.y_room = {panel.y_room->first / 2, panel.y_room->second * 2};
    return panel;
  }

  const SetSeams& seams_;
  std::vector<Artifact> artifacts_;
  std::vector<std::string> conditions_;
  std::set<double> levels_;
  int panel_width_px_ = 0;
  PlotGrid grid_;
};

/// Area (a row of panels) and widest band (a second row) against the level, a panel an artifact, a line for
/// each of `seam_steps`; two rows a condition; as SVG text to put into a page. Axes are alike along a row.
/// Throws InputError when there is no gnuplot.
std::string seams_figure(const SetSeams& seams) {
  return SeamsFigure(seams).svg();
}

std::string seams_figure_text(const SetSeams& seams) {
  try {
    require_gnuplot();
  } catch (const InputError&) {
    return "<p>There is no figure: gnuplot (Debian package gnuplot-nox) was not found.</p>\n";
  }
  return "<figure>" + seams_figure(seams) +
         fmt::format(
             "<figcaption>Above the area, below the widest band that differs from the reference by more "
             "than {}, {} and {} steps of 255 beyond noise. {:.4g} px are one degree, {:.4g} px one square "
             "degree. Hollow, on the lower axis: 0.</figcaption></figure>\n",
             seam_steps[0], seam_steps[1], seam_steps[2], seams.pixels_per_degree,
             seams.pixels_per_degree * seams.pixels_per_degree);
}

/// A table whose cells are text.
std::string html_table(const CsvTable& table) {
  std::string text = "<div class=\"scroll\"><table><thead><tr>";
  for (const CsvColumn& column : table.columns) text += "<th>" + html_escape(column.name) + "</th>";
  text += "</tr></thead><tbody>\n";
  for (const std::vector<CsvValue>& row : table.rows) {
    text += "<tr>";
    for (const CsvValue& value : row) text += "<td>" + html_escape(std::get<std::string>(value)) + "</td>";
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

CsvTable stimuli_table(const SetSeams& seams) {
  CsvTable table{.name = "stimuli", .columns = {{"stimulus", "", ""}}, .rows = {}};
  for (const char* what : {"area", "band"})
    for (const int step : seam_steps) table.columns.push_back({fmt::format("{} > {}", what, step), "", ""});
  table.columns.push_back({"noise", "", ""});
  for (const SeamRow& row : seams.rows) {
    std::vector<CsvValue> values{row.id};
    for (const SeamExtent& extent : row.seam.beyond) values.emplace_back(std::to_string(extent.area_px));
    for (const SeamExtent& extent : row.seam.beyond)
      values.emplace_back(fmt::format("{:.1f}", extent.widest_band_px));
    values.emplace_back(fmt::format("{:.2f}", row.seam.largest_noise_steps));
    table.rows.push_back(std::move(values));
  }
  return table;
}

}  // namespace

void write_seams_page(const std::filesystem::path& folder, const SetSeams& seams,
                      const std::vector<ClipSeam>& clips) {
  const std::string page =
      html_page("Seams: " + html_escape(seams.study_name),
                "<p>" + html_escape(seams_meaning(seams)) + "</p>\n" + seams_figure_text(seams) +
                    (clips.empty() ? std::string()
                                   : "<h2>Clips</h2>\n<p>" + html_escape(clip_seams_meaning()) + "</p>\n" +
                                         html_table(clip_cells_table(seams, clips))) +
                    (clips.empty() ? "<h2>Means</h2>\n" : "<h2>Middle frames</h2>\n") +
                    html_table(seam_cells_table(seams)) +
                    "<h2>Every stimulus</h2>\n<p class=\"soft\">Areas and bands in px. Noise: standard "
                    "deviation in the noisiest tile of 32 x 32 pixels, in steps of 255; from each "
                    "difference three standard deviations of its own tile are taken off.</p>\n" +
                    html_table(stimuli_table(seams)));
  write_file_atomically(folder / "seams.csv", csv_text(seams_table(seams)));
  if (!clips.empty())
    write_file_atomically(folder / "clip_seams.csv", csv_text(clip_seams_table(seams, clips)));
  write_file_atomically(folder / "seams.html", page);
}

}  // namespace seamline::renderer
