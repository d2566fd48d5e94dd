#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "sensors/files/depth_file.h"
#include "sensors/files/estimated_depth.h"

namespace seamline::sensors {

/// How far distances are from the true ones, where both have one (Eigen et al. 2014): what the field of depth
/// estimation reports.
struct DepthError {
  std::int64_t compared = 0;
  double abs_rel = 0;         ///< mean of |d - d*| / d*
  double rmse_m = 0;          ///< root of the mean of (d - d*)^2
  double within_quarter = 0;  ///< share with max(d / d*, d* / d) < 1.25 ("delta 1")
};

/// Of two maps of one size; holes are +infinity. All 0 where nothing can be compared.
[[nodiscard]] DepthError depth_error(std::span<const float> depth_m, std::span<const float> true_m);

/// An estimate of which a share is taken: 1 / d = (1 - share) / d* + share / d, in place. A share of 0 is the
/// truth and 1 the estimate, bit for bit. A hole of the truth counts as infinitely far; what the estimate has
/// no distance for stays a hole.
void mix_with_truth(std::span<const float> true_m, double share, std::vector<float>& depth_m);

/// Distances of a file of estimated values, in the file's pixels. `line`: stated; none: by least squares on
/// the true distances, which have the file's size. Values that are no number have none.
/// `camera` says the size. Throws InputError as the readers of depth maps and `fit_depth` do, and where no
/// value has a distance.
[[nodiscard]] std::vector<float> estimated_depth(const std::filesystem::path& path, DepthValue value,
                                                 const std::optional<DepthLine>& line, DepthPacking packing,
                                                 const PinholeCamera& camera, std::span<const float> true_m);

}  // namespace seamline::sensors
