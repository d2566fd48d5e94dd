#include "study/exchange/anonymise.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "stimuli/study_file/study_file.h"
#include "support/arithmetic/random.h"
#include "support/files/hash.h"
#include "support/text/error.h"

namespace seamline::study {
namespace {

constexpr std::int64_t tenth_of_a_second_ns = 100'000'000;
constexpr const char* rare_answer = "other";

std::int64_t coarse(std::int64_t time_ns) {
  return (time_ns + tenth_of_a_second_ns / 2) / tenth_of_a_second_ns * tenth_of_a_second_ns;
}

/// What nobody knows who has only the anonymised log: all answers in full.
std::uint64_t seed_of(const LogContents& log) {
  std::string text = log.set_hash;
  for (const ParticipantRecord& participant : log.participants)
    text += fmt::format("{} {} ", participant.code, participant.last_seen_unix_s);
  for (const Answer& answer : log.answers) text += fmt::format("{} {} ", answer.choice_ns, answer.rating_ns);
  return std::stoull(sha256(text).substr(0, 15), nullptr, 16);
}

std::map<std::string, std::string> new_codes(const LogContents& log) {
  std::vector<std::string> codes;
  for (const ParticipantRecord& participant : log.participants) codes.push_back(participant.code);
  std::sort(codes.begin(), codes.end());
  Random random(seed_of(log));
  shuffle(std::span<std::string>(codes), random);
  std::map<std::string, std::string> renamed;
  for (std::size_t i = 0; i < codes.size(); ++i) renamed[codes[i]] = fmt::format("p{:03}", i + 1);
  return renamed;
}

/// "20-29" of "23"; what is no number as it is.
std::string decade(const std::string& value) {
  try {
    const double number = std::floor(std::stod(value) / 10) * 10;
    return fmt::format("{:.0f}-{:.0f}", number, number + 9);
  } catch (const std::exception&) {
    return value;
  }
}

std::set<std::string> number_fields(const LogContents& log) {
  std::set<std::string> numbers;
  const StudyDefinition study = read_study_text(log.study_text, log.file);
  for (const FormField& field : study.form)
    if (std::holds_alternative<NumberField>(field.kind)) numbers.insert(field.name);
  return numbers;
}

std::string& answer_of(ParticipantRecord& participant, const std::string& field) {
  for (FormAnswer& answer : participant.form)
    if (answer.field == field) return answer.value;
  participant.form.push_back({field, ""});
  return participant.form.back().value;
}

/// Rare answers to one question become "other".
GroupedField group_rare(std::vector<ParticipantRecord>& participants, const std::string& field, int k) {
  std::map<std::string, int> people;
  for (ParticipantRecord& participant : participants) ++people[answer_of(participant, field)];
  std::vector<std::pair<int, std::string>> rarest_first;
  for (const auto& [value, count] : people) rarest_first.emplace_back(count, value);
  std::sort(rarest_first.begin(), rarest_first.end());
  std::set<std::string> rare;
  int others = 0;
  for (const auto& [count, value] : rarest_first)
    if (count < k || (others > 0 && others < k)) {
      rare.insert(value);
      others += count;
    }
  for (ParticipantRecord& participant : participants)
    if (rare.contains(answer_of(participant, field))) answer_of(participant, field) = rare_answer;
  GroupedField grouped{.field = field, .smallest_group = others > 0 ? others : rarest_first.front().first};
  for (const auto& [value, count] : people)
    if (!rare.contains(value)) grouped.smallest_group = std::min(grouped.smallest_group, count);
  grouped.withheld = rare.size() == people.size();
  return grouped;
}

int smallest_combination(const std::vector<ParticipantRecord>& participants) {
  std::map<std::string, int> people;
  for (const ParticipantRecord& participant : participants) {
    std::string all;
    for (const FormAnswer& answer : participant.form) all += answer.field + "=" + answer.value + "\n";
    ++people[all];
  }
  int smallest = 0;
  for (const auto& [all, count] : people) smallest = smallest == 0 ? count : std::min(smallest, count);
  return smallest;
}

template <class Rows>
void rename_and_sort(Rows& rows, const std::map<std::string, std::string>& renamed) {
  for (auto& row : rows) {
    row.participant = renamed.at(row.participant);
    row.choice_ns = coarse(row.choice_ns);
    row.rating_ns = coarse(row.rating_ns);
  }
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
    return std::tie(a.participant, a.trial_index) < std::tie(b.participant, b.trial_index);
  });
}

}  // namespace

AnonymisedLog anonymise(LogContents log, int k) {
  if (k < 2)
    throw input_error(
        {.field = "--k", .wanted = "a group of at least 2 people", .found = fmt::format("{}", k)});
  const std::map<std::string, std::string> renamed = new_codes(log);
  const std::set<std::string> numbers = number_fields(log);
  std::set<std::string> fields;
  for (ParticipantRecord& participant : log.participants) {
    participant.code = renamed.at(participant.code);
    participant.last_seen_unix_s = 0;
    participant.in_progress = false;
    for (FormAnswer& answer : participant.form) {
      fields.insert(answer.field);
      if (numbers.contains(answer.field)) answer.value = decade(answer.value);
    }
  }
  std::sort(log.participants.begin(), log.participants.end(),
            [](const auto& a, const auto& b) { return a.code < b.code; });
  rename_and_sort(log.answers, renamed);
  rename_and_sort(log.catches, renamed);
  AnonymisedLog out;
  for (const std::string& field : fields) out.fields.push_back(group_rare(log.participants, field, k));
  for (ParticipantRecord& participant : log.participants)
    std::sort(participant.form.begin(), participant.form.end(),
              [](const FormAnswer& a, const FormAnswer& b) { return a.field < b.field; });
  out.smallest_combination = smallest_combination(log.participants);
  out.log = std::move(log);
  return out;
}

}  // namespace seamline::study
