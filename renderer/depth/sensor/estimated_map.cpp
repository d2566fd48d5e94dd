#include "renderer/depth/sensor/estimated_map.h"

#include <cmath>

#include "sensors/files/depth_file.h"

namespace seamline::renderer {

std::vector<float> depth_of_estimate(const EstimatedFile& file, const sensors::PinholeCamera& camera,
                                     sensors::DepthConvention convention, std::span<const float> true_m) {
  const FileEstimate& estimate = file.estimate;
  if (estimate.value == sensors::DepthValue::metres) {
    sensors::DepthFileForm form;
    form.camera = camera;
    form.convention = convention;
    form.metres_per_step = file.metres_per_step;
    form.packing = file.packing;
    return sensors::read_depth_file(file.path, form).frame.depth_m;
  }
  std::optional<sensors::DepthLine> stated;
  if (estimate.align == EstimateAlignment::stated)
    stated = sensors::DepthLine{.scale = estimate.scale.value_or(1), .shift = estimate.shift};
  return sensors::estimated_depth(file.path, estimate.value, stated, file.packing, camera, true_m);
}

void add_depth_error(const sensors::DepthError& error, std::optional<DepthErrorRecord>& all) {
  const DepthErrorRecord before = all.value_or(DepthErrorRecord{});
  const std::int64_t compared = before.compared + error.compared;
  const double share =
      compared == 0 ? 0 : static_cast<double>(error.compared) / static_cast<double>(compared);
  const auto mean = [share](double a, double b) { return (1 - share) * a + share * b; };
  all = {.compared = compared,
         .abs_rel = mean(before.abs_rel, error.abs_rel),
         .rmse_m = std::sqrt(mean(before.rmse_m * before.rmse_m, error.rmse_m * error.rmse_m)),
         .within_quarter = mean(before.within_quarter, error.within_quarter)};
}

}  // namespace seamline::renderer
