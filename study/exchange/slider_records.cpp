#include "study/exchange/slider_records.h"

#include <charconv>
#include <cstdint>
#include <string>
#include <system_error>

#include "stimuli/definition/parts/task_definition.h"

namespace seamline::study {
namespace {

std::vector<CsvValue> cells_of(const std::vector<std::optional<int>>& places) {
  std::vector<CsvValue> cells;
  for (const std::optional<int>& place : places)
    cells.push_back(place ? CsvValue(std::int64_t{*place}) : CsvValue());
  return cells;
}

}  // namespace

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

SliderPlaces slider_places_in_order(const LogContents& log) {
  SliderPlaces out;
  if (!has_slider(log)) return out;
  const std::map<TrialOfPerson, int> places = slider_places(log);
  const auto place_of = [&](const auto& answer) {
    const auto found = places.find({answer.participant, answer.trial_index});
    return found == places.end() ? std::nullopt : std::optional(found->second);
  };
  for (const Answer& answer : log.answers) out.of_answers.push_back(place_of(answer));
  for (const CatchTrialAnswer& answer : log.catches) out.of_catches.push_back(place_of(answer));
  return out;
}

SliderColumn slider_column(const LogContents& log, const std::optional<Anonymity>& anonymity) {
  if (!has_slider(log)) return {};
  const SliderPlaces places = anonymity ? anonymity->slider : slider_places_in_order(log);
  return {.columns = {{"position", "",
                       "where the slider stood, 0 nothing seen to 100; its fifth is choice and rating"}},
          .of_answers = cells_of(places.of_answers),
          .of_catches = cells_of(places.of_catches)};
}

}  // namespace seamline::study
