#pragma once
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/ordinal/contrasts/study_model.h"
#include "tests/analysis/true_coverage.h"

namespace seamline::test {

/// Whether a way of analysis said "differs" of anything in a family of contrasts.
struct SaidDiffers {
  bool slopes = false, levels = false;
};

/// The ordinal model's sentences, each family corrected for the number of its contrasts.
inline SaidDiffers said_by_ordinal_model(const TrueStudy& study) {
  const OrdinalStudy found = fit_ordinal_study(answers_of(study), {}, {.fit = {.nodes = 5, .threads = 1}});
  SaidDiffers said;
  for (const ContrastTable& table : found.contrasts) {
    const bool slopes = table.question.find("Do artifacts differ in how") != std::string::npos;
    if (!slopes && table.question.find("artifacts differ") == std::string::npos) continue;
    for (const ContrastRow& row : table.rows)
      if (row.verdict == ContrastVerdict::differs) (slopes ? said.slopes : said.levels) = true;
  }
  return said;
}

/// Writes how often a way of analysis is wrong in a family: "slopes" of the population as it is, whose slopes
/// are all equal, "levels" of the same people with equal midpoints. Goes on in `file` where a run stopped.
inline void continue_false_sentences(const std::filesystem::path& file, const std::string& way, int studies,
                                     const std::vector<int>& sizes,
                                     const std::function<SaidDiffers(const TrueStudy&)>& say) {
  std::set<std::string> done;
  std::ifstream before(file);
  for (std::string line; std::getline(before, line);) done.insert(line.substr(0, line.rfind(',')));
  std::ofstream out(file, std::ios::app);
  if (out.tellp() == 0) out << "way,population,people,studies,family,false_percent\n";
  const TrueWidths widths = true_widths().front();
  const std::vector<double> level_x = log2_widths(widths.width_px);
  for (const int size : sizes)
    for (const TruePeople& people : true_populations())
      for (const bool equal : {false, true}) {
        const std::string begin = way + "," + people.name + "," + std::to_string(size) + "," +
                                  std::to_string(studies) + "," + (equal ? "levels" : "slopes");
        if (done.contains(begin)) continue;
        std::vector<char> wrong(static_cast<std::size_t>(studies));
        run_parallel(studies, 0, [&](int index) {
          const TruePeople those = equal ? with_equal_midpoints(people) : people;
          const SaidDiffers said = say(
              {.width_px = widths.width_px,
               .people = answer_as_people(those, size, level_x, 5000 + static_cast<std::uint64_t>(index))});
          wrong[static_cast<std::size_t>(index)] = (equal ? said.levels : said.slopes) ? 1 : 0;
        });
        out << begin << ","
            << 100.0 * static_cast<double>(std::count(wrong.begin(), wrong.end(), 1)) / studies << "\n";
        out.flush();
      }
}

}  // namespace seamline::test
