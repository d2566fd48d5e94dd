#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace seamline::study {

/// What is known to be missing of a participant.
struct LostAnswers {
  std::string code;
  bool completed = false;                ///< all trials had been answered
  int trials = 0;                        ///< that could be read
  int answered = 0;                      ///< of them, with an answer that could be read
  std::vector<int> missing_trials = {};  ///< that must have been answered, and whose answer is gone
};

/// What was saved of a damaged log, and what was not.
struct LogRecovery {
  std::map<std::string, std::int64_t> saved;    ///< rows by table
  std::map<std::string, std::int64_t> refused;  ///< rows that were read, but contradict the log's rules
  int participants_without_row = 0;             ///< whose code is lost; entered as recovered-N and excluded
  int sessions_without_row = 0;                 ///< entered with time 0
  std::int64_t stimuli_from_set = 0;
  bool study_from_set = false;
  std::vector<LostAnswers> participants;  ///< in the order of the log
};

/// Saves what can be read of a damaged log into a new one; the damaged one is not touched. `set_folder` (may
/// be empty: the folder that the log names) supplies the study and its stimuli where the log's own are lost.
/// Throws InputError when `out` exists, when nothing of a log can be read, or when study or stimuli are lost
/// and no set is known.
LogRecovery recover_log(const std::filesystem::path& damaged, const std::filesystem::path& out,
                        const std::filesystem::path& set_folder);

}  // namespace seamline::study
