#include "analysis/report/page/sections.h"

#include <fmt/format.h>

#include "analysis/report/text/threshold_text.h"
#include "support/text/html.h"

namespace seamline::analysis {

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
