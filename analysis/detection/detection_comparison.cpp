#include "analysis/detection/detection_comparison.h"

#include <algorithm>
#include <cmath>

#include "support/arithmetic/colour.h"
#include "support/running/parallel.h"

namespace seamline::analysis {
namespace {

constexpr std::array<double, 5> beside_threshold_db = {12, 6, 0, -6, -12};

/// Root mean square difference of the displayed values of a pattern from its field.
double displayed_rms(const Image& picture) {
  const double field = double{srgb_from_linear(0.5F)};
  double sum = 0;
  for (const float value : picture.values) {
    const double difference = double{srgb_from_linear(std::min(1.0F, std::max(0.0F, value)))} - field;
    sum += difference * difference;
  }
  return std::sqrt(sum / picture.values.size());
}

PatternResponse response_to(const DetectionPattern& pattern) {
  const Image contrast = pattern_contrast(pattern);
  const FlipPicture field = flip_picture_of_linear(pattern_picture(contrast, 0), pattern.pixels_per_degree);
  PatternResponse response;
  for (const double beside_db : beside_threshold_db) {
    const double contrast_db = pattern.threshold_db + beside_db;
    const Image picture = pattern_picture(contrast, std::pow(10, -contrast_db / 20));
    const Image flip = flip_difference(field, flip_picture_of_linear(picture, pattern.pixels_per_degree));
    response.contrast_db.push_back(contrast_db);
    response.measured.push_back(measure_difference(flip, pattern.pixels_per_degree, displayed_rms(picture)));
  }
  return response;
}

/// Mean of predicted less measured over every `step`th pattern from `first` on.
double mean_error_db(const DetectionThresholds& thresholds, const std::vector<PatternResponse>& responses,
                     DifferenceMeasure measure, double criterion, std::size_t first, std::size_t step) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = first; i < responses.size(); i += step, ++count)
    sum += seamline::analysis::threshold_db(responses[i], measure, criterion) -
           thresholds.patterns[i].threshold_db;
  return sum / count;
}

/// By bisection: a larger criterion needs more contrast everywhere.
double fitted_criterion(const DetectionThresholds& thresholds, const std::vector<PatternResponse>& responses,
                        DifferenceMeasure measure, std::size_t first, std::size_t step) {
  double low = -40, high = 20;  // log2
  while (high - low > 1e-9) {
    const double middle = (low + high) / 2;
    const double error = mean_error_db(thresholds, responses, measure, std::exp2(middle), first, step);
    (error > 0 ? low : high) = middle;
  }
  return std::exp2((low + high) / 2);
}

double squared_error_db(const DetectionThresholds& thresholds, const std::vector<PatternResponse>& responses,
                        DifferenceMeasure measure, double criterion, std::size_t first, std::size_t step) {
  double sum = 0;
  for (std::size_t i = first; i < responses.size(); i += step) {
    const double error = seamline::analysis::threshold_db(responses[i], measure, criterion) -
                         thresholds.patterns[i].threshold_db;
    sum += error * error;
  }
  return sum;
}

}  // namespace

std::vector<PatternResponse> pattern_responses(const DetectionThresholds& thresholds, int threads) {
  std::vector<PatternResponse> responses(thresholds.patterns.size());
  run_parallel(static_cast<int>(responses.size()), threads, [&](int index) {
    const std::size_t place = index;
    responses[place] = response_to(thresholds.patterns[place]);
  });
  return responses;
}

double threshold_db(const PatternResponse& response, DifferenceMeasure measure, double criterion) {
  const auto log_at = [&](std::size_t i) { return std::log2(value_of(response.measured[i], measure)); };
  const double wanted = std::log2(criterion);
  std::size_t i = 0;
  while (i + 2 < response.measured.size() && log_at(i + 1) < wanted) ++i;
  const double share = (wanted - log_at(i)) / (log_at(i + 1) - log_at(i));
  return response.contrast_db[i] + share * (response.contrast_db[i + 1] - response.contrast_db[i]);
}

MeasureFit judge_measure(const DetectionThresholds& thresholds, const std::vector<PatternResponse>& responses,
                         DifferenceMeasure measure, double criterion) {
  MeasureFit fit{.measure = measure, .criterion = criterion, .predicted_db = {}};
  for (const PatternResponse& response : responses)
    fit.predicted_db.push_back(threshold_db(response, measure, criterion));
  fit.rms_error_db = std::sqrt(squared_error_db(thresholds, responses, measure, criterion, 0, 1) /
                               static_cast<double>(responses.size()));
  return fit;
}

MeasureFit fit_measure(const DetectionThresholds& thresholds, const std::vector<PatternResponse>& responses,
                       DifferenceMeasure measure) {
  MeasureFit fit =
      judge_measure(thresholds, responses, measure, fitted_criterion(thresholds, responses, measure, 0, 1));
  double sum = 0;
  for (const std::size_t half : {std::size_t{0}, std::size_t{1}})
    sum += squared_error_db(thresholds, responses, measure,
                            fitted_criterion(thresholds, responses, measure, half, 2), 1 - half, 2);
  fit.rms_error_other_half_db = std::sqrt(sum / responses.size());
  return fit;
}

double detection_gain(const ObserverDefinition& observer) {
  const double seen = modelfest_thresholds().seen_share;
  return std::exp2(observer.scale_octaves * std::log(seen / (1 - seen))) / detection_visible_difference;
}

}  // namespace seamline::analysis
