#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace seamline::study {

/// What became of the participants of one log that was merged into another.
struct MergedLog {
  std::filesystem::path from;
  std::vector<std::string> added;     ///< codes that were new
  std::vector<std::string> extended;  ///< that had fewer answers or messages, and have all of them now
  int known = 0;                      ///< that had everything before
  int other_observer = 0;  ///< added or extended, simulated with another [observer] than the log's study says
};

/// Adds the participants of other logs of the same study and set to a log, all in one transaction. A
/// participant is the same by code, and an answer by the id of its message; an answer of the window, which
/// has none, by `window_answer_id`. Somebody who is in both is a duplicate as far as both say the same: the
/// log keeps what is more. Logs whose studies differ in [observer] alone are of one study; how simulated
/// people differ from what the log's text of the study says is kept with each. Throws InputError, and merges
/// nothing, when a participant's answers or messages contradict one another, or when a log is of another
/// study or set, is of an old schema version, is damaged, or has somebody in a session now. People whom one
/// log forgot come back from another that knows them.
std::vector<MergedLog> merge_logs(const std::filesystem::path& into,
                                  const std::vector<std::filesystem::path>& from);

/// The merge in words, a line for each log.
[[nodiscard]] std::string merge_text(const std::vector<MergedLog>& merged, const std::filesystem::path& into);

/// A UUID of an answer that was given in the window: the same in every copy of a log, and another one where
/// another person has the same code. `begun`: when the session started in seconds since 1970; of a simulated
/// participant the seed of the simulation.
[[nodiscard]] std::string window_answer_id(const std::string& code, int trial_index,
                                           const std::string& begun);

}  // namespace seamline::study
