#include "analysis/report/page/sections.h"

#include "analysis/report/page/html_parts.h"
#include "analysis/report/text/origins_text.h"

namespace seamline::analysis {

std::string origins_html(const Analysis& analysis) {
  if (!analysis.origins) return "";
  const std::vector<std::string> titles = origin_titles(analysis);
  return "<h2 id=\"origins\">Lab and web</h2>\n" + html_paragraph(origin_sentence(analysis)) +
         html_table({{titles[0]},
                     {titles[1]},
                     {titles[2]},
                     {titles[3]},
                     {titles[4]},
                     {titles[5]},
                     {titles[6]},
                     {titles[7]}},
                    origin_lines(analysis));
}

}  // namespace seamline::analysis
