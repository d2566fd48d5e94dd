#include "analysis/by_task/log_of_task.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "stimuli/definition/looks/condition_tasks.h"
#include "stimuli/study_file/study_file.h"

namespace seamline::analysis {

std::vector<LogOfTask> logs_of_tasks(const study::LogContents& log) {
  const StudyDefinition study = read_study_text(log.study_text, "study text of the log");
  std::vector<LogOfTask> parts;
  for (const TaskGroup& group : task_groups(study)) {
    const auto is_elsewhere = [&](const auto& answer) {
      return std::find(group.conditions.begin(), group.conditions.end(), answer.condition) ==
             group.conditions.end();
    };
    LogOfTask part{.name = fmt::format("{}_{}", parts.size() + 1, word(facts_of(group.task.get()).kind)),
                   .question = asked_texts(study, group.task.get()).question,
                   .conditions = group.conditions,
                   .log = log};
    part.log.task = group.task;
    part.log.own_tasks.clear();
    std::erase_if(part.log.answers, is_elsewhere);
    std::erase_if(part.log.catches, is_elsewhere);
    if (!part.log.answers.empty()) parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace seamline::analysis
