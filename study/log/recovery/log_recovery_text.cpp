#include "study/log/recovery/log_recovery_text.h"

#include <fmt/core.h>

#include "support/text/counted.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

std::string trial_list(const std::vector<int>& trials) {
  std::string text;
  for (std::size_t i = 0; i < trials.size();) {
    std::size_t end = i;
    while (end + 1 < trials.size() && trials[end + 1] == trials[end] + 1) ++end;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", trials[i] + 1);
    if (end > i) text += fmt::format("-{}", trials[end] + 1);
    i = end + 1;
  }
  return text;
}

}  // namespace

std::string recovery_text(const LogRecovery& recovery, const fs::path& damaged, const fs::path& out) {
  const auto count = [](const std::map<std::string, std::int64_t>& rows, const char* table) {
    const auto found = rows.find(table);
    return found == rows.end() ? std::int64_t{0} : found->second;
  };
  std::string text = fmt::format("{}: saved {} and {} into {}\n", damaged.string(),
                                 counted(count(recovery.saved, "participants"), "participant"),
                                 counted(count(recovery.saved, "answers"), "answer"), out.string());
  std::size_t missing = 0;
  for (const LostAnswers& person : recovery.participants) {
    missing += person.missing_trials.size() + (person.completed && person.trials == 0 ? 1 : 0);
    if (!person.missing_trials.empty())
      text +=
          fmt::format("lost: of {} the answers to trials {}{}\n", person.code,
                      trial_list(person.missing_trials), person.completed ? "" : ", and perhaps later ones");
  }
  for (const LostAnswers& person : recovery.participants)
    if (person.completed && person.trials == 0)
      text += fmt::format("lost: every answer of {}\n", person.code);
  for (const auto& [table, rows] : recovery.refused)
    text += fmt::format("lost: {} of {} that {} to lost ones\n", counted(rows, "row"), table,
                        rows == 1 ? "was damaged or refers" : "were damaged or refer");
  if (recovery.participants_without_row > 0)
    text += fmt::format(
        "lost: the codes of {}; their answers are kept as recovered-N, excluded from the analysis\n",
        counted(recovery.participants_without_row, "participant"));
  if (recovery.sessions_without_row > 0)
    text += fmt::format("lost: when {}\n",
                        counted(recovery.sessions_without_row, "session was", "sessions were"));
  if (recovery.stimuli_from_set > 0 || recovery.study_from_set)
    text += fmt::format("taken from the set: {}{}\n", recovery.study_from_set ? "the study and " : "",
                        counted(recovery.stimuli_from_set, "stimulus", "stimuli"));
  if (missing == 0 && recovery.refused.empty() && recovery.participants_without_row == 0)
    text += "no gap was found; participants who had not finished may have lost their last answers\n";
  return text +
         "A changed value that is still in its range cannot be seen: compare with a copy where there is "
         "one.\n";
}

}  // namespace seamline::study
