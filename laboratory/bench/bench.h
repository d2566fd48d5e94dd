#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace seamline::renderer {

/// What was wanted of a measurement's ratio, or of what was found when there is nothing beside it.
struct Wanted {
  enum class Kind { nothing, at_least, at_most } kind = Kind::nothing;
  double value = 0;
};

/// One line of `seamline lab bench`.
struct BenchLine {
  std::string what;                   ///< e.g. "bedroom, bounce rays"
  std::string unit;                   ///< of `found` and `beside`, e.g. "Mrays/s"
  double found = 0;                   ///< Seamline's
  std::optional<double> beside = {};  ///< what it is measured against, in the same run
  std::optional<double> ratio = {};   ///< found / beside: the median over interleaved repeats
  Wanted wanted = {};
};

/// Whether the measurement is what was wanted; none when nothing was.
[[nodiscard]] std::optional<bool> is_met(const BenchLine& measurement);

struct BenchOptions {
  bool quick = false;  ///< smaller maps and pictures, fewer repeats: whether it runs, not how fast
  int threads = 1;     ///< of passes and builds; rays a second are of one thread
  /// Hears what a long measurement has found so far.
  std::function<void(const std::string&)> said = [](const std::string&) {};
};

/// Measurements that belong together.
struct Benchmark {
  std::string_view name;     ///< as `--only` takes it
  std::string_view explain;  ///< one sentence: what is measured against what
  std::function<std::vector<BenchLine>(const BenchOptions&)> run;
};

/// All of them, in the order they are run in.
[[nodiscard]] std::span<const Benchmark> benchmarks();

[[nodiscard]] std::vector<BenchLine> bench_capture(const BenchOptions& options);
[[nodiscard]] std::vector<BenchLine> bench_tracer(const BenchOptions& options);
[[nodiscard]] std::vector<BenchLine> bench_local_scene(const BenchOptions& options);
[[nodiscard]] std::vector<BenchLine> bench_mesh(const BenchOptions& options);
[[nodiscard]] std::vector<BenchLine> bench_picture(const BenchOptions& options);
[[nodiscard]] std::vector<BenchLine> bench_set(const BenchOptions& options);

}  // namespace seamline::renderer
