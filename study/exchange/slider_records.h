#pragma once
#include <map>
#include <optional>
#include <vector>

#include "study/exchange/anonymise.h"
#include "study/exchange/trial_events.h"
#include "study/log/log.h"
#include "support/text/csv.h"

namespace seamline::study {

/// Whether the study's task, or that of a condition, is a rating on a line.
[[nodiscard]] bool has_slider(const LogContents& log);

/// Where the slider of each answered trial stood. Throws InputError where an event `slid` says no place.
[[nodiscard]] std::map<TrialOfPerson, int> slider_places(const LogContents& log);

/// Of each of the log's answers and catch answers, in their order; none: not asked on a line. Both are empty
/// where the study has no slider.
[[nodiscard]] SliderPlaces slider_places_in_order(const LogContents& log);

/// The same as a column of tables; no column where the study has no slider. An anonymised log has the places
/// that `anonymise` kept: they are answers, as ratings are.
struct SliderColumn {
  std::vector<CsvColumn> columns = {};  ///< one or none
  std::vector<CsvValue> of_answers = {}, of_catches = {};
};
[[nodiscard]] SliderColumn slider_column(const LogContents& log, const std::optional<Anonymity>& anonymity);

}  // namespace seamline::study
