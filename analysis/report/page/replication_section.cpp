#include "analysis/report/page/replication_section.h"

#include "analysis/report/page/html_parts.h"
#include "analysis/report/text/replication_text.h"

namespace seamline::analysis {

std::string replication_html(const Analysis& analysis) {
  if (!analysis.replication) return "";
  std::vector<HtmlColumn> columns;
  for (const std::string& title : replication_titles(analysis)) columns.push_back({title});
  columns.back().sentence = true;
  std::string html = "<h2 id=\"published\">Published thresholds</h2>\n" +
                     html_paragraph("Beside " + analysis.replication->name +
                                    ". Differences are this study’s threshold less the published one.") +
                     html_table(columns, replication_lines(analysis));
  for (const std::string& sentence : replication_sentences(analysis)) html += html_paragraph(sentence);
  return html;
}

}  // namespace seamline::analysis
