#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "laboratory/convergence/convergence_runs.h"
#include "support/running/progress.h"

namespace seamline::renderer {

/// The stimulus as one estimator renders it at a number of samples a pixel, and what that cost.
struct TimedRender {
  StimulusSums sums;
  double seconds = 0;
  std::int64_t rays = 0;
};

/// A line of the figure.
struct Series {
  std::string name;
  std::string meaning;  ///< one sentence for the table
  std::function<TimedRender(int spp)> render;
  int fewest_spp = 1;
};

/// Every way to render the stimulus that is compared. A new estimator is one more entry here.
[[nodiscard]] std::vector<Series> sample_series(const ConvergenceSubject& subject, const Geometry& depth,
                                                PathRuns& runs);

struct SeriesRow {
  std::string series;
  int spp = 0;
  double seconds = 0;  ///< passes and compositing
  std::int64_t rays = 0;
  double rmse = 0;        ///< of the stimulus as a set renders it, against the long reference
  double rmse_given = 0;  ///< off the object, on a given background
};

struct SampleResult {
  std::vector<SeriesRow> rows;
  std::vector<std::pair<std::string, std::string>> meanings;  ///< of each series, in order
  int reference_spp = 0;
  double reference_seconds = 0;
  double reference_noise = 0, reference_noise_given = 0;  ///< estimated from its two halves
};

/// Error against run time. The long reference is `path coupled` with another seed; half of the budget goes
/// there, and every series doubles its samples until a rendering would take longer than `path coupled` with
/// a sixteenth of the reference's samples. Pictures do not depend on the budget, only how many there are.
[[nodiscard]] SampleResult measure_samples(const ConvergenceSubject& subject, double budget_s);

}  // namespace seamline::renderer
