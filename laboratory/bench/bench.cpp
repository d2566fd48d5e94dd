#include "laboratory/bench/bench.h"

#include <array>

namespace seamline::renderer {

std::optional<bool> is_met(const BenchLine& measurement) {
  const double value = measurement.ratio.value_or(measurement.found);
  switch (measurement.wanted.kind) {
    case Wanted::Kind::nothing:
      return std::nullopt;
    case Wanted::Kind::at_least:
      return value >= measurement.wanted.value;
    case Wanted::Kind::at_most:
      return value <= measurement.wanted.value;
  }
  return std::nullopt;
}

std::span<const Benchmark> benchmarks() {
  static const std::array all = {
      // First, because its memory is the most that the process has taken.
      Benchmark{"set", "the whole isolated set at one 8-bit step, which takes minutes", bench_set},
      Benchmark{"capture", "depth maps beside the fastest bare Embree loop on the same rays", bench_capture},
      Benchmark{"tracer", "Seamline's rays beside the best of rtcIntersect1, 4, 8 and 16 on recorded rays",
                bench_tracer},
      Benchmark{"local", "rays in the local scene beside the same kind of rays in the truth scene",
                bench_local_scene},
      Benchmark{"mesh", "the adaptive depth mesh beside full density", bench_mesh},
      Benchmark{"picture", "one composite on a given background: fast beside path at equal error",
                bench_picture},
  };
  return all;
}

}  // namespace seamline::renderer
