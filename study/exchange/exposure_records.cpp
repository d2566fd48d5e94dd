#include "study/exchange/exposure_records.h"

#include <cstdlib>
#include <map>
#include <utility>

#include "stimuli/definition/parts/task_definition.h"
#include "study/log/log_database.h"
#include "study/log/log_values.h"
#include "study/visit/exposures.h"
#include "support/text/printable.h"

namespace seamline::study {
namespace {

/// By participant and trial, and in it by picture; of a trial that was shown twice as it was shown last.
using ExposuresOfTrials = std::map<std::pair<std::string, int>, std::map<int, Exposure>>;

ExposuresOfTrials exposures_in(SQLite::Database& database, const std::filesystem::path& file) {
  SQLite::Statement row(database, R"sql(
      SELECT participants.code, events.trial_index, events.detail
      FROM events JOIN sessions USING (session) JOIN participants USING (participant)
      JOIN answers ON answers.session = events.session AND answers.trial_index = events.trial_index
      WHERE events.kind = 'exposure' AND events.detail NOT LIKE 'practice %' ORDER BY events.event)sql");
  const LogValues values(row, file, "events");
  ExposuresOfTrials exposures;
  while (row.executeStep()) {
    const std::string text = row.getColumn(2).getString();
    const std::optional<Exposure> read = exposure_of(text);
    if (!read)
      throw input_error({.file = file.string(),
                         .field = "events.detail",
                         .wanted = "\"picture 1 frames 30 wanted 30\" in an event \"exposure\"",
                         .found = "\"" + printable(text, 40) + "\""});
    exposures[{values.code(0), values.number(1, 0)}][read->picture] = *read;
  }
  return exposures;
}

}  // namespace

void add_exposure_columns(const LogContents& log, CsvTable& answers) {
  if (!log.task || log.task->exposure_s <= 0) return;
  const ExposuresOfTrials exposures = with_log_errors(log.file, [&] {
    SQLite::Database database = open_log_database(log.file, LogAccess::read);
    return exposures_in(database, log.file);
  });
  answers.columns.insert(
      answers.columns.end(),
      {{"exposure_frames", "frames", "refreshes that each picture should stand; empty: not counted"},
       {"exposure_off", "frames", "largest difference of a picture of the trial from that"},
       {"exposure_marked", "", "1 where that is not 0"}});
  for (std::size_t i = 0; i < log.answers.size(); ++i) {
    std::vector<CsvValue>& row = answers.rows[i];
    const auto found = exposures.find({log.answers[i].participant, log.answers[i].trial_index});
    if (found == exposures.end()) {
      row.resize(row.size() + 3);
      continue;
    }
    std::int64_t off = 0, wanted = 0;
    for (const auto& [picture, exposure] : found->second) {
      wanted = exposure.wanted;
      off = std::max<std::int64_t>(off, std::abs(exposure.frames - exposure.wanted));
    }
    row.insert(row.end(), {wanted, off, std::int64_t{off > 0 ? 1 : 0}});
  }
}

}  // namespace seamline::study
