#include "sets/pages/seams_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "support/files/gnuplot.h"
#include "support/files/plot_panels.h"

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
      const double half_px = digit_px / 2 * static_cast<double>(label.size());
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

}  // namespace

std::string seams_figure(const SetSeams& seams) {
  return SeamsFigure(seams).svg();
}

}  // namespace seamline::renderer
