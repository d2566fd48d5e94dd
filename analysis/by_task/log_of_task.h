#pragma once
#include <string>
#include <vector>

#include "study/log/log.h"

namespace seamline::analysis {

/// The answers of a log to one of its tasks, as a log of that task alone. People are the whole log's.
struct LogOfTask {
  std::string name;                     ///< its number and kind: "1_interval"
  std::string question;                 ///< what its trials ask
  std::vector<std::string> conditions;  ///< that ask it, in the study's order
  study::LogContents log;
};

/// The parts of a log whose conditions have tasks of their own, in the study's order; tasks that nobody has
/// answered are left out. Throws InputError where the log's study cannot be read.
[[nodiscard]] std::vector<LogOfTask> logs_of_tasks(const study::LogContents& log);

}  // namespace seamline::analysis
