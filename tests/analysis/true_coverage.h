#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "support/running/parallel.h"
#include "tests/analysis/true_studies.h"

namespace seamline::test {

/// The designs of documentation/evidence/coverage.md.
struct TrueWidths {
  std::string name;
  std::vector<int> width_px;
};
inline std::vector<TrueWidths> true_widths() {
  return {{"paper", {64, 128, 256, 512, 1024, 2048, 4096}},
          {"quick", {64, 256, 512, 1024, 4096}},
          {"every second", {64, 256, 1024, 4096}}};
}
inline constexpr std::array<int, 5> true_sizes = {5, 10, 20, 40, 80};
inline constexpr std::array<const char*, 4> true_quantities = {"PT", "SN", "PT corrected", "SN corrected"};

/// How often an interval held the true crossing, how long it was and how far the estimate lay from it.
struct TrueTally {
  int studies = 0, held = 0, too_high = 0, too_low = 0, open = 0, without = 0;
  double error = 0, square = 0;  ///< sums over studies with an estimate, octaves
  std::vector<double> length;    ///< octaves, infinite where open

  /// Both are kept within half an octave of the widths tested before they are compared, so that a curve that
  /// does not cross counts as far off, not as infinitely far.
  void add(const TrueReading& reading, double true_x, double first_x, double last_x) {
    ++studies;
    if (reading.ci95.low_x > true_x)
      ++too_high;
    else if (reading.ci95.high_x < true_x)
      ++too_low;
    else
      ++held;
    const bool closed = std::isfinite(reading.ci95.low_x) && std::isfinite(reading.ci95.high_x);
    open += closed ? 0 : 1;
    length.push_back(closed ? reading.ci95.high_x - reading.ci95.low_x : INFINITY);
    if (std::isnan(reading.point_x)) {
      ++without;
      return;
    }
    const double off = std::clamp(reading.point_x, first_x - 0.5, last_x + 0.5) -
                       std::clamp(true_x, first_x - 0.5, last_x + 0.5);
    error += off;
    square += off * off;
  }
  [[nodiscard]] double percent(int count) const { return 100.0 * count / studies; }
  [[nodiscard]] double bias() const { return error / (studies - without); }
  [[nodiscard]] double rmse() const { return std::sqrt(square / (studies - without)); }
  [[nodiscard]] double median_length() {
    std::sort(length.begin(), length.end());
    return length[length.size() / 2];
  }
};

/// Simulates `studies` studies of one population and one set of widths, everybody of the largest study being
/// asked once, and writes a row for each size, artifact and quantity, and one for "all 8", the share of
/// studies in which PT and SN of all four artifacts were held together.
inline void tally_true_coverage(const TruePeople& people, const TrueWidths& widths, int studies,
                                const std::function<TrueReadings(const TrueStudy&)>& read, std::ostream& out,
                                const std::string& way) {
  constexpr std::size_t sizes = true_sizes.size();
  std::vector<std::array<TrueReadings, sizes>> found(static_cast<std::size_t>(studies));
  const std::vector<double> level_x = log2_widths(widths.width_px);
  run_parallel(studies, 0, [&](int index) {
    const TrueStudy all{.width_px = widths.width_px,
                        .people = answer_as_people(people, true_sizes.back(), level_x,
                                                   1000 + static_cast<std::uint64_t>(index))};
    for (std::size_t n = 0; n < sizes; ++n)
      found[static_cast<std::size_t>(index)][n] = read(first_people(all, true_sizes[n]));
  });
  std::array<std::array<double, 4>, true_curves> truth{};
  for (int c = 0; c < true_curves; ++c) truth[static_cast<std::size_t>(c)] = true_crossings_x(people, c);
  for (std::size_t n = 0; n < sizes; ++n) {
    std::array<std::array<TrueTally, 4>, true_curves> tallies;
    int all_held = 0;
    std::array<int, 4> held_together{};
    for (const auto& study : found) {
      int held = 0;
      for (std::size_t q = 0; q < 4; ++q) {
        int together = 0;
        for (std::size_t c = 0; c < tallies.size(); ++c) {
          const int before = tallies[c][q].held;
          const TrueReading& reading = study[n][c][q];
          tallies[c][q].add(reading, truth[c][q], level_x.front(), level_x.back());
          held += q < 2 ? tallies[c][q].held - before : 0;
          const bool inside =
              reading.simultaneous.low_x <= truth[c][q] && truth[c][q] <= reading.simultaneous.high_x;
          together += inside ? 1 : 0;
        }
        held_together[q] += together == true_curves ? 1 : 0;
      }
      all_held += held == 2 * true_curves ? 1 : 0;
    }
    const std::string begin = way + "," + people.name + "," + widths.name + "," +
                              std::to_string(true_sizes[n]) + "," + std::to_string(studies) + ",";
    for (std::size_t c = 0; c < tallies.size(); ++c)
      for (std::size_t q = 0; q < 4; ++q) {
        TrueTally& t = tallies[c][q];
        out << begin << word(paper_artifacts[c]) << "," << true_quantities[q] << "," << std::exp2(truth[c][q])
            << "," << t.percent(t.held) << "," << t.percent(t.too_high) << "," << t.percent(t.too_low) << ","
            << t.percent(t.open) << "," << t.median_length() << "," << t.bias() << "," << t.rmse() << ","
            << t.percent(t.without) << "\n";
      }
    for (std::size_t q = 0; q < 4; ++q)
      out << begin << "simultaneous," << true_quantities[q] << ",," << 100.0 * held_together[q] / studies
          << ",,,,,,,\n";
    out << begin << "all,PT and SN of all,," << 100.0 * all_held / studies << ",,,,,,,\n";
  }
  out.flush();
}

inline constexpr const char* true_coverage_header =
    "way,population,widths,people,studies,artifact,quantity,true_px,coverage_percent,too_high_percent,"
    "too_low_percent,open_percent,median_octaves,bias_octaves,rmse_octaves,without_percent\n";

/// The populations and widths that `file` does not hold yet: a run that was stopped goes on where it was.
inline void continue_true_coverage(const std::filesystem::path& file, const std::string& way, int studies,
                                   const std::function<TrueReadings(const TrueStudy&)>& read,
                                   const std::vector<TrueWidths>& designs = true_widths(),
                                   const std::vector<TruePeople>& populations = true_populations()) {
  std::set<std::string> done;
  std::ifstream before(file);
  for (std::string line; std::getline(before, line);)
    if (line.find(",80," + std::to_string(studies) + ",all,") != std::string::npos)
      done.insert(line.substr(0, line.find(",80,")));
  std::ofstream out(file, std::ios::app);
  if (out.tellp() == 0) out << true_coverage_header;
  for (const TrueWidths& widths : designs)
    for (const TruePeople& people : populations)
      if (!done.contains(way + "," + people.name + "," + widths.name))
        tally_true_coverage(people, widths, studies, read, out, way);
}

}  // namespace seamline::test
