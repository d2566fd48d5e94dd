#include "study/exchange/exposure_records.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>

#include "stimuli/definition/parts/task_definition.h"
#include "study/exchange/trial_events.h"
#include "study/visit/exposures.h"

namespace seamline::study {
namespace {

/// Of a trial by picture; of one that was shown twice as it was shown last.
using ExposuresOfTrials = std::map<TrialOfPerson, std::map<int, Exposure>>;

ExposuresOfTrials exposures_in(const LogContents& log, const std::string& kind) {
  ExposuresOfTrials exposures;
  read_trial_events(log, kind, "\"picture 1 frames 30 wanted 30\"",
                    [&](const TrialOfPerson& trial, const std::string& detail) {
                      const std::optional<Exposure> read = exposure_of(detail);
                      if (read) exposures[trial][read->picture] = *read;
                      return read.has_value();
                    });
  return exposures;
}

/// Three columns for events of one kind.
void add_columns(const LogContents& log, const std::string& kind, const std::string& what,
                 CsvTable& answers) {
  const ExposuresOfTrials exposures = exposures_in(log, kind);
  answers.columns.insert(
      answers.columns.end(),
      {{kind + "_frames", "frames", "refreshes that each " + what + " should stand; empty: not counted"},
       {kind + "_off", "frames", "largest difference of a " + what + " of the trial from that"},
       {kind + "_marked", "", "1 where that is not 0"}});
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

}  // namespace

void add_exposure_columns(const LogContents& log, CsvTable& answers) {
  if (some_task(log, [](const TaskDefinition& task) { return task.exposure_s > 0; }))
    add_columns(log, "exposure", "picture", answers);
  if (some_task(log, [](const TaskDefinition& task) { return task.mask != TaskMask::none; }))
    add_columns(log, "mask", "mask", answers);
}

}  // namespace seamline::study
