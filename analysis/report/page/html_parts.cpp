#include "analysis/report/page/html_parts.h"

#include <fmt/format.h>

#include <cmath>

#include "support/text/html.h"

namespace seamline::analysis {

std::string html_table(const std::vector<HtmlColumn>& columns,
                       const std::vector<std::vector<std::string>>& lines, const std::string& style) {
  const auto attribute = [&](std::size_t column) {
    if (column >= columns.size()) return "";
    if (columns[column].sentence) return " class=\"sentence\"";
    return columns[column].number ? " class=\"number\"" : "";
  };
  std::string html = fmt::format("<div class=\"scroll\"><table{}>\n<thead><tr>",
                                 style.empty() ? "" : " class=\"" + style + "\"");
  for (std::size_t i = 0; i < columns.size(); ++i)
    html += fmt::format("<th scope=\"col\"{}>{}</th>", attribute(i), html_escape(columns[i].title));
  html += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& line : lines) {
    html += fmt::format("<tr><th scope=\"row\"{}>{}</th>", attribute(0), html_escape(line.front()));
    for (std::size_t i = 1; i < line.size(); ++i)
      html += fmt::format("<td{}>{}</td>", attribute(i), html_escape(line[i]));
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string html_paragraph(const std::string& text) {
  return "<p>" + html_escape(text) + "</p>\n";
}

std::string figure_html(const std::vector<Figure>& figures, const std::string& name) {
  for (const Figure& figure : figures)
    if (figure.name == name)
      return fmt::format(
          "<figure role=\"img\" aria-label=\"{}\">\n{}\n<figcaption>{}</figcaption>\n</figure>\n",
          html_escape(figure.title), inline_svg(figure), html_escape(figure.caption));
  return "";
}

std::string seconds_text(double seconds) {
  return std::isfinite(seconds) ? fmt::format("{:.1f} s", seconds) : "–";
}

std::string percent_text(double share) {
  return std::isfinite(share) ? fmt::format("{:.0f} %", 100 * share) : "–";
}

std::string decimal_text(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  const std::string text = fmt::format("{:.{}f}", value, digits);
  if (text == fmt::format("{:.{}f}", -0.0, digits)) return text.substr(1);
  return text.starts_with('-') ? "−" + text.substr(1) : text;
}

}  // namespace seamline::analysis
