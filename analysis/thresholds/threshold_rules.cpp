#include "analysis/thresholds/threshold_rules.h"

#include <fmt/format.h>

namespace seamline::analysis {

namespace {

std::string place_text(const ThresholdRule& rule) {
  const char* curve = rule.estimator == Estimator::isotonic ? "isotonic regression"
                                                            : "four-parameter logistic (least squares)";
  return rule.level ? fmt::format("where the {} of mean noticeability equals {:.1f}", curve, *rule.level)
                    : fmt::format("the centre of the {} of mean noticeability", curve);
}

std::string method_text(IntervalMethod method) {
  switch (method) {
    case IntervalMethod::score_test:
      return "an inverted score test";
    case IntervalMethod::expanded_percentile:
      return "the expanded percentile bootstrap";
  }
  return "";
}

}  // namespace

std::string names_with(IntervalMethod method) {
  std::vector<std::string> names;
  for (const ThresholdRule& rule : threshold_rules)
    if (rule.interval == method) names.emplace_back(rule.name);
  return fmt::format("{}", fmt::join(names, " and "));
}

std::string intervals_in_short() {
  std::string text = fmt::format("{:g} %:", 100 * confidence);
  for (const IntervalMethod method : {IntervalMethod::score_test, IntervalMethod::expanded_percentile})
    if (const std::string names = names_with(method); !names.empty())
      text += fmt::format("{} {} by {}", text.ends_with(':') ? "" : ",", names, method_text(method));
  return text + " over participants";
}

std::vector<std::string> sentences_of_rules() {
  std::vector<std::string> sentences;
  for (const ThresholdRule& rule : threshold_rules)
    sentences.push_back(
        fmt::format("{}: {}; interval of {:g} % by {} over participants; this estimator is of "
                    "record, others stand beside it",
                    rule.name, place_text(rule), 100 * confidence, method_text(rule.interval)));
  sentences.emplace_back(
      "estimates: one is given exactly where its interval is closed; else a bound in words");
  sentences.push_back(fmt::format(
      "several thresholds: each stands by itself with its interval of {:g} %; none is adjusted for "
      "their number",
      100 * confidence));
  return sentences;
}

}  // namespace seamline::analysis
