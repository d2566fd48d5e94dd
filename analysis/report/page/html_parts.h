#pragma once
#include <string>
#include <vector>

#include "analysis/report/figures/figures.h"

namespace seamline::analysis {

/// A column of a table on the page.
struct HtmlColumn {
  std::string title;
  bool number = false;    ///< to the right
  bool sentence = false;  ///< wraps, and is not bold
};

/// A table of text cells, all escaped; the first cell of a line is its header. `style`: a class of the style
/// sheet, such as "tight" for many columns.
[[nodiscard]] std::string html_table(const std::vector<HtmlColumn>& columns,
                                     const std::vector<std::vector<std::string>>& lines,
                                     const std::string& style = {});

/// An escaped paragraph.
[[nodiscard]] std::string html_paragraph(const std::string& text);

/// The figure of that name with its caption; empty when there is none.
[[nodiscard]] std::string figure_html(const std::vector<Figure>& figures, const std::string& name);

/// "12.3 s"; a dash when it is not known.
[[nodiscard]] std::string seconds_text(double seconds);

/// "45 %"; a dash when it is not known.
[[nodiscard]] std::string percent_text(double share);

/// A number with that many digits after the point; a dash when it is not finite.
[[nodiscard]] std::string decimal_text(double value, int digits);

}  // namespace seamline::analysis
