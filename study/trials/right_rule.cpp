#include "study/trials/right_rule.h"

#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

/// Keeps these draws apart from those of the order, which has the same key.
constexpr std::uint64_t right_salt = 0x7269676874;  // "right"

}  // namespace

RightRule right_rule(const TaskFacts& task, std::uint64_t study_seed, int slot) {
  return {.task = task,
          .seed = Random(mix_bits(study_seed ^ right_salt), static_cast<std::uint64_t>(slot)).bits()};
}

int right_index_of(const RightRule& rule, const Trial& trial, int trial_index) {
  const bool nothing = trial.kind == TrialKind::reference;
  if (rule.task.right_is_yes) return nothing ? 2 : 1;
  if (!rule.task.draws_right || nothing) return 0;
  Random random(rule.seed, static_cast<std::uint64_t>(trial_index));
  return 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(rule.task.alternatives)));
}

std::vector<Trial> shown_pictures(const TaskFacts& task, const Trial& trial) {
  const Trial own{.kind = trial.kind, .stimulus = trial.stimulus};
  if (!task.draws_right) return {own};
  std::vector<Trial> shown(static_cast<std::size_t>(task.alternatives),
                           {.kind = TrialKind::reference, .stimulus = trial.stimulus});
  if (trial.right_index >= 1) shown.at(static_cast<std::size_t>(trial.right_index - 1)) = own;
  return shown;
}

}  // namespace seamline::study
