#include <fmt/format.h>

#include <cmath>

#include "analysis/report/numbers/threshold_rows.h"
#include "analysis/report/page/report_html.h"
#include "support/text/html.h"

namespace seamline::analysis {

namespace {

std::string planted_text(const ThresholdRow& row) {
  if (!row.planted) return "";
  return size_text(*row.planted);
}

std::string texels_text(const WidthEstimate& estimate) {
  return estimate.log2_px ? fmt::format("{:.3g}", std::exp2(*estimate.log2_px) / 360) : "–";
}

std::string threshold_line(const ThresholdRow& row, bool planted) {
  const std::string paper = row.paper_px ? fmt::format("{} × {}", *row.paper_px, *row.paper_px / 2) : "–";
  std::string line = fmt::format(
      "<tr{}><th scope=\"row\">{}</th><td>{}</td><td class=\"number\">{}</td><td>{}</td><td "
      "class=\"number\">{}</td><td class=\"number\">{}</td>",
      row.quantity == "PT" ? " class=\"group\"" : "",
      row.quantity == "PT" ? html_escape(artifact_title(row.artifact)) : "", row.quantity,
      html_escape(size_text(row.here)),
      html_escape(interval_text(row.here.ci95, row.smallest_px, row.largest_px)), texels_text(row.here),
      paper);
  if (planted) line += fmt::format("<td class=\"number\">{}</td>", html_escape(planted_text(row)));
  return line + "</tr>\n";
}

}  // namespace

std::string threshold_table_html(const Analysis& analysis) {
  const bool planted = !analysis.planted.empty();
  std::string table = fmt::format(
      "<div class=\"scroll\"><table>\n<thead><tr><th>artifact</th><th></th><th "
      "class=\"number\">{}</th><th>95 % interval of W</th><th class=\"number\">texels per degree</th><th "
      "class=\"number\">paper,<br>Table 1</th>{}</tr></thead>\n<tbody>\n",
      html_escape(analysis.counts.simulated > 0 ? "simulated observers" : "this study"),
      planted ? "<th class=\"number\">planted</th>" : "");
  for (const ThresholdRow& row : threshold_rows(analysis)) table += threshold_line(row, planted);
  return table + "</tbody></table></div>\n";
}

std::string samples_html(const StimulusSamples& samples) {
  if (const auto* sentence = std::get_if<std::string>(&samples))
    return "<p>" + html_escape(*sentence) + "</p>\n";
  std::string html;
  for (const SampleRow& row : std::get<std::vector<SampleRow>>(samples)) {
    html += fmt::format("<div class=\"sample-title\">{}: {}, {}</div>\n<div class=\"samples\">\n",
                        html_escape(artifact_title(row.artifact)), html_escape(row.scene),
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
         "<p class=\"soft\">Depth map width in px below each cut-out; the reference is the perfect "
         "insertion.</p>\n";
}

}  // namespace seamline::analysis
