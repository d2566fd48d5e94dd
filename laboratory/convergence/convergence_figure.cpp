#include "laboratory/convergence/convergence_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "support/files/gnuplot.h"
#include "support/files/plot_panels.h"

namespace seamline::renderer {
namespace {

constexpr double one_step = 1.0 / 255;

template <class Row>
using Value = std::function<double(const Row&)>;

template <class Row>
std::vector<std::pair<double, double>> points(const std::vector<Row>& rows, const Value<Row>& x,
                                              const Value<Row>& y) {
  std::vector<std::pair<double, double>> out;
  for (const Row& row : rows) out.emplace_back(x(row), y(row));
  return out;
}

/// "name (slope -0.52)", as the table of slopes has it.
std::string with_slope(const std::string& name, const FigureText& text, const std::string& series,
                       const std::string& of) {
  for (const SlopeRow& slope : text.slopes)
    if (slope.series == series && slope.of == of && slope.found)
      return fmt::format("{} (slope {:.2f})", name, *slope.found);
  return name;
}

/// A guide that starts at the first point of a line and goes to its last x.
PlotGuide guide_from(const PlotLine& line, double slope, const std::string& title) {
  if (line.points.empty()) return {};
  return {.title = title,
          .slope = slope,
          .x = line.points.front().first,
          .y = line.points.front().second,
          .x_from = std::min(line.points.front().first, line.points.back().first),
          .x_to = std::max(line.points.front().first, line.points.back().first)};
}

void draw(const FigureText& text, std::span<const PlotPanel> panels) {
  draw_svg(text.svg, panels_width_px(panels.size()), panels_height_px, panels_script(text.subject, panels));
}

PlotPanel sample_panel(const SampleResult& result, const FigureText& text, bool given) {
  PlotPanel panel{
      .title = given ? "off the object, on a given photograph" : "the stimulus as a set renders it",
      .x_label = "run time (s)",
      .y_label = "RMSE (display units)"};
  const std::string of = given ? "error in seconds, off the object, background given" : "error in seconds";
  for (std::size_t i = 0; i < result.meanings.size(); ++i) {
    const std::string& series = result.meanings[i].first;
    PlotLine line{.title = with_slope(series, text, series, of), .style = i};
    for (const SeriesRow& row : result.rows)
      if (row.series == series) line.points.emplace_back(row.seconds, given ? row.rmse_given : row.rmse);
    panel.lines.push_back(std::move(line));
  }
  panel.guides.push_back(guide_from(panel.lines.front(), -0.5, "slope -0.5"));
  panel.marks = {{.at = one_step, .label = "one 8-bit step"},
                 {.at = given ? result.reference_noise_given : result.reference_noise,
                  .label = "noise of the reference"}};
  return panel;
}

PlotPanel error_panel(const MeshResult& result, const FigureText& text) {
  const Value<MeshRow> tolerance = [](const MeshRow& row) { return row.tolerance.value_or(0); };
  PlotPanel panel{
      .title = "error against full density",
      .x_label = "tolerance of the depth mesh",
      .y_label = "relative depth; RMSE (display units)",
      .lines = {{.title = with_slope("depth, largest", text, "adaptive", "depth error in tolerance"),
                 .points = points<MeshRow>(result.rows, tolerance,
                                           [](const MeshRow& row) { return row.depth_error; }),
                 .style = 0},
                {.title = with_slope("picture, RMSE", text, "adaptive", "picture error in tolerance"),
                 .points =
                     points<MeshRow>(result.rows, tolerance, [](const MeshRow& row) { return row.rmse; }),
                 .style = 1}},
      .marks = {{.vertical = true, .at = result.default_tolerance, .label = "study"}},
      .falling_x = true};
  PlotLine adaptive_rmse = panel.lines[1];
  adaptive_rmse.points.pop_back();  // full density
  if (adaptive_rmse.points.front().second > 0) panel.guides = {guide_from(adaptive_rmse, 1, "slope 1")};
  return panel;
}

PlotPanel rule_panel(const MeshResult& result) {
  const Value<MeshRow> tolerance = [](const MeshRow& row) { return row.tolerance.value_or(0); };
  return {.title = "the rule for the default tolerance",
          .x_label = "tolerance of the depth mesh",
          .y_label = "pixels in 1,000; 8-bit steps (hollow: 0)",
          .lines = {{.title = "pixels in 1,000 that change by more than one step",
                     .points = points<MeshRow>(result.rows, tolerance,
                                               [](const MeshRow& row) { return 1000 * row.changed_share; }),
                     .style = 2},
                    {.title = "largest change of a pixel, in steps",
                     .points = points<MeshRow>(
                         result.rows, tolerance,
                         [](const MeshRow& row) { return static_cast<double>(row.largest_change_steps); }),
                     .style = 3}},
          .marks = {{.at = 1000 * allowed_changed_share, .label = "allowed: pixels"},
                    {.at = allowed_change_steps, .label = "allowed: steps"},
                    {.vertical = true, .at = result.default_tolerance, .label = "study"}},
          .falling_x = true};
}

PlotPanel mesh_cost_panel(const MeshResult& result) {
  const Value<MeshRow> tolerance = [](const MeshRow& row) { return row.tolerance.value_or(0); };
  const MeshRow& full = result.rows.back();
  const auto relative = [&](const std::string& title, std::size_t style, const Value<MeshRow>& value) {
    return PlotLine{.title = title,
                    .points = points<MeshRow>(result.rows, tolerance,
                                              [&](const MeshRow& row) { return value(row) / value(full); }),
                    .style = style};
  };
  return {.title = "cost, full density = 1",
          .x_label = "tolerance of the depth mesh",
          .y_label = "relative to full density",
          .lines = {relative("rays a second", 0, [](const MeshRow& row) { return row.rays_per_second; }),
                    relative("build, mesh and hierarchy", 1,
                             [](const MeshRow& row) { return row.build_seconds + row.bvh_seconds; }),
                    relative("memory, mesh and hierarchy", 2,
                             [](const MeshRow& row) {
                               return static_cast<double>(row.mesh_bytes + row.embree_bytes);
                             }),
                    relative("triangles", 3,
                             [](const MeshRow& row) { return static_cast<double>(row.triangles); })},
          .marks = {{.at = 1, .label = "full density"},
                    {.vertical = true, .at = result.default_tolerance, .label = "study"}},
          .falling_x = true,
          .key_left = true};
}

}  // namespace

void draw_figure(const SampleResult& result, const FigureText& text) {
  draw(text, std::vector{sample_panel(result, text, false), sample_panel(result, text, true)});
}

void draw_figure(const MeshResult& result, const FigureText& text) {
  draw(text, std::vector{error_panel(result, text), rule_panel(result), mesh_cost_panel(result)});
}

void draw_figure(const std::vector<WidthRow>& rows, const FigureText& text) {
  const Value<WidthRow> width = [](const WidthRow& row) { return static_cast<double>(row.width_px); };
  PlotPanel error{
      .title = "error against the reference",
      .x_label = "depth map width W (px)",
      .y_label = "RMSE (display units)",
      .lines = {{.title =
                     with_slope("stimulus", text, "depth width", "error in width, texel wider than a pixel"),
                 .points = points<WidthRow>(rows, width, [](const WidthRow& row) { return row.rmse; })}},
      .marks = {{.at = one_step, .label = "one 8-bit step"}},
      .powers_of_two = true};
  // The steeper one ends at the finest map, where it is to be expected.
  PlotLine finest = error.lines[0];
  std::reverse(finest.points.begin(), finest.points.end());
  finest.points.resize(std::min<std::size_t>(finest.points.size(), 4));
  error.guides = {guide_from(error.lines[0], -0.5, "slope -0.5: edges misplaced by pixels"),
                  guide_from(finest, -1, "slope -1: by parts of a pixel")};
  const PlotPanel cost{
      .title = "cost",
      .x_label = "depth map width W (px)",
      .y_label = "run time (s)",
      .lines =
          {{.title = "stimulus pass",
            .points = points<WidthRow>(rows, width, [](const WidthRow& row) { return row.stimulus_seconds; }),
            .style = 0},
           {.title = "depth mesh and hierarchy",
            .points = points<WidthRow>(rows, width, [](const WidthRow& row) { return row.mesh_seconds; }),
            .style = 1},
           {.title = "capture",
            .points = points<WidthRow>(rows, width, [](const WidthRow& row) { return row.capture_seconds; }),
            .style = 2}},
      .powers_of_two = true,
      .key_left = true};
  draw(text, std::vector{error, cost});
}

void draw_figure(const std::vector<LinkRow>& rows, const FigureText& text) {
  PlotPanel scene{.title = "links from the truth to the local scene",
                  .x_label = "run time of the local scene (s)",
                  .y_label = "RMSE (display units)"};
  PlotPanel asked{.title = "who is in front",
                  .x_label = "run time of the stimulus pass (s)",
                  .y_label = "RMSE (display units)"};
  for (const LinkRow& row : rows) {
    if (row.link == "occlusion") {
      asked.lines.push_back(
          {.title = row.variant, .points = {{row.stimulus_seconds, row.rmse}}, .style = asked.lines.size()});
      continue;
    }
    if (scene.lines.empty() || scene.lines.back().title != row.link)
      scene.lines.push_back({.title = row.link, .points = {}, .style = scene.lines.size()});
    scene.lines.back().points.emplace_back(row.scene_seconds, row.rmse);
  }
  draw(text, std::vector{scene, asked});
}

void draw_figure(const std::vector<RealtimeRow>& rows, const FigureText& text) {
  PlotPanel shadows{.title = "shadows and light",
                    .x_label = "processor time of a frame (s)",
                    .y_label = "RMSE beside rays (display units)",
                    .marks = {{.at = one_step, .label = "one 8-bit step"}}};
  PlotPanel others{.title = "normals, occlusion, compositing",
                   .x_label = "processor time of a frame (s)",
                   .y_label = "RMSE beside rays (display units)",
                   .marks = {{.at = one_step, .label = "one 8-bit step"}}};
  for (const RealtimeRow& row : rows) {
    const double seconds = row.prepare_seconds + row.ask_seconds;
    if (row.method == "traced") {
      for (PlotPanel* panel : {&shadows, &others})
        panel->marks.push_back({.vertical = true, .at = seconds, .label = "rays"});
      continue;
    }
    const bool single = row.method == "normals" || row.method == "occlusion" || row.method == "compositing";
    PlotPanel& panel = single ? others : shadows;
    const std::string title = single ? row.setting : row.method;
    if (panel.lines.empty() || panel.lines.back().title != title)
      panel.lines.push_back({.title = title, .points = {}, .style = panel.lines.size()});
    panel.lines.back().points.emplace_back(seconds, row.rmse);
  }
  draw(text, std::vector{shadows, others});
}

void draw_figure(const LightResult& result, const FigureText& text) {
  std::vector<PlotPanel> panels;
  const auto last_strategy = [&](const std::string& light) {
    std::string last;
    for (const LightRow& row : result.rows)
      if (row.light == light) last = row.strategy;
    return last;
  };
  for (const LightRow& row : result.rows) {
    if (panels.empty() || panels.back().title != row.light)
      panels.push_back({.title = row.light,
                        .x_label = "processor time (s)",
                        .y_label = "root mean square error / mean radiance"});
    PlotPanel& panel = panels.back();
    if (row.rays > 1 && row.strategy != last_strategy(row.light)) continue;
    const std::string title =
        row.rays == 1 ? row.strategy : fmt::format("{}, {} rays a sample", row.strategy, row.rays);
    if (panel.lines.empty() || panel.lines.back().title != title)
      panel.lines.push_back({.title = title, .points = {}, .style = panel.lines.size()});
    panel.lines.back().points.emplace_back(row.seconds, row.error);
  }
  for (PlotPanel& panel : panels) panel.guides.push_back(guide_from(panel.lines.front(), -0.5, "slope -0.5"));
  draw(text, panels);
}

}  // namespace seamline::renderer
