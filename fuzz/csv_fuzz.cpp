// Counts of answers as `seamline fit` reads them, pairs of points as `seamline calibrate` does: through
// support/text/csv_read.h, as everything that is CSV.
#include <fmt/format.h>

#include <array>

#include "analysis/psychometric/report/fit_table.h"
#include "fuzz/fuzz_target.h"
#include "registration/files/pairs_file.h"
#include "support/text/csv_read.h"

namespace {

using namespace seamline;
using namespace seamline::analysis;

/// What was read, written plainly, must be read as the same.
void require_same_again(const std::vector<LevelCounts>& counts) {
  std::string text = "level,correct,trials\n";
  for (const LevelCounts& row : counts) text += fmt::format("{},{},{}\n", row.level, row.correct, row.trials);
  const auto again = counts_of(read_fit_table(fuzz::file_of("again.csv", text), {}, Axis::linear));
  if (again.size() != counts.size()) abort();
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (again[i].level != counts[i].level || again[i].correct != counts[i].correct ||
        again[i].trials != counts[i].trials)
      abort();
}

/// Texts of any kind, in columns that most inputs have or none has.
void read_any_table(const std::string& text) {
  const std::array<std::string, 2> columns = {"level", "note"};
  read_csv("any.csv", text, columns, [last = 0](const CsvRow& row) mutable {
    if (row.values.size() != 2 || row.line <= last) abort();
    last = row.line;
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(fuzz::text_of(data, size));
  const std::filesystem::path file = fuzz::file_of("counts.csv", text);
  fuzz::only_input_errors([&] {
    const std::vector<LevelCounts> counts = counts_of(read_fit_table(file, {}, Axis::log2));
    require_valid(counts, Axis::log2);
  });
  fuzz::only_input_errors([&] { read_any_table(text); });
  fuzz::only_input_errors([&] {
    for (const registration::PointPair& pair : registration::read_pairs(file, 0.5).pairs)
      if (!(pair.confidence >= 0.5) || !pair.point_m.allFinite() || !pair.position_px.allFinite()) abort();
  });
  return fuzz::only_input_errors([&] {
    const std::vector<LevelCounts> counts = counts_of(read_fit_table(file, {}, Axis::linear));
    require_valid(counts, Axis::linear);
    for (const LevelCounts& level : pooled_by_level(counts))
      if (level.correct > level.trials || level.trials <= 0) abort();
    require_same_again(counts);
  });
}
