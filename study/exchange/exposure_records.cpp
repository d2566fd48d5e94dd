#include "study/exchange/exposure_records.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>

#include "stimuli/definition/parts/task_definition.h"
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

/// Whether the study's task, or that of a condition, has something.
bool some_task(const LogContents& log, const std::function<bool(const TaskDefinition&)>& has) {
  return (log.task && has(*log.task)) ||
         std::any_of(log.own_tasks.begin(), log.own_tasks.end(),
                     [&](const auto& one) { return one.second && has(*one.second); });
}

}  // namespace

void add_exposure_columns(const LogContents& log, CsvTable& answers) {
  if (some_task(log, [](const TaskDefinition& task) { return task.exposure_s > 0; }))
    add_columns(log, "exposure", "picture", answers);
  if (some_task(log, [](const TaskDefinition& task) { return task.mask != TaskMask::none; }))
    add_columns(log, "mask", "mask", answers);
}

bool has_slider(const LogContents& log) {
  return some_task(log, [](const TaskDefinition& task) { return task.slider; });
}

std::map<TrialOfPerson, int> slider_places(const LogContents& log) {
  std::map<TrialOfPerson, int> places;
  if (!has_slider(log)) return places;
  read_trial_events(log, "slid", "a whole number from 0 to 100",
                    [&](const TrialOfPerson& trial, const std::string& detail) {
                      int place = -1;
                      const char* const end = detail.data() + detail.size();
                      const auto read = std::from_chars(detail.data(), end, place);
                      if (read.ec != std::errc() || read.ptr != end || place < 0 || place > slider_end)
                        return false;
                      places[trial] = place;
                      return true;
                    });
  return places;
}

void add_slider_column(const LogContents& log, CsvTable& answers) {
  if (!has_slider(log)) return;
  const std::map<TrialOfPerson, int> places = slider_places(log);
  answers.columns.push_back(
      {"position", "", "where the slider stood, 0 nothing seen to 100; its fifth is choice and rating"});
  for (std::size_t i = 0; i < log.answers.size(); ++i) {
    const auto found = places.find({log.answers[i].participant, log.answers[i].trial_index});
    answers.rows[i].push_back(found == places.end() ? CsvValue() : CsvValue(std::int64_t{found->second}));
  }
}

}  // namespace seamline::study
