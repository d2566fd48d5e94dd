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

ExposuresOfTrials exposures_in(const LogContents& log) {
  ExposuresOfTrials exposures;
  read_trial_events(log, "exposure", "\"picture 1 frames 30 wanted 30\"",
                    [&](const TrialOfPerson& trial, const std::string& detail) {
                      const std::optional<Exposure> read = exposure_of(detail);
                      if (read) exposures[trial][read->picture] = *read;
                      return read.has_value();
                    });
  return exposures;
}

}  // namespace

void add_exposure_columns(const LogContents& log, CsvTable& answers) {
  const auto limits = [](const auto& task) { return task && task->exposure_s > 0; };
  const bool own = std::any_of(log.own_tasks.begin(), log.own_tasks.end(),
                               [&](const auto& one) { return limits(one.second); });
  if (!limits(log.task) && !own) return;
  const ExposuresOfTrials exposures = exposures_in(log);
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
