#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/report_numbers.h"

namespace seamline::analysis {

/// The method section of a paper about this log, plain text.
struct MethodsText {
  std::vector<std::string> paragraphs;
  std::vector<std::string> references;  ///< of everything that the paragraphs name, in alphabetical order
};

/// Says what was done with this log and nothing else: methods that an adaptive log or a single participant
/// rules out are left out. `clips`: a paragraph on how clips were shown; empty: the stimuli are stills.
[[nodiscard]] MethodsText methods_text(const Analysis& analysis, const ReportNumbers& numbers,
                                       const std::string& clips = {});

/// `REPORT/methods.txt`: paragraphs, then references, separated by blank lines.
[[nodiscard]] std::string plain_text(const MethodsText& methods);

}  // namespace seamline::analysis
