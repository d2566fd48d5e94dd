#include "analysis/scores/participants.h"

#include <algorithm>
#include <map>

#include "analysis/statistics/interval.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

Use use_of(const study::ParticipantRecord& record, bool include_pilot) {
  if (record.excluded) return Use::excluded;
  if (record.pilot && !include_pilot) return Use::pilot;
  return record.completed ? Use::used : Use::incomplete;
}

double median(std::vector<double> values) {
  return values.empty() ? nan : quantile(values, 0.5);
}

}  // namespace

std::string_view word(Use use) {
  switch (use) {
    case Use::used:
      return "used";
    case Use::excluded:
      return "excluded";
    case Use::pilot:
      return "pilot";
    case Use::incomplete:
      return "incomplete";
    case Use::screened:
      return "screened";
    case Use::vision:
      return "vision";
  }
  return "";
}

std::vector<ParticipantUse> select_participants(const study::LogContents& log, bool include_pilot) {
  std::map<std::string, std::vector<const study::Answer*>> answers_of;
  for (const study::Answer& answer : log.answers) answers_of[answer.participant].push_back(&answer);

  std::vector<ParticipantUse> people;
  for (const study::ParticipantRecord& record : log.participants) {
    const std::vector<const study::Answer*>& answers = answers_of[record.code];
    std::vector<double> choice_s;
    int right = 0;
    for (const study::Answer* answer : answers) {
      right += answer->correct() ? 1 : 0;
      if (!record.simulated) choice_s.push_back(answer->choice_ns * 1e-9);
    }
    people.push_back({.record = record,
                      .use = use_of(record, include_pilot),
                      .answers = static_cast<int>(answers.size()),
                      .correct = answers.empty() ? nan : right / static_cast<double>(answers.size()),
                      .median_choice_s = median(choice_s)});
  }
  return people;
}

bool has_uncorrected_vision(const study::ParticipantRecord& record) {
  return std::find(record.form.begin(), record.form.end(),
                   FormAnswer{.field = vision_question, .value = uncorrected_vision}) != record.form.end();
}

ParticipantCounts count_participants(const std::vector<ParticipantUse>& people) {
  ParticipantCounts counts;
  for (const ParticipantUse& person : people) {
    ++counts.in_log;
    switch (person.use) {
      case Use::used:
        ++counts.used;
        break;
      case Use::excluded:
        ++counts.excluded;
        break;
      case Use::pilot:
        ++counts.pilot;
        break;
      case Use::incomplete:
        ++counts.incomplete;
        break;
      case Use::screened:
        ++counts.screened;
        break;
      case Use::vision:
        ++counts.vision;
        break;
    }
    if (person.use == Use::used && person.record.simulated) ++counts.simulated;
  }
  return counts;
}

std::string_view common_observer(const std::vector<ParticipantUse>& people) {
  std::string_view kind;
  for (const ParticipantUse& person : people) {
    if (person.use != Use::used) continue;
    if (person.record.observer.empty() || (!kind.empty() && kind != person.record.observer)) return {};
    kind = person.record.observer;
  }
  return kind;
}

}  // namespace seamline::analysis
