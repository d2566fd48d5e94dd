#pragma once
#include <optional>
#include <span>
#include <vector>

#include "sensors/files/estimate_error.h"
#include "stimuli/definition/depth_chain.h"
#include "stimuli/set/manifest.h"

namespace seamline::renderer {

/// A depth map of a file whose values are estimated, as a study's source names it.
struct EstimatedFile {
  const std::filesystem::path& path;
  const FileEstimate& estimate;
  std::optional<double> metres_per_step;
  sensors::DepthPacking packing;
};

/// Its distances before they are mixed with the true ones, to which they may be aligned. Throws InputError as
/// the readers of depth maps do.
[[nodiscard]] std::vector<float> depth_of_estimate(const EstimatedFile& file,
                                                   const sensors::PinholeCamera& camera,
                                                   sensors::DepthConvention convention,
                                                   std::span<const float> true_m);

/// Counts the error of one more map with those before.
void add_depth_error(const sensors::DepthError& error, std::optional<DepthErrorRecord>& all);

}  // namespace seamline::renderer
