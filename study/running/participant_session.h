#pragma once
#include <cstdint>

#include "study/log/log_writer.h"
#include "study/trials/participant_trials.h"

namespace seamline::study {

// Between a participant's trials, which are decided in study/trials/participant_trials.h, and the log, which
// keeps them. A session of a person or of a simulated one:
//
//     const TrialRules rules = make_trial_rules(set);
//     OpenSession place = enter_session(log, enrolment, set.study.session.orders);
//     Session session = begin_session(open_trials(rules, log, place), pace);
//     while there is a trial:  store_due_trial(session.trials, log, place);   before its image is shown
//                              log.append_answer(place, answer);              when it is answered
//     store_edge_alarms(session.trials.procedure, log, place, now_ns);  log.complete(place);

/// Begins a session of a participant whom the log knows, or of a newcomer, who gets `newcomer_slot` among
/// `orders` whatever the enrolment says. Throws InputError as LogWriter::open_session does.
[[nodiscard]] OpenSession enter_session(LogWriter& log, Enrolment enrolment, int orders);

/// The trials of a participant, at the first one without an answer; those that are decided before the session
/// are in the log then.
[[nodiscard]] TrialSequence open_trials(const TrialRules& rules, LogWriter& log, OpenSession& place);

/// Stores the trial that is due unless the log has it, so that a session that breaks off while its image is
/// shown goes on with the same image. The log always has those of constant stimuli.
void store_due_trial(const TrialSequence& trials, LogWriter& log, OpenSession& place);

/// An event `edge_alarm` for each track whose posterior leans on the grid's edge (`edge_alarms`), and how
/// many tracks' thresholds do.
struct EdgeEvents {
  std::vector<RawEvent> events = {};
  int thresholds = 0;
};
[[nodiscard]] EdgeEvents edge_events(const Procedure& procedure, std::int64_t now_ns);

/// Writes an event `edge_alarm` for each track whose posterior leans on the grid's edge (`edge_alarms`);
/// returns the number of tracks whose threshold does.
int store_edge_alarms(const Procedure& procedure, LogWriter& log, const OpenSession& place,
                      std::int64_t now_ns);

}  // namespace seamline::study
