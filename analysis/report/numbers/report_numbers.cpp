#include "analysis/report/numbers/report_numbers.h"

#include "analysis/log_analysis/ordinal_of_log.h"
#include "support/text/error.h"

namespace seamline::analysis {

namespace {

void add_comparisons(ReportNumbers& numbers, const Analysis& analysis) {
  if (analysis.adaptive) {
    numbers.comparisons_missing =
        in_words_of(analysis.data.axis,
                    "Artifacts are not compared by a model of ratings: widths were placed by the answers, so "
                    "ratings were not asked at the same widths of everybody. Compare the thresholds of the "
                    "tracks.");
    return;
  }
  OrdinalStudyRequest request;
  request.conditions = analysis.data.conditions;
  request.axis = analysis.data.axis;
  request.fit.threads = analysis.resampling.threads;
  try {
    numbers.comparisons = ordinal_study(analysis, {}, request);
  } catch (const InputError& error) {
    numbers.comparisons_missing = std::string("Artifacts cannot be compared: ") + error.what();
  }
}

}  // namespace

ReportNumbers report_numbers(const Analysis& analysis) {
  ReportNumbers numbers;
  numbers.axis = analysis.data.axis;
  numbers.conditions = has_conditions(analysis.data);
  numbers.choices = choice_curves(analysis);
  add_comparisons(numbers, analysis);
  numbers.times = response_times(analysis);
  numbers.participants = participant_rows(analysis);
  if (analysis.adaptive) numbers.tracks = study::quest_plus_estimates(analysis.log);
  return numbers;
}

}  // namespace seamline::analysis
