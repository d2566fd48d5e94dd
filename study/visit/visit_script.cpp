#include "study/visit/visit_script.h"

#include <algorithm>

#include "stimuli/definition/moving/clip_definition.h"
#include "study/trials/participant_trials.h"
#include "study/trials/training_trials.h"
#include "study/trials/trial_picture.h"

namespace seamline::study {
namespace {

/// Nobody has seen a picture and answered it sooner after its onset: that was a press of before, or of two
/// keys.
constexpr std::int64_t fastest_choice_ns = 100'000'000;

std::int64_t nanoseconds(double seconds) {
  return static_cast<std::int64_t>(seconds * 1e9);
}

/// After which the question is open: once a clip has been shown, where it is asked after it.
double viewing_s(const StudyDefinition& study) {
  const ClipDefinition* clip = study.clip.get();
  if (clip == nullptr || clip->question == ClipQuestion::during) return study.session.minimum_viewing_s;
  return std::max(study.session.minimum_viewing_s, clip->frames / clip->frames_per_s);
}

SessionTask session_task(const RenderedSet& set) {
  const StudyDefinition& study = set.study;
  if (!study.task) return {};
  return {.facts = facts_of(study.task.get()),
          .exposure_ns = nanoseconds(study.task->exposure_s),
          .gap_ns = nanoseconds(study.task->gap_s),
          .ladders = make_trial_rules(set).ladders};
}

}  // namespace

VisitScript make_visit_script(const RenderedSet& set) {
  const StudyDefinition& study = set.study;
  VisitScript script{
      .form = study.form,
      .instruction_pages = static_cast<int>(study.instructions.size()),
      .training = training_trials(set),
      .pace = {.break_every_trials = study.session.break_every_trials,
               .minimum_viewing_ns = std::max(fastest_choice_ns, nanoseconds(viewing_s(study))),
               .inter_trial_ns = nanoseconds(study.session.inter_trial_s),
               .task = session_task(set)},
      .training_rule = right_rule(facts_of(study.task.get()), study.seed, 0)};
  for (std::size_t i = 0; i < script.training.size(); ++i)
    script.training[i].right_index =
        right_index_of(script.training_rule, script.training[i], static_cast<int>(i));
  for (const Trial& trial : script.training) script.training_right.push_back(right_object(set, trial));
  return script;
}

}  // namespace seamline::study
