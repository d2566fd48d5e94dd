#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// Lower quartile, median and upper quartile over answers, in seconds.
struct Quartiles {
  double lower_s = 0, median_s = 0, upper_s = 0;
};

/// Which answers a line of times is over.
enum class TimedAnswers { all, right, wrong };
[[nodiscard]] std::string_view word(TimedAnswers answers);

/// How long people took at one level.
struct ResponseTime {
  std::optional<Artifact> artifact;  ///< none: all artifacts together
  std::string condition;             ///< of an artifact's row; empty: all, or the only one
  double level = 0;
  TimedAnswers which = TimedAnswers::all;
  int answers = 0;  ///< at least one
  int people = 0;
  Quartiles choice;  ///< from the image's onset to the choice
  Quartiles rating;  ///< from the choice to the rating
};

struct ResponseTimes {
  std::vector<ResponseTime> rows;  ///< all artifacts first; levels as on the curve; all, right, wrong
  std::string missing;             ///< a sentence: why there are no rows
};

/// Times of the people used. Simulated observers have none and are left out.
[[nodiscard]] ResponseTimes response_times(const Analysis& analysis);

/// Quantiles by linear interpolation (type 7); NaN without values.
[[nodiscard]] Quartiles quartiles(std::vector<double> values);

}  // namespace seamline::analysis
