#pragma once
#include <string>
#include <vector>

#include "laboratory/convergence/convergence_runs.h"

namespace seamline::renderer {

/// One way to put the object's change of the local scene onto a photograph.
struct CompositingRow {
  Compositing compositing = Compositing::ratio;
  std::string renders;  ///< how the two renderings of the local scene share their random numbers
  int spp = 0;
  double seconds = 0;      ///< of rendering the local scene; ratio and additive are made from the same sums
  double noise = 0;        ///< RMSE between two compositings with other seeds, over the root of 2
  double rmse = 0;         ///< against the perfect insertion
  double below_black = 0;  ///< share of pixels with a channel under 0,
  double above_white = 0;  ///< and over display white
};

struct CompositingResult {
  std::vector<CompositingRow> rows;
  double reference_above_white = 0;  ///< of the perfect insertion, whose black is never undercut
};

/// Ratio beside additive compositing at equal time (paper 3.1): everything is answered by the depth mesh,
/// the photograph is a given long rendering, and errors are taken off the object.
[[nodiscard]] CompositingResult measure_compositing(const ConvergenceSubject& subject, double budget_s);

}  // namespace seamline::renderer
