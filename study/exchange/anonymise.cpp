#include "study/exchange/anonymise.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string_view>
#include <tuple>

#include "stimuli/definition/people/form_kinds.h"
#include "stimuli/study_file/study_file.h"
#include "study/exchange/clip_records.h"
#include "study/exchange/slider_records.h"
#include "support/arithmetic/random.h"
#include "support/files/hash.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::study {
namespace {

constexpr std::int64_t tenth_of_a_second_ns = 100'000'000;
constexpr const char* rare_answer = "other";
constexpr const char* withheld_answer = "withheld";

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
    if (number_of(field)) numbers.insert(field.name);
  return numbers;
}

std::string& answer_of(ParticipantRecord& participant, const std::string& field) {
  for (FormAnswer& answer : participant.form)
    if (answer.field == field) return answer.value;
  participant.form.push_back({field, ""});
  return participant.form.back().value;
}

using People = std::vector<ParticipantRecord*>;

std::map<std::string, int> counts_of(const People& people, const std::string& field) {
  std::map<std::string, int> counts;
  for (ParticipantRecord* person : people) ++counts[answer_of(*person, field)];
  return counts;
}

/// Rare answers to one question become "other".
void group_rare(const People& people, const std::string& field, int k) {
  const std::map<std::string, int> counts = counts_of(people, field);
  std::vector<std::pair<int, std::string>> rarest_first;
  for (const auto& [value, count] : counts) rarest_first.emplace_back(count, value);
  std::sort(rarest_first.begin(), rarest_first.end());
  std::set<std::string> rare;
  int others = 0;
  for (const auto& [count, value] : rarest_first)
    if (count < k || (others > 0 && others < k)) {
      rare.insert(value);
      others += count;
    }
  for (ParticipantRecord* person : people)
    if (rare.contains(answer_of(*person, field))) answer_of(*person, field) = rare_answer;
}

/// Everything of a person's row but the code and the form, as far as the table keeps it.
std::string state_of(const ParticipantRecord& person, bool with_origin) {
  return fmt::format("{} {} {} {}", person.completed, person.excluded, person.pilot,
                     with_origin ? word(person.origin) : "");
}

/// The answers of the form, the first `withheld` of `fields` withheld.
std::string grouped_row_of(ParticipantRecord& person, const std::vector<std::string>& fields,
                           std::size_t withheld) {
  std::string row;
  for (std::size_t i = withheld; i < fields.size(); ++i) row += answer_of(person, fields[i]) + "\n";
  return row;
}

void withhold(const People& people, const std::vector<std::string>& fields, std::size_t count) {
  for (ParticipantRecord* person : people)
    for (std::size_t i = 0; i < count; ++i) answer_of(*person, fields[i]) = withheld_answer;
}

/// Withholds answers of at least `k` people until everybody's row is that of `k`. Each keeps as many
/// questions as go with `k` - 1 others who are left; those who are left over at last take others with them.
void withhold_until_alike(People left, std::vector<std::string> fields, int k) {
  const std::size_t size = k;
  std::map<std::string, std::size_t> different;
  for (const std::string& field : fields) different[field] = counts_of(left, field).size();
  std::stable_sort(fields.begin(), fields.end(),
                   [&](const std::string& a, const std::string& b) { return different[a] > different[b]; });
  std::vector<People> groups;
  for (std::size_t withheld = 0; withheld <= fields.size() && !left.empty(); ++withheld) {
    std::map<std::string, People> alike;
    for (ParticipantRecord* person : left) alike[grouped_row_of(*person, fields, withheld)].push_back(person);
    left.clear();
    for (auto& [row, people] : alike)
      if (people.size() >= size) {
        withhold(people, fields, withheld);
        groups.push_back(std::move(people));
      } else {
        left.insert(left.end(), people.begin(), people.end());
      }
  }
  if (left.empty()) return;
  // Fewer than k have nothing in common with k others: some of the largest group, or all of it.
  People& largest = *std::max_element(groups.begin(), groups.end(),
                                      [](const People& a, const People& b) { return a.size() < b.size(); });
  const std::size_t missing = size - left.size();
  const std::size_t taken = largest.size() >= size + missing ? missing : largest.size();
  left.insert(left.end(), largest.end() - taken, largest.end());
  withhold(left, fields, fields.size());
}

int smallest(const std::map<std::string, int>& counts) {
  int found = 0;
  for (const auto& [what, count] : counts) found = found == 0 ? count : std::min(found, count);
  return found;
}

People people_of(LogContents& log) {
  People people;
  for (ParticipantRecord& participant : log.participants)
    if (!participant.simulated) people.push_back(&participant);
  return people;
}

/// Forgets whoever `leave_out` says, with their answers.
template <class LeaveOut>
void leave_out_people(LogContents& log, const LeaveOut& leave_out) {
  std::set<std::string> codes;
  for (const ParticipantRecord& participant : log.participants)
    if (leave_out(participant)) codes.insert(participant.code);
  const auto is_theirs = [&](const auto& row) { return codes.contains(row.participant); };
  std::erase_if(log.answers, is_theirs);
  std::erase_if(log.catches, is_theirs);
  std::erase_if(log.participants,
                [&](const ParticipantRecord& participant) { return codes.contains(participant.code); });
}

Anonymity leave_out_rare_states(LogContents& log, int k) {
  Anonymity anonymity{.k = k};
  std::map<std::string, int> in_state, in_state_by_origin;
  for (const ParticipantRecord* person : people_of(log)) ++in_state[state_of(*person, false)];
  const auto people = people_of(log).size();
  leave_out_people(log, [&](const ParticipantRecord& participant) {
    return !participant.simulated && in_state.at(state_of(participant, false)) < k;
  });
  anonymity.left_out_people = static_cast<int>(people - people_of(log).size());
  if (log.participants.empty() && people > 0)
    throw input_error(
        {.file = log.file.string(),
         .field = request_name("anonymise"),
         .wanted = fmt::format("at least {} people ({}) who are alike in being finished, excluded "
                               "or on a trial run",
                               k, request_name("k")),
         .found = fmt::format("{} in all", people)});
  for (const ParticipantRecord* person : people_of(log)) ++in_state_by_origin[state_of(*person, true)];
  anonymity.keeps_origin = people_of(log).empty() || smallest(in_state_by_origin) >= k;
  std::set<std::string> unfinished;
  for (const ParticipantRecord* person : people_of(log))
    if (!person->completed) unfinished.insert(person->code);
  const auto is_unfinished = [&](const auto& row) { return unfinished.contains(row.participant); };
  std::erase_if(log.answers, is_unfinished);
  std::erase_if(log.catches, is_unfinished);
  anonymity.unfinished_people = static_cast<int>(unfinished.size());
  return anonymity;
}

/// `rows` in the order of their numbers; nothing where there are none.
template <class Row>
void put_in_order(std::vector<Row>& rows, const std::vector<std::size_t>& order) {
  if (rows.empty()) return;
  std::vector<Row> ordered;
  for (const std::size_t at : order) ordered.push_back(std::move(rows[at]));
  rows = std::move(ordered);
}

/// The numbers from 0 to `count`, by the least key first.
template <class Key>
std::vector<std::size_t> order_by(std::size_t count, const Key& key) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return order;
}

/// Answers in an order that the participants did not see, and what goes with each of them.
void number_again(LogContents& log, Anonymity& anonymity) {
  const auto coarse_times = [](auto& row) {
    row.choice_ns = coarse(row.choice_ns);
    row.rating_ns = coarse(row.rating_ns);
  };
  const auto beside = [](const auto& of_rows, std::size_t at) {
    return of_rows.empty() ? std::nullopt : of_rows[at];
  };
  std::map<std::string, int> next;
  for (Answer& answer : log.answers) coarse_times(answer);
  for (CatchTrialAnswer& answer : log.catches) coarse_times(answer);
  SliderPlaces& slider = anonymity.slider;
  const std::vector<std::size_t> answers = order_by(log.answers.size(), [&](std::size_t at) {
    const Answer& a = log.answers[at];
    return std::tuple(std::string_view(a.participant), std::string_view(a.stimulus_id), a.chosen_index,
                      a.rating, a.choice_ns, a.rating_ns, beside(anonymity.late_clips, at),
                      beside(slider.of_answers, at));
  });
  put_in_order(log.answers, answers);
  put_in_order(anonymity.late_clips, answers);
  put_in_order(slider.of_answers, answers);
  for (Answer& answer : log.answers) answer.trial_index = next[answer.participant]++;
  const std::vector<std::size_t> catches = order_by(log.catches.size(), [&](std::size_t at) {
    const CatchTrialAnswer& c = log.catches[at];
    return std::tuple(std::string_view(c.participant), c.kind, c.right(), c.rating, c.choice_ns, c.rating_ns,
                      beside(slider.of_catches, at));
  });
  put_in_order(log.catches, catches);
  put_in_order(slider.of_catches, catches);
  for (CatchTrialAnswer& answer : log.catches) answer.trial_index = next[answer.participant]++;
}

void give_new_codes(LogContents& log) {
  const std::map<std::string, std::string> renamed = new_codes(log);
  for (ParticipantRecord& participant : log.participants) {
    participant.code = renamed.at(participant.code);
    participant.last_seen_unix_s = 0;
    participant.in_progress = false;
    participant.slot = 0;
    participant.restarts = 0;
  }
  for (Answer& answer : log.answers) answer.participant = renamed.at(answer.participant);
  for (CatchTrialAnswer& answer : log.catches) answer.participant = renamed.at(answer.participant);
  std::sort(log.participants.begin(), log.participants.end(),
            [](const auto& a, const auto& b) { return a.code < b.code; });
}

}  // namespace

AnonymisedLog anonymise(LogContents log, int k) {
  if (k < 2)
    throw input_error({.field = request_name("k"),
                       .wanted = "a group of at least 2 people",
                       .found = fmt::format("{}", k)});
  AnonymisedLog out{.anonymity = leave_out_rare_states(log, k)};
  out.anonymity.late_clips = late_clips(log);
  out.anonymity.slider = slider_places_in_order(log);
  give_new_codes(log);
  number_again(log, out.anonymity);
  const std::set<std::string> numbers = number_fields(log);
  std::set<std::string> fields;
  for (ParticipantRecord& participant : log.participants)
    for (FormAnswer& answer : participant.form) {
      fields.insert(answer.field);
      if (numbers.contains(answer.field)) answer.value = decade(answer.value);
    }
  const People everybody = people_of(log);
  std::map<std::string, People> in_state;
  for (ParticipantRecord* person : everybody)
    in_state[state_of(*person, out.anonymity.keeps_origin)].push_back(person);
  for (const std::string& field : fields) group_rare(everybody, field, k);
  for (const auto& [state, people] : in_state)
    withhold_until_alike(people, {fields.begin(), fields.end()}, k);
  for (const std::string& field : fields) {
    const std::map<std::string, int> counts = counts_of(everybody, field);
    const auto withheld = counts.find(withheld_answer);
    out.fields.push_back({.field = field,
                          .smallest_group = smallest(counts),
                          .withheld_answers = withheld == counts.end() ? 0 : withheld->second,
                          .withheld = std::all_of(counts.begin(), counts.end(), [](const auto& one) {
                            return one.first == rare_answer || one.first == withheld_answer;
                          })});
  }
  std::map<std::string, int> rows;
  for (ParticipantRecord* person : everybody) {
    std::sort(person->form.begin(), person->form.end(),
              [](const FormAnswer& a, const FormAnswer& b) { return a.field < b.field; });
    ++rows[state_of(*person, out.anonymity.keeps_origin) + "\n" +
           grouped_row_of(*person, {fields.begin(), fields.end()}, 0)];
  }
  out.smallest_group = smallest(rows);
  out.log = std::move(log);
  return out;
}

}  // namespace seamline::study
