#include "analysis/screening/screening.h"

#include <fmt/format.h>

#include <algorithm>

namespace seamline::analysis {

namespace {

template <class Test>
std::vector<std::string> codes_of(const std::vector<ScreenedPerson>& people, Test test) {
  std::vector<std::string> codes;
  for (const ScreenedPerson& person : people)
    if (test(person)) codes.push_back(person.code);
  return codes;
}

}  // namespace

std::string_view word(ScreeningRule rule) {
  switch (rule) {
    case ScreeningRule::attention:
      return "attention";
    case ScreeningRule::kurtosis:
      return "kurtosis";
    case ScreeningRule::correlation:
      return "correlation";
  }
  return "";
}

std::string_view rule_of(ScreeningRule rule) {
  switch (rule) {
    case ScreeningRule::attention:
      return "attention: right in fewer than 75 % of the catch trials";
    case ScreeningRule::kurtosis:
      return "kurtosis (ITU-R BT.500): over 5 % of scores at least 2 S (kurtosis 2 to 4) or sqrt(20) S "
             "(else) from the mean of all, and these on both sides, |P - Q| / (P + Q) under 0.3";
    case ScreeningRule::correlation:
      return "correlation: Pearson correlation over stimuli with the mean of the others not above what "
             "somebody who looks at nothing exceeds in 0.1 % of cases (0.33 for 84 stimuli); like kurtosis "
             "judged only where fewer than 1 % of honest people, simulated by the study's own answers, "
             "would be named";
  }
  return "";
}

bool ScreenedPerson::named_by(ScreeningRule rule) const {
  switch (rule) {
    case ScreeningRule::attention:
      return attention.rejected;
    case ScreeningRule::kurtosis:
      return kurtosis.rejected;
    case ScreeningRule::correlation:
      return correlation.rejected;
  }
  return false;
}

bool ScreenedPerson::named() const {
  return std::any_of(every_screening_rule.begin(), every_screening_rule.end(),
                     [&](ScreeningRule rule) { return named_by(rule); });
}

std::vector<std::string> Screening::named_by(ScreeningRule rule) const {
  return codes_of(people, [&](const ScreenedPerson& person) { return person.named_by(rule); });
}

std::vector<std::string> Screening::named() const {
  return codes_of(people, [](const ScreenedPerson& person) { return person.named(); });
}

bool Screening::judged(ScreeningRule rule) const {
  return rule == ScreeningRule::attention ? catch_trials : honest_share(honest, rule) < most_honest_named;
}

std::pair<double, double> Screening::critical_correlations() const {
  std::pair<double, double> range;
  for (const ScreenedPerson& person : people) {
    const double critical = person.correlation.critical;
    if (&person == &people.front()) range = {critical, critical};
    range = {std::max(range.first, critical), std::min(range.second, critical)};
  }
  return range;
}

double honest_share(const HonestNaming& honest, ScreeningRule rule) {
  return rule == ScreeningRule::kurtosis ? honest.kurtosis : honest.correlation;
}

std::string why_not_judged(const Screening& screening, ScreeningRule rule) {
  if (screening.judged(rule)) return "";
  if (rule == ScreeningRule::attention) return "no catch trials";
  if (screening.honest.simulated == 0) return "fewer than three people";
  return fmt::format("{}it would name {} of honest people",
                     rule == ScreeningRule::correlation ? "too little was visible: " : "",
                     honest_share_text(screening.honest, rule));
}

std::string honest_share_text(const HonestNaming& honest, ScreeningRule rule) {
  const double percent = 100 * honest_share(honest, rule);
  return percent < 0.01 ? "under 0.01 %" : fmt::format("{:.2g} %", percent);
}

std::string limit_text(const Screening& screening) {
  const auto [most, least] = screening.critical_correlations();
  const std::string high = fmt::format("{:.2f}", most), low = fmt::format("{:.2f}", least);
  return high == low ? high : low + " to " + high;
}

Screening screen_participants(const ScoreMatrix& scores, const std::vector<CatchAnswer>& catches) {
  Screening screening;
  screening.catch_trials = !catches.empty();
  screening.honest = simulate_honest_people(scores);
  const bool by_kurtosis = screening.judged(ScreeningRule::kurtosis),
             by_correlation = screening.judged(ScreeningRule::correlation);
  const std::vector<KurtosisCount> kurtosis = screen_by_kurtosis(scores.score);
  const std::vector<CorrelationCheck> correlation = screen_by_correlation(scores.score, scores.cell);
  for (std::size_t p = 0; p < scores.people.size(); ++p) {
    ScreenedPerson person{
        .code = scores.people[p], .attention = {}, .kurtosis = kurtosis[p], .correlation = correlation[p]};
    person.kurtosis.rejected = person.kurtosis.rejected && by_kurtosis;
    person.correlation.rejected = person.correlation.rejected && by_correlation;
    for (const CatchAnswer& answer : catches) {
      if (answer.participant != person.code) continue;
      ++person.attention.shown;
      person.attention.right += answer.right ? 1 : 0;
    }
    person.attention.rejected = person.attention.right < least_attention_share * person.attention.shown;
    screening.people.push_back(person);
  }
  return screening;
}

}  // namespace seamline::analysis
