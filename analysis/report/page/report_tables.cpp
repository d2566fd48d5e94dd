#include <fmt/format.h>

#include <cmath>

#include "analysis/report/numbers/threshold_rows.h"
#include "analysis/report/page/report_html.h"
#include "support/text/html.h"

namespace seamline::analysis {

namespace {

std::string planted_text(const ThresholdRow& row) {
  if (!row.planted) return "";
  return size_text(*row.planted, row.tested.axis);
}

std::string texels_text(const ThresholdEstimate& estimate) {
  return estimate.level_x ? fmt::format("{:.3g}", std::exp2(*estimate.level_x) / 360) : "–";
}

std::string threshold_line(const ThresholdRow& row, bool planted, bool beside) {
  const std::string paper = row.paper_px ? fmt::format("{} × {}", *row.paper_px, *row.paper_px / 2) : "–";
  std::string line =
      fmt::format("<tr{}><th scope=\"row\">{}</th><td>{}</td><td class=\"number\">{}</td><td>{}</td>",
                  row.quantity == "PT" ? " class=\"group\"" : "",
                  row.quantity == "PT" ? html_escape(artifact_title(row.artifact, row.condition)) : "",
                  row.quantity, html_escape(size_text(row.here, row.tested.axis)),
                  html_escape(interval_text(row.here.ci95, row.tested)));
  if (of_depth_widths(row.tested.axis))
    line += fmt::format("<td class=\"number\">{}</td>", texels_text(row.here));
  if (beside) line += fmt::format("<td class=\"number\">{}</td>", paper);
  if (planted) line += fmt::format("<td class=\"number\">{}</td>", html_escape(planted_text(row)));
  return line + "</tr>\n";
}

}  // namespace

std::string threshold_table_html(const Analysis& analysis) {
  const bool planted = !analysis.planted.empty(), beside = beside_the_paper(analysis);
  const bool widths = of_depth_widths(analysis.data.axis);
  std::string table = fmt::format(
      "<div class=\"scroll\"><table>\n<thead><tr><th>artifact</th><th></th><th "
      "class=\"number\">{}</th><th>95 % interval{}</th>{}{}{}</tr></thead>\n<tbody>\n",
      html_escape(analysis.counts.simulated > 0 ? "simulated observers" : "this study"),
      widths ? " of W" : "", widths ? "<th class=\"number\">texels per degree</th>" : "",
      beside ? "<th class=\"number\">paper,<br>Table 1</th>" : "",
      planted ? "<th class=\"number\">planted</th>" : "");
  for (const ThresholdRow& row : threshold_rows(analysis)) table += threshold_line(row, planted, beside);
  return table + "</tbody></table></div>\n";
}

std::string samples_html(const StimulusSamples& samples, const LevelAxis& axis) {
  if (const auto* sentence = std::get_if<std::string>(&samples))
    return "<p>" + html_escape(*sentence) + "</p>\n";
  std::string html;
  for (const SampleRow& row : std::get<std::vector<SampleRow>>(samples)) {
    html += fmt::format("<div class=\"sample-title\">{}: {}, {}</div>\n<div class=\"samples\">\n",
                        html_escape(artifact_title(row.artifact, row.condition)), html_escape(row.scene),
                        html_escape(row.object));
    if (!row.trouble.empty()) html += "<div>not shown: " + html_escape(row.trouble) + "</div>\n";
    for (const SampleImage& image : row.images)
      if (!image.trouble.empty())
        html += fmt::format("<div class=\"missing\">not shown: {}<br>{}</div>\n", html_escape(image.trouble),
                            html_escape(image.label));
      else
        html += fmt::format(
            "<div><img alt=\"{}\" width=\"{}\" height=\"{}\" src=\"data:image/png;base64,{}\">{}</div>\n",
            html_escape(image.stimulus_id.empty() ? "reference" : image.stimulus_id), image.width_px,
            image.height_px, base64(image.png), html_escape(image.label));
    html += "</div>\n";
  }
  return html +
         (of_depth_widths(axis) ? std::string("<p class=\"soft\">Depth map width in px")
                                : "<p class=\"soft\">Level (" + html_escape(axis_title(axis)) + ")") +
         " below each cut-out; the reference is the perfect insertion.</p>\n";
}

}  // namespace seamline::analysis
