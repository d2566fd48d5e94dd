#include "analysis/thresholds/threshold_rules.h"

#include <fmt/format.h>

namespace seamline::analysis {

namespace {

std::string place_text(const ThresholdRule& rule) {
  if (rule.estimator == CurveEstimator::joint)
    return fmt::format("where {}, by the joint model of seeing, guessing and rating", rule.meaning);
  const char* curve = rule.estimator == CurveEstimator::isotonic ? "isotonic regression"
                                                                 : "four-parameter logistic (least squares)";
  return rule.level ? fmt::format("where the {} of mean noticeability equals {:.1f}", curve, *rule.level)
                    : fmt::format("the centre of the {} of mean noticeability", curve);
}

std::string method_text(IntervalMethod method) {
  switch (method) {
    case IntervalMethod::jackknife_test:
      return "a test with the jackknife's variance";
    case IntervalMethod::jackknife:
      return "the jackknife";
    case IntervalMethod::score_test:
      return "an inverted score test";
    case IntervalMethod::expanded_percentile:
      return "the expanded percentile bootstrap";
  }
  return "";
}

std::string sentence_of(const ThresholdRule& rule, const char* prefix, const char* standing) {
  return fmt::format("{}{}: {}; interval of {:g} % by {} over participants{}", prefix, rule.name,
                     place_text(rule), 100 * confidence, method_text(rule.interval), standing);
}

}  // namespace

std::string names_with(IntervalMethod method) {
  std::vector<std::string> names;
  for (const ThresholdRule& rule : paper_rules)
    if (rule.interval == method) names.emplace_back(rule.name);
  return fmt::format("{}", fmt::join(names, " and "));
}

std::string intervals_in_short() {
  std::string text =
      fmt::format("{:g} % over participants: joint model by {}; paper's way:", 100 * confidence,
                  method_text(IntervalMethod::jackknife_test));
  for (const IntervalMethod method : {IntervalMethod::score_test, IntervalMethod::expanded_percentile})
    if (const std::string names = names_with(method); !names.empty())
      text += fmt::format("{} {} by {}", text.ends_with(':') ? "" : ",", names, method_text(method));
  return text;
}

std::vector<std::string> sentences_of_rules() {
  std::vector<std::string> sentences;
  for (const ThresholdRule& rule : threshold_rules) sentences.push_back(sentence_of(rule, "", "; of record"));
  for (const ThresholdRule& rule : paper_rules)
    sentences.push_back(sentence_of(rule, "paper's way, ", "; beside those of record"));
  sentences.emplace_back(
      "estimates: one is given exactly where its interval is closed; else a bound in words");
  sentences.push_back(
      fmt::format("several thresholds: each has an interval of {:g} % of its own; of record, one beside it "
                  "holds together "
                  "with those of all curves",
                  100 * confidence));
  return sentences;
}

}  // namespace seamline::analysis
