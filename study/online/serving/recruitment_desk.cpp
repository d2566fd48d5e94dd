#include "study/online/serving/recruitment_desk.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "study/online/serving/tokens.h"

namespace seamline::study::online {
namespace {

constexpr std::size_t random_code_letters = 8;

/// The identifiers that the study names; others of a link are dropped.
std::map<std::string, std::string> named(const RecruitmentDefinition& recruitment,
                                         const std::map<std::string, std::string>& identifiers) {
  std::map<std::string, std::string> kept;
  for (const std::string& name : recruitment.identifiers)
    if (const auto found = identifiers.find(name); found != identifiers.end()) kept.insert(*found);
  return kept;
}

std::string drawn_code(const RecruitmentDefinition& recruitment, VisitOutcome outcome) {
  const auto found = recruitment.codes.find(outcome);
  if (found == recruitment.codes.end()) return {};
  std::string code = found->second;
  const std::string place = "{random}";
  for (std::size_t at = code.find(place); at != std::string::npos; at = code.find(place))
    code.replace(at, place.size(), random_letters().substr(0, random_code_letters));
  return code;
}

std::string rule_text(const FormRule& rule) {
  if (!rule.answers.empty()) return fmt::format("{} = {}", rule.field, fmt::join(rule.answers, " or "));
  return fmt::format("{}{}{}", rule.least ? fmt::format("{} <= ", *rule.least) : "", rule.field,
                     rule.most ? fmt::format(" <= {}", *rule.most) : "");
}

}  // namespace

RecruitmentDesk::RecruitmentDesk(const RecruitmentDefinition& recruitment, const std::filesystem::path& log,
                                 bool pilot, std::function<std::int64_t()> clock)
    : recruitment_(recruitment), pilot_(pilot), clock_(std::move(clock)), recruits_(log) {
  for (const Recruit& recruit : recruits_.everybody())
    if (recruit.outcome) outcomes_[recruit.code] = *recruit.outcome;
}

std::string RecruitmentDesk::person_of(const std::map<std::string, std::string>& identifiers) const {
  if (recruitment_.identifiers.empty()) return {};
  const auto found = identifiers.find(recruitment_.identifiers.front());
  return found == identifiers.end() ? std::string() : found->second;
}

int RecruitmentDesk::people(const std::vector<OnlineStanding>& standings, const FormRule* rule,
                            const std::string& except) const {
  const auto hold_s = static_cast<std::int64_t>(recruitment_.hold_min * 60);
  return static_cast<int>(std::count_if(standings.begin(), standings.end(), [&](const OnlineStanding& one) {
    if (one.code == except || one.excluded || one.pilot != pilot_) return false;
    if (rule != nullptr && !keeps(*rule, one.form)) return false;
    if (const auto ended = outcomes_.find(one.code); ended != outcomes_.end())
      return ended->second == VisitOutcome::finished;
    return one.completed || clock_() - one.last_unix_s <= hold_s;
  }));
}

VisitEnd RecruitmentDesk::end_with(VisitOutcome outcome, const std::string& code,
                                   const std::map<std::string, std::string>& identifiers) const {
  return {
      .outcome = outcome,
      .code = code,
      .link = code.empty() ? "" : filled_return_link(recruitment_, code, named(recruitment_, identifiers))};
}

void RecruitmentDesk::check_entry(Intake& intake, const Message& message,
                                  const std::map<std::string, std::string>& identifiers) {
  const std::string sender = intake.sender_of(message.id);
  if (!sender.empty()) return;  // the same message again: whoever sent it is in
  for (const std::string& name : recruitment_.identifiers)
    if (recruitment_.identifiers_required && !identifiers.contains(name))
      throw NoEntry("link", fmt::format("{} in the link: wanted the one of the panel, found none", name));
  if (const std::string person = person_of(identifiers); !person.empty())
    if (const std::optional<Recruit> before = recruits_.of_person(person)) {
      const std::vector<OnlineStanding> all = intake.standings();  // the log may not have come to keep them
      if (std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.code == before->code; }))
        throw NoEntry("again", "participant: wanted one who has not taken part, found one who has");
    }
  const bool closed = recruitment_.closes_unix_s && clock_() >= *recruitment_.closes_unix_s;
  const bool full =
      recruitment_.most_people > 0 && people(intake.standings(), nullptr, {}) >= recruitment_.most_people;
  if (!closed && !full) return;
  throw NoEntry("full",
                closed ? "study: wanted one that is open, found one whose closing date has passed"
                       : "study: wanted one with free places, found one with enough people",
                end_with(VisitOutcome::full, drawn_code(recruitment_, VisitOutcome::full), identifiers));
}

void RecruitmentDesk::enter(const std::string& code, const std::map<std::string, std::string>& identifiers) {
  if (recruits_.of_code(code)) return;
  recruits_.enter(
      {.code = code, .person = person_of(identifiers), .identifiers = named(recruitment_, identifiers)});
}

void RecruitmentDesk::end(const std::string& code, VisitOutcome outcome) {
  recruits_.end(code, outcome, drawn_code(recruitment_, outcome));
  outcomes_[code] = outcome;
}

void RecruitmentDesk::after_form(Intake& intake, const std::string& code,
                                 std::span<const FormAnswer> answers) {
  for (const FormRule& rule : recruitment_.screen)
    if (!keeps(rule, answers)) return end(code, VisitOutcome::screened_out);
  if (recruitment_.quotas.empty()) return;
  const std::vector<OnlineStanding> standings = intake.standings();
  for (const QuotaDefinition& quota : recruitment_.quotas)
    if (keeps(quota.rule, answers) && people(standings, &quota.rule, code) >= quota.most_people)
      return end(code, VisitOutcome::full);
}

void RecruitmentDesk::after_completion(Intake& intake, const std::string& code) {
  const bool attentive = intake.attention_right(code) >= recruitment_.least_attention;
  end(code, attentive ? VisitOutcome::finished : VisitOutcome::failed_attention);
}

std::optional<VisitEnd> RecruitmentDesk::end_of(const std::string& code) {
  const std::optional<Recruit> recruit = recruits_.of_code(code);
  if (!recruit || !recruit->outcome) return std::nullopt;
  return end_with(*recruit->outcome, recruit->completion_code, recruit->identifiers);
}

bool RecruitmentDesk::was_sent_away(const std::string& code) const {
  const auto found = outcomes_.find(code);
  return found != outcomes_.end() &&
         (found->second == VisitOutcome::screened_out || found->second == VisitOutcome::full);
}

VisitEnd RecruitmentDesk::decline(const std::map<std::string, std::string>& identifiers) const {
  return end_with(VisitOutcome::declined, drawn_code(recruitment_, VisitOutcome::declined), identifiers);
}

std::vector<QuotaState> RecruitmentDesk::quotas(Intake& intake) const {
  const std::vector<OnlineStanding> standings = intake.standings();
  std::vector<QuotaState> states;
  if (recruitment_.most_people > 0)
    states.push_back({.people_who = "everybody",
                      .people = people(standings, nullptr, {}),
                      .most_people = recruitment_.most_people});
  for (const QuotaDefinition& quota : recruitment_.quotas)
    states.push_back({.people_who = rule_text(quota.rule),
                      .people = people(standings, &quota.rule, {}),
                      .most_people = quota.most_people});
  return states;
}

}  // namespace seamline::study::online
