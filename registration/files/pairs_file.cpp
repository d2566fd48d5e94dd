#include "registration/files/pairs_file.h"

#include <array>
#include <cmath>

#include "support/files/atomic_file.h"
#include "support/text/csv.h"
#include "support/text/csv_read.h"
#include "support/text/limits.h"
#include "support/text/number_range.h"

namespace seamline::registration {

PairsFile read_pairs(const std::filesystem::path& path, double least_confidence) {
  static const std::array<std::string, 6> columns = {"u", "v", "x", "y", "z", "confidence"};
  constexpr NumberRange any_place{-limits::farthest_place_m, limits::farthest_place_m};
  PairsFile file;
  const std::string text = read_file(path, limits::largest_csv_bytes);
  read_csv(path.string(), text, columns, [&](const CsvRow& row) {
    std::array<double, 6> values{};
    for (std::size_t i = 0; i < columns.size(); ++i) {
      values[i] = number_at(row, i);
      if (!inside(values[i], any_place))
        throw complaint_about(row, i, range_text("a number", any_place), number_text(values[i]));
    }
    if (values[5] < least_confidence) {
      ++file.left_out;
      return;
    }
    file.pairs.push_back({{values[0], values[1]}, {values[2], values[3], values[4]}, values[5]});
  });
  return file;
}

}  // namespace seamline::registration
