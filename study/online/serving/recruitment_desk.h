#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "stimuli/definition/people/recruitment_definition.h"
#include "study/log/now.h"
#include "study/log/online/recruits.h"
#include "study/online/intake/intake.h"

namespace seamline::study::online {

/// What a page is told at the end: why, with which code, and where to go. Code and link may be empty.
struct VisitEnd {
  VisitOutcome outcome = VisitOutcome::finished;
  std::string code = {};
  std::string link = {};
};

/// Why somebody is not let in: a Refusal for which the page has words of its own, perhaps with a way back.
class NoEntry : public Refusal {
 public:
  NoEntry(std::string reason, const std::string& sentence, std::optional<VisitEnd> end = {})
      : Refusal(RefusalKind::unknown, {.field = sentence}),
        reason_(std::move(reason)),
        end_(std::move(end)) {}
  [[nodiscard]] const std::string& reason() const { return reason_; }
  [[nodiscard]] const std::optional<VisitEnd>& end() const { return end_; }

 private:
  std::string reason_;
  std::optional<VisitEnd> end_;
};

/// How full a quota is.
struct QuotaState {
  std::string people_who;  ///< "gender = female"
  int people = 0, most_people = 0;
};

/// Matches people with their panel and decides how a visit ends ([recruitment]). Asked from the one thread
/// that writes the log, inside its transactions, and kept in a file of its own (`Recruits`) before the log
/// commits, so that nothing is ever in the log whose end is not known. What a transaction that failed had
/// kept is kept again, alike, when it comes again.
class RecruitmentDesk {
 public:
  /// `clock`: seconds since 1970.
  RecruitmentDesk(const RecruitmentDefinition& recruitment, const std::filesystem::path& log, bool pilot,
                  std::function<std::int64_t()> clock = now_unix_s);

  /// Throws NoEntry unless whoever has these identifiers may begin with this message: identifiers are
  /// missing, the same person took part, the closing date has passed, or enough people take part.
  void check_entry(Intake& intake, const Message& message,
                   const std::map<std::string, std::string>& identifiers);
  void enter(const std::string& code, const std::map<std::string, std::string>& identifiers);
  /// Screens, then looks at the quotas.
  void after_form(Intake& intake, const std::string& code, std::span<const FormAnswer> answers);
  void after_completion(Intake& intake, const std::string& code);
  /// None: not at the end.
  [[nodiscard]] std::optional<VisitEnd> end_of(const std::string& code);
  /// Whether they were sent away after the form: nothing more is stored of them.
  [[nodiscard]] bool was_sent_away(const std::string& code) const;
  [[nodiscard]] VisitEnd decline(const std::map<std::string, std::string>& identifiers) const;

  [[nodiscard]] const std::map<std::string, VisitOutcome>& outcomes() const { return outcomes_; }
  /// The whole study first, where it has an end, then each quota.
  [[nodiscard]] std::vector<QuotaState> quotas(Intake& intake) const;
  [[nodiscard]] const RecruitmentDefinition& recruitment() const { return recruitment_; }

 private:
  [[nodiscard]] std::string person_of(const std::map<std::string, std::string>& identifiers) const;
  /// Finished well, or at it and heard of lately; `rule`: none for everybody. But for `except`.
  [[nodiscard]] int people(const std::vector<OnlineStanding>& standings, const FormRule* rule,
                           const std::string& except) const;
  void end(const std::string& code, VisitOutcome outcome);
  [[nodiscard]] VisitEnd end_with(VisitOutcome outcome, const std::string& code,
                                  const std::map<std::string, std::string>& identifiers) const;

  RecruitmentDefinition recruitment_;
  bool pilot_;
  std::function<std::int64_t()> clock_;
  Recruits recruits_;
  std::map<std::string, VisitOutcome> outcomes_;  ///< by participant
};

}  // namespace seamline::study::online
