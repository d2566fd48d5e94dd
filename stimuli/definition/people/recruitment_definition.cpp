#include "stimuli/definition/people/recruitment_definition.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace seamline::inline stimuli {
namespace {

constexpr std::array<PageText, 10> recruitment_texts = {{
    {"recruitment_code", "Your completion code: {code}"},
    {"recruitment_back", "Go back to {host}"},
    {"recruitment_finished",
     "You have seen all the pictures and your answers are stored. Use the button or the code below, so that "
     "your part is counted."},
    {"recruitment_declined",
     "You have chosen not to take part. Nothing about you is stored. Please go back with the button or the "
     "code below."},
    {"recruitment_screened_out",
     "Thank you. This study looks for people whose answers to these questions are others, so it ends here for "
     "you."},
    {"recruitment_full",
     "Thank you for coming. Enough people have taken part, or the study is closed, so it ends here for you."},
    {"recruitment_failed_attention",
     "Thank you. Your answers are stored. Some pictures were there to see whether attention was paid, and too "
     "few of them were answered right."},
    {"recruitment_again",
     "Somebody with the number in this link has taken part already. Whoever began goes on in the browser in "
     "which they began."},
    {"recruitment_link",
     "This link does not say who you are ({wanted} is missing). Please open the study from the page that "
     "invited you."},
    {"recruitment_ended", "The study ends here"},
}};

/// RFC 3986, 2.3: what need not be escaped anywhere.
std::string percent_encoded(const std::string& text) {
  std::string encoded;
  for (const char letter : text) {
    const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                       (letter >= '0' && letter <= '9') ||
                       std::string_view("-._~").find(letter) != std::string_view::npos;
    encoded += plain ? std::string(1, letter) : fmt::format("%{:02X}", static_cast<unsigned char>(letter));
  }
  return encoded;
}

}  // namespace

std::string_view word(VisitOutcome outcome) {
  switch (outcome) {
    case VisitOutcome::finished:
      return "finished";
    case VisitOutcome::declined:
      return "declined";
    case VisitOutcome::screened_out:
      return "screened_out";
    case VisitOutcome::full:
      return "full";
    case VisitOutcome::failed_attention:
      return "failed_attention";
  }
  return {};
}

std::optional<VisitOutcome> visit_outcome_from_word(std::string_view text) {
  for (const VisitOutcome outcome : every_visit_outcome)
    if (word(outcome) == text) return outcome;
  return std::nullopt;
}

std::span<const PageText> every_recruitment_text() {
  return recruitment_texts;
}

bool keeps(const FormRule& rule, std::span<const FormAnswer> answers) {
  const auto found = std::find_if(answers.begin(), answers.end(),
                                  [&](const FormAnswer& answer) { return answer.field == rule.field; });
  if (found == answers.end()) return false;
  if (!rule.answers.empty())
    return std::find(rule.answers.begin(), rule.answers.end(), found->value) != rule.answers.end();
  const double number = std::strtod(found->value.c_str(), nullptr);
  return (!rule.least || number >= *rule.least) && (!rule.most || number <= *rule.most);
}

std::string filled_return_link(const RecruitmentDefinition& recruitment, const std::string& code,
                               const std::map<std::string, std::string>& identifiers) {
  std::vector<std::pair<std::string, std::string>> values = {{"code", percent_encoded(code)}};
  for (const std::string& name : recruitment.identifiers) {
    const auto found = identifiers.find(name);
    values.emplace_back(name, found == identifiers.end() ? "" : percent_encoded(found->second));
  }
  std::string link, text = recruitment.return_link;
  for (std::size_t at = 0; at < text.size();) {
    const auto value = std::find_if(values.begin(), values.end(), [&](const auto& one) {
      return text.compare(at, one.first.size() + 2, "{" + one.first + "}") == 0;
    });
    link += value == values.end() ? std::string(1, text[at]) : value->second;
    at += value == values.end() ? 1 : value->first.size() + 2;
  }
  return link;
}

std::string return_host(const RecruitmentDefinition& recruitment) {
  const std::string& link = recruitment.return_link;
  const std::size_t host = link.find("://");
  return host == std::string::npos ? "" : link.substr(0, link.find_first_of("/?#", host + 3));
}

}  // namespace seamline::inline stimuli
