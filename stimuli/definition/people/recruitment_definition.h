#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/definition/form_definition.h"

namespace seamline::inline stimuli {

/// How a visit in a browser ended, as far as whoever pays for it must know.
enum class VisitOutcome {
  finished,      ///< every picture answered
  declined,      ///< no consent
  screened_out,  ///< the form's answers are not those of somebody the study looks for
  full,          ///< enough people like this one took part, or enough people, or the closing date has passed
  failed_attention,  ///< finished, but fewer attention trials right than asked for
};

inline constexpr VisitOutcome every_visit_outcome[] = {VisitOutcome::finished, VisitOutcome::declined,
                                                       VisitOutcome::screened_out, VisitOutcome::full,
                                                       VisitOutcome::failed_attention};

/// "finished", "declined", ...: keys of [recruitment.codes], and words of tables.
[[nodiscard]] std::string_view word(VisitOutcome outcome);
[[nodiscard]] std::optional<VisitOutcome> visit_outcome_from_word(std::string_view text);

/// Answers to one field of the form: some of its options, or numbers of a range, both ends included.
struct FormRule {
  std::string field;
  std::vector<std::string> answers = {};  ///< of a choice
  std::optional<double> least = {}, most = {};
  bool operator==(const FormRule&) const = default;
};

/// At most so many people whose answers keep the rule.
struct QuotaDefinition {
  FormRule rule;
  int most_people = 0;
  bool operator==(const QuotaDefinition&) const = default;
};

/// `[recruitment]`: how people from a panel (Prolific, SONA, MTurk, any other) are matched and sent back.
/// Not part of a study's hash: it changes nothing that people are shown of the pictures, and codes are
/// changed after a pilot.
struct RecruitmentDefinition {
  /// Names in the link whose values are kept (`PROLIFIC_PID`); the first one tells people apart.
  std::vector<std::string> identifiers = {};
  bool identifiers_required = true;  ///< whoever comes without is not let in
  /// Where people are sent at the end: `{code}` and `{NAME}` of an identifier are filled in. Empty: the code
  /// is shown alone.
  std::string return_link = {};
  /// By outcome; `{random}` in one becomes eight letters and digits of this participant's own. An outcome
  /// without a code has no way back.
  std::map<VisitOutcome, std::string> codes = {};
  std::vector<FormRule> screen = {};  ///< every one must be kept
  std::vector<QuotaDefinition> quotas = {};
  int most_people = 0;   ///< finished or at it; 0: as many as come
  double hold_min = 60;  ///< a place is held for somebody unfinished who was heard of in so many minutes
  std::optional<std::int64_t> closes_unix_s = {};  ///< nobody new is let in from then on
  int least_attention = 0;                         ///< attention trials to be answered right
  std::map<std::string, std::string> texts = {};   ///< of `every_recruitment_text`, in place of English

  bool operator==(const RecruitmentDefinition&) const = default;
};

/// A text of the page that only studies with [recruitment] or several languages show: keys of [texts] beside
/// those of interface_texts.h.
struct PageText {
  std::string_view key, english;
};
[[nodiscard]] std::span<const PageText> every_recruitment_text();

/// Whether the answers keep the rule. No answer to the field does not.
[[nodiscard]] bool keeps(const FormRule& rule, std::span<const FormAnswer> answers);

/// The way back: the link with code and identifiers (by name) filled in, each as RFC 3986 has it in a query;
/// empty where there is no link.
[[nodiscard]] std::string filled_return_link(const RecruitmentDefinition& recruitment,
                                             const std::string& code,
                                             const std::map<std::string, std::string>& identifiers);

/// The scheme and host of the way back ("https://app.prolific.com"); empty where there is none.
[[nodiscard]] std::string return_host(const RecruitmentDefinition& recruitment);

}  // namespace seamline::inline stimuli
