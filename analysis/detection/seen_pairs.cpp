#include "analysis/detection/seen_pairs.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "support/files/atomic_file.h"
#include "support/files/image.h"
#include "support/running/parallel.h"
#include "support/text/csv_read.h"
#include "support/text/error.h"

namespace seamline::analysis {
namespace {

enum PairColumn : std::size_t {
  reference_place,
  picture_place,
  seen_place,
  n_place,
  ppd_place,
  chance_place
};

constexpr std::int64_t most_pair_looks = 1000000;

double bounded_number(const CsvRow& row, PairColumn column, double low, double high) {
  const double number = number_at(row, column);
  if (!(number >= low && number <= high))
    throw complaint_about(row, column, fmt::format("{:g} to {:g}", low, high), row.values[column]);
  return number;
}

SeenPair pair_of_row(const CsvRow& row, const std::filesystem::path& folder) {
  SeenPair pair{.reference = folder / row.values[reference_place],
                .picture = folder / row.values[picture_place],
                .seen = static_cast<int>(count_at(row, seen_place, most_pair_looks, "1000000")),
                .looks = static_cast<int>(count_at(row, n_place, most_pair_looks, "1000000")),
                .pixels_per_degree = bounded_number(row, ppd_place, 1, 1000)};
  if (pair.looks == 0) throw complaint_about(row, n_place, "1 look or more", "0");
  if (pair.seen > pair.looks)
    throw complaint_about(row, seen_place, "no more than n, " + std::to_string(pair.looks),
                          std::to_string(pair.seen));
  if (row.columns.size() > chance_place) pair.chance = bounded_number(row, chance_place, 0, 0.9);
  return pair;
}

ByteImage read_side(const std::filesystem::path& path) {
  ByteImage image = read_bytes_image(path);
  if (image.channels != 1 && image.channels != 3)
    throw input_error(
        {.file = path.string(), .wanted = "1 or 3 channels", .found = std::to_string(image.channels)});
  return image;
}

double code_rms(const ByteImage& a, const ByteImage& b) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const int difference = int{a.values[i]} - int{b.values[i]};
    sum += std::int64_t{difference} * difference;
  }
  return std::sqrt(static_cast<double>(sum) / static_cast<double>(a.values.size())) / 255;
}

MeasuredDifference measured_pair(const SeenPair& pair) {
  const ByteImage reference = read_side(pair.reference), picture = read_side(pair.picture);
  if (reference.width_px != picture.width_px || reference.height_px != picture.height_px ||
      reference.channels != picture.channels)
    throw input_error({.file = pair.picture.string(),
                       .wanted = fmt::format("{} x {} px and {} channels, as its reference",
                                             reference.width_px, reference.height_px, reference.channels),
                       .found = fmt::format("{} x {} px and {} channels", picture.width_px, picture.height_px,
                                            picture.channels)});
  return measure_difference(flip_difference(reference, picture, pair.pixels_per_degree),
                            pair.pixels_per_degree, code_rms(reference, picture));
}

}  // namespace

std::vector<SeenPair> read_seen_pairs(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  std::vector<std::string> columns = {"reference", "picture", "seen", "n", "pixels_per_degree"};
  const CsvHeader header = read_csv_header(file.string(), text);
  if (std::find(header.names.begin(), header.names.end(), "chance") != header.names.end())
    columns.emplace_back("chance");
  std::vector<SeenPair> pairs;
  read_csv(file.string(), text, columns,
           [&](const CsvRow& row) { pairs.push_back(pair_of_row(row, file.parent_path())); });
  if (pairs.size() < 4)
    throw input_error({.file = file.string(),
                       .field = {},
                       .wanted = "at least four pairs, because half of them are for judging",
                       .found = std::to_string(pairs.size())});
  return pairs;
}

std::vector<MeasuredDifference> measure_pairs(const std::vector<SeenPair>& pairs, int threads) {
  std::vector<MeasuredDifference> all(pairs.size());
  run_parallel(static_cast<int>(pairs.size()), threads, [&](int index) {
    const std::size_t place = index;
    all[place] = measured_pair(pairs[place]);
  });
  return all;
}

}  // namespace seamline::analysis
