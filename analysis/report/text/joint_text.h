#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/report_numbers.h"

namespace seamline::analysis {

/// Whether the joint model describes choices and ratings, which of its shared parts curves want of their own,
/// and how people differ; a sentence each. Empty without numbers.
[[nodiscard]] std::vector<std::string> joint_check_sentences(const Analysis& analysis);

/// How it was decided what curves share, for methods; empty of one curve.
[[nodiscard]] std::string sharing_method(const Analysis& analysis);

/// With its first letter large.
[[nodiscard]] std::string as_sentence(std::string text);

/// What contrasts of thresholds and slopes conclude, and why there are none; a sentence each.
[[nodiscard]] std::vector<std::string> joint_conclusions(const Analysis& analysis,
                                                         const ReportNumbers& numbers);

}  // namespace seamline::analysis
