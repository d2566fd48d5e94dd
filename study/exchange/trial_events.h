#pragma once
#include <functional>
#include <string>
#include <utility>

#include "study/log/log.h"

namespace seamline::study {

/// A participant's code and the index of a trial.
using TrialOfPerson = std::pair<std::string, int>;

/// Whether the study's task, or that of a condition, has something.
[[nodiscard]] bool some_task(const LogContents& log, const std::function<bool(const TaskDefinition&)>& has);

/// Reads the events of a kind of answered trials, practice left out, in the order in which they were noted:
/// `take` gets whose trial it is and the event's detail, and returns false where it cannot read that. Throws
/// InputError when the log cannot be read, or at such a detail, which then should have been `wanted`.
void read_trial_events(
    const LogContents& log, const std::string& kind, const std::string& wanted,
    const std::function<bool(const TrialOfPerson& trial, const std::string& detail)>& take);

}  // namespace seamline::study
