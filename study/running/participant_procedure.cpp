#include "study/running/participant_procedure.h"

#include <algorithm>

#include "study/trials/catch_plan.h"
#include "study/trials/trial_order.h"
#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

/// Keeps the draws of adaptive procedures apart from those of the plan and of the renderer.
constexpr std::uint64_t quest_plus_salt = 0x71756573742b;  // "quest+"

std::shared_ptr<const QuestPlusDesign> design_of(const StudySet& set, const std::vector<Stimulus>& stimuli) {
  const auto* definition = std::get_if<QuestPlusDefinition>(&set.study.procedure);
  if (definition == nullptr) return nullptr;
  return std::make_shared<QuestPlusDesign>(make_quest_plus_design(*definition, stimuli));
}

std::uint64_t participant_seed(std::uint64_t study_seed, int slot) {
  return Random(mix_bits(study_seed ^ quest_plus_salt), static_cast<std::uint64_t>(slot)).bits();
}

/// The trials of the procedure among those of the log, and their answers as the procedure numbers them.
struct OwnTrials {
  std::vector<int> planned;
  std::vector<TrialAnswer> answers;
};

OwnTrials own_trials(const OpenSession& place) {
  OwnTrials own;
  for (std::size_t trial = 0; trial < place.planned.size(); ++trial) {
    if (place.planned[trial].kind != TrialKind::stimulus) continue;
    own.planned.push_back(place.planned[trial].stimulus);
    if (trial >= place.answers.size()) continue;
    own.answers.push_back(place.answers[trial]);
    own.answers.back().trial_index = static_cast<int>(own.answers.size()) - 1;
  }
  return own;
}

/// Those that the log has planned, then the rest of those that are due to come.
std::vector<CatchTrial> catches_after(const std::vector<PlannedTrial>& planned,
                                      const std::vector<CatchTrial>& schedule) {
  std::vector<CatchTrial> catches = catches_of(planned);
  for (std::size_t i = catches.size(); i < schedule.size(); ++i) catches.push_back(schedule[i]);
  return catches;
}

Procedure procedure_at(const ProcedurePlan& plan, int slot, const OwnTrials& own) {
  if (plan.quest_plus)
    return resume_quest_plus(begin_quest_plus(plan.quest_plus, participant_seed(plan.study_seed, slot)),
                             own.planned, own.answers);
  return ConstantProcedure{.order = own.planned, .answered = static_cast<int>(own.answers.size())};
}

}  // namespace

ProcedurePlan make_procedure_plan(const StudySet& set) {
  ProcedurePlan plan{.study_seed = set.study.seed, .catches = set.study.catches};
  for (const ManifestStimulus& record : set.manifest.stimuli) plan.stimuli.push_back(record.stimulus);
  plan.quest_plus = design_of(set, plan.stimuli);
  return plan;
}

TrialSequence open_trials(const ProcedurePlan& plan, LogWriter& log, OpenSession& place) {
  const PlanKey key{.study_seed = plan.study_seed, .slot = place.slot};
  const int stimuli = static_cast<int>(plan.stimuli.size());
  if (!plan.quest_plus && place.planned.empty())
    log.plan_trials(
        place, interleave(plan_order(stimuli, key), plan_catches(plan.catches, plan.stimuli, stimuli, key)));
  const OwnTrials own = own_trials(place);
  TrialSequence trials{.procedure = procedure_at(plan, place.slot, own)};
  std::vector<CatchTrial> schedule;
  if (plan.quest_plus) {
    const int most = most_trials(begin_quest_plus(plan.quest_plus, 0));
    schedule = plan_catches(plan.catches, plan.stimuli, most, key);
  }
  trials.catches = catches_after(place.planned, schedule);
  trials.catches_answered = place.answered - static_cast<int>(own.answers.size());
  return trials;
}

void plan_due_trial(const TrialSequence& trials, LogWriter& log, OpenSession& place) {
  const std::optional<PlannedTrial> due = current_trial(trials);
  if (!due || static_cast<int>(place.planned.size()) > answered_trials(trials)) return;
  log.plan_trials(place, std::span<const PlannedTrial>(&*due, 1));
}

int record_edge_alarms(const Procedure& procedure, LogWriter& log, const OpenSession& place,
                       std::int64_t now_ns) {
  const auto* quest_plus = std::get_if<QuestPlusProcedure>(&procedure);
  if (quest_plus == nullptr) return 0;
  const QuestPlusDesign& design = *quest_plus->design;
  std::vector<RawEvent> events;
  int thresholds = 0;
  for (std::size_t t = 0; t < design.tracks.size(); ++t) {
    const std::vector<EdgeAlarm> alarms =
        edge_alarms(design.grid, quest_plus->tracks[t].posterior, design.definition.edge_share);
    for (const EdgeAlarm& alarm : alarms)
      events.push_back({.monotonic_ns = now_ns,
                        .kind = "edge_alarm",
                        .trial_index = {},
                        .detail = name_of(design.tracks[t]) + ": " + text(alarm)});
    thresholds += std::any_of(alarms.begin(), alarms.end(),
                              [](const EdgeAlarm& alarm) { return alarm.parameter == Parameter::threshold; });
  }
  if (!events.empty()) log.append_events(place, events);
  return thresholds;
}

}  // namespace seamline::study
