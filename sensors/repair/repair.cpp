#include "sensors/repair/repair.h"

#include "support/text/error.h"

namespace seamline::sensors {
namespace {

struct Mend {
  const DepthFrame& measured;
  const Image* photograph;
  int threads;

  Repaired operator()(const NoRepair&) const { return without_repair(measured); }
  Repaired operator()(const NearestRepair&) const { return fill_with_nearest(measured, threads); }
  Repaired operator()(const MedianRepair& median) const {
    return smooth_by_median(measured, median, threads);
  }
  Repaired operator()(const JointBilateralRepair& bilateral) const {
    if (photograph == nullptr)
      throw input_error({.file = {},
                         .field = "repair: joint bilateral",
                         .wanted = "a photograph in the depth's own pixels",
                         .found = "none"});
    return smooth_by_photograph(measured, *photograph, bilateral, threads);
  }
  Repaired operator()(const PlaneRepair& planes) const { return replace_planes(measured, planes).repaired; }
};

}  // namespace

Repaired repair(const DepthFrame& measured, const RepairMethod& method, const Image* photograph,
                int threads) {
  return std::visit(Mend{measured, photograph, threads}, method);
}

}  // namespace seamline::sensors
