#include "study/participant_procedure.h"

#include <algorithm>

#include "stimuli/support/random.h"
#include "study/overloaded.h"
#include "study/plan.h"

namespace seamline {
namespace {

/// Keeps the draws of adaptive procedures apart from those of the plan and of the renderer.
constexpr std::uint64_t quest_plus_salt = 0x71756573742b;  // "quest+"

std::shared_ptr<const QuestPlusDesign> design_of(const StudySet& set) {
  const auto* definition = std::get_if<QuestPlusDefinition>(&set.study.procedure);
  if (definition == nullptr) return nullptr;
  std::vector<Stimulus> stimuli;
  for (const ManifestStimulus& record : set.manifest.stimuli) stimuli.push_back(record.stimulus);
  return std::make_shared<QuestPlusDesign>(make_quest_plus_design(*definition, stimuli));
}

std::uint64_t participant_seed(std::uint64_t study_seed, int slot) {
  return Random(mix_bits(study_seed ^ quest_plus_salt), static_cast<std::uint64_t>(slot)).bits();
}

}  // namespace

ProcedurePlan make_procedure_plan(const StudySet& set) {
  return {.stimuli = static_cast<int>(set.manifest.stimuli.size()),
          .study_seed = set.study.seed,
          .quest_plus = design_of(set)};
}

Procedure open_procedure(const ProcedurePlan& plan, LogWriter& log, OpenSession& place) {
  if (plan.quest_plus)
    return resume_quest_plus(begin_quest_plus(plan.quest_plus, participant_seed(plan.study_seed, place.slot)),
                             place.planned, place.answers);
  if (place.planned.empty())
    log.plan_trials(place, plan_order(plan.stimuli, {.study_seed = plan.study_seed, .slot = place.slot}));
  return ConstantProcedure{.order = place.planned, .answered = place.answered};
}

void plan_due_trial(const Procedure& procedure, LogWriter& log, OpenSession& place) {
  const std::optional<int> due = current_stimulus(procedure);
  if (!due || static_cast<int>(place.planned.size()) > answered_trials(procedure)) return;
  log.plan_trials(place, std::span<const int>(&*due, 1));
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

}  // namespace seamline
