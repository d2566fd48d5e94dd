// Counts of answers as `seamline fit` reads them.
#include "analysis/psychometric/level_counts.h"
#include "fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace seamline;
  const std::filesystem::path file = fuzz::file_of("counts.csv", fuzz::text_of(data, size));
  return fuzz::only_input_errors([&] {
    const std::vector<LevelCounts> counts = read_level_counts(file);
    for (const LevelCounts& level : pooled_by_level(counts))
      if (level.correct > level.trials || level.trials <= 0) abort();
    require_valid(counts, Axis::linear);
    require_valid(counts, Axis::log2);
  });
}
