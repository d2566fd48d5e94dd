#include "study/running/participant_session.h"

#include <algorithm>

#include "study/trials/stimulus_order.h"

namespace seamline::study {

OpenSession enter_session(LogWriter& log, Enrolment enrolment, int orders) {
  OpenSession place;
  log.transaction([&] {  // nobody else takes the slot meanwhile
    enrolment.slot = newcomer_slot(orders, log.held_slots(enrolment));
    place = log.open_session(enrolment);
  });
  return place;
}

TrialSequence open_trials(const TrialRules& rules, LogWriter& log, OpenSession& place) {
  const std::vector<Trial> decided = decided_trials(rules, place.slot, place.trials);
  const auto is_new = std::span(decided).subspan(place.trials.size());
  if (!is_new.empty()) log.append_trials(place, is_new);
  return trial_sequence(rules, {.slot = place.slot, .trials = place.trials, .answers = place.answers});
}

void store_due_trial(const TrialSequence& trials, LogWriter& log, OpenSession& place) {
  const std::optional<Trial> due = undecided_trial(trials, static_cast<int>(place.trials.size()));
  if (due) log.append_trials(place, std::span<const Trial>(&*due, 1));
}

EdgeEvents edge_events(const Procedure& procedure, std::int64_t now_ns) {
  const auto* quest_plus = std::get_if<QuestPlusProcedure>(&procedure);
  if (quest_plus == nullptr) return {};
  const QuestPlusDesign& design = *quest_plus->design;
  EdgeEvents found;
  for (std::size_t t = 0; t < design.tracks.size(); ++t) {
    const std::vector<EdgeAlarm> alarms =
        edge_alarms(design.grid, quest_plus->tracks[t].posterior, design.definition.edge_share);
    for (const EdgeAlarm& alarm : alarms)
      found.events.push_back({.monotonic_ns = now_ns,
                              .kind = "edge_alarm",
                              .trial_index = {},
                              .detail = name_of(design.tracks[t]) + ": " + text(alarm)});
    found.thresholds += std::any_of(alarms.begin(), alarms.end(), [](const EdgeAlarm& alarm) {
      return alarm.parameter == Parameter::threshold;
    });
  }
  return found;
}

int store_edge_alarms(const Procedure& procedure, LogWriter& log, const OpenSession& place,
                      std::int64_t now_ns) {
  const EdgeEvents found = edge_events(procedure, now_ns);
  if (!found.events.empty()) log.append_events(place, found.events);
  return found.thresholds;
}

}  // namespace seamline::study
