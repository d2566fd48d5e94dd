#include "study/exchange/trial_events.h"

#include <algorithm>

#include "stimuli/definition/parts/task_definition.h"
#include "study/log/log_database.h"
#include "study/log/log_values.h"
#include "support/text/printable.h"

namespace seamline::study {

bool some_task(const LogContents& log, const std::function<bool(const TaskDefinition&)>& has) {
  return (log.task && has(*log.task)) ||
         std::any_of(log.own_tasks.begin(), log.own_tasks.end(),
                     [&](const auto& one) { return one.second && has(*one.second); });
}

void read_trial_events(
    const LogContents& log, const std::string& kind, const std::string& wanted,
    const std::function<bool(const TrialOfPerson& trial, const std::string& detail)>& take) {
  with_log_errors(log.file, [&] {
    SQLite::Database database = open_log_database(log.file, LogAccess::read);
    SQLite::Statement row(database, R"sql(
        SELECT participants.code, events.trial_index, events.detail
        FROM events JOIN sessions USING (session) JOIN participants USING (participant)
        JOIN answers ON answers.session = events.session AND answers.trial_index = events.trial_index
        WHERE events.kind = ? AND events.detail NOT LIKE 'practice %' ORDER BY events.event)sql");
    row.bind(1, kind);
    const LogValues values(row, log.file, "events");
    while (row.executeStep()) {
      const std::string detail = row.getColumn(2).getString();
      if (!take({values.code(0), values.number(1, 0)}, detail))
        throw input_error({.file = log.file.string(),
                           .field = "events.detail",
                           .wanted = wanted + " in an event \"" + kind + "\"",
                           .found = "\"" + printable(detail, 40) + "\""});
    }
  });
}

}  // namespace seamline::study
