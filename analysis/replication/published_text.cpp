#include "analysis/replication/published_text.h"

#include <fmt/format.h>

namespace seamline::analysis {
namespace {

std::string value_in_words(const PublishedThreshold& one) {
  std::string words = std::string(word(one.artifact));
  if (!one.condition.empty()) words += " " + one.condition;
  words += " " + one.quantity + " ";
  words += one.level ? fmt::format("{:.10g}", *one.level) : "not reported";
  if (one.low && one.high) words += fmt::format(" ({:.10g} to {:.10g})", *one.low, *one.high);
  return words;
}

}  // namespace

std::string rule_of_published(const std::vector<PublishedThreshold>& published, double margin) {
  std::string values;
  for (const PublishedThreshold& one : published)
    values += (values.empty() ? "" : ", ") + value_in_words(one);
  return fmt::format(
      "laid beside published thresholds: {}; agreeing within {:.10g} (octaves, or the unit of the level)",
      values, margin);
}

}  // namespace seamline::analysis
