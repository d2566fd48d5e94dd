#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/detection/difference_measure.h"

namespace seamline::analysis {

/// A picture, its reference, and how many looks saw the difference.
struct SeenPair {
  std::filesystem::path reference, picture;
  int seen = 0, looks = 0;
  double pixels_per_degree = 0;
  double chance = 0;  ///< how often somebody who sees nothing is right: 0 of yes or no, 0.5 of two intervals
};

/// Reads a CSV table with the columns reference, picture (paths from the table's folder), seen, n and
/// pixels_per_degree, and chance where it is not 0. Throws InputError at a count above n, an n of 0, pixels a
/// degree outside 1 to 1000, a chance outside 0 to 0.9, and a table of fewer than four pairs.
[[nodiscard]] std::vector<SeenPair> read_seen_pairs(const std::filesystem::path& file);

/// Every pair's measures, in their order. Throws InputError at a picture that cannot be read or has another
/// size than its reference. The same for any number of threads.
[[nodiscard]] std::vector<MeasuredDifference> measure_pairs(const std::vector<SeenPair>& pairs,
                                                            int threads = 0);

}  // namespace seamline::analysis
