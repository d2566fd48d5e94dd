#pragma once
#include <cstdint>
#include <memory>

#include "study/log/log_writer.h"
#include "study/trials/study_set.h"
#include "study/trials/trial_sequence.h"

namespace seamline::study {

// Between the study file's procedure, the log and a session. A session of a person or of a simulated one:
//
//     const ProcedurePlan plan = make_procedure_plan(set);
//     OpenSession place = log.open_session(enrolment);
//     Session session = begin_session(open_trials(plan, log, place), pace);
//     while there is a trial:  plan_due_trial(session.trials, log, place);   before its image is shown
//                              log.append_answer(place, answer);             when it is answered
//     record_edge_alarms(session.trials.procedure, log, place, now_ns);  log.complete(place);

/// What the trials of a set need that is the same for all its participants.
struct ProcedurePlan {
  std::vector<Stimulus> stimuli = {};  ///< of the set
  std::uint64_t study_seed = 1;
  CatchDefinition catches = {};
  std::shared_ptr<const QuestPlusDesign> quest_plus = {};  ///< none: constant stimuli
};

[[nodiscard]] ProcedurePlan make_procedure_plan(const StudySet& set);

/// The trials of a participant, at the first one without an answer. Constant stimuli and their catch trials
/// are planned, all at once, when the log holds no plan yet. What the log has planned is taken from it and
/// not decided again, so the result is, bit for bit, what it was before the session broke off.
[[nodiscard]] TrialSequence open_trials(const ProcedurePlan& plan, LogWriter& log, OpenSession& place);

/// Writes the trial that is due into the log's plan unless it is there, so that a session that breaks off
/// while its image is shown goes on with the same image. Constant stimuli always are there.
void plan_due_trial(const TrialSequence& trials, LogWriter& log, OpenSession& place);

/// Writes an event `edge_alarm` for each track whose posterior leans on the grid's edge (`edge_alarms`);
/// returns the number of tracks whose threshold does.
int record_edge_alarms(const Procedure& procedure, LogWriter& log, const OpenSession& place,
                       std::int64_t now_ns);

}  // namespace seamline::study
