// The whole isolated set at one 8-bit step.
#include <fmt/format.h>
#include <sys/resource.h>

#include "laboratory/bench/bench.h"
#include "sets/render_set.h"
#include "sets/set_errors.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/assets.h"
#include "support/files/temporary_folder.h"

namespace seamline::renderer {
namespace {

constexpr double asked_error = 0.0039;

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024e-6;
}

}  // namespace

std::vector<BenchLine> bench_set(const BenchOptions& options) {
  StudyDefinition study = read_study(builtin_study("depth_resolution_isolated"));
  RenderRequest request{.set_folder = {}, .threads = options.threads, .error = asked_error};
  if (options.quick) {
    study.width_px = 96;
    study.height_px = 54;
    request.only = "*-0064";
    request.error = 8 * asked_error;
  }
  const TemporaryFolder folder;
  request.set_folder = folder.path();
  const RenderSummary summary = render_set(study, request);
  const SetErrors errors = read_set_errors(folder.path());
  const auto part = [](const char* what, double seconds) {
    return BenchLine{.what = what, .unit = "s", .found = seconds};
  };
  BenchLine whole = part("", summary.seconds);
  whole.what = fmt::format("the whole set: {} stimuli at {:g}", summary.rendered, *request.error);
  BenchLine memory{.what = "peak memory of this process", .unit = "MB", .found = peak_memory_mb()};
  if (!options.quick) {
    whole.wanted = {Wanted::Kind::at_most, 300};
    memory.wanted = {Wanted::Kind::at_most, 1000};
  }
  return {whole,
          part("of it: references, and what their scenes share", errors.seconds.references),
          part("of it: truth of each object", errors.seconds.truth),
          part("of it: depth maps and meshes", errors.seconds.meshes),
          part("of it: stimuli", errors.seconds.stimuli),
          memory};
}

}  // namespace seamline::renderer
