#pragma once
#include <string>
#include <vector>

#include "analysis/preregistration/archive.h"

namespace seamline::analysis {

/// One thing that is not as it was frozen.
struct Deviation {
  std::string what;           ///< "exclusion of the screened"
  std::string frozen, found;  ///< in words

  bool operator==(const Deviation&) const = default;
};

/// What was in fact analysed, and how.
struct AnalysisDone {
  std::string program_version, study_hash, set_hash;
  FrozenAnalysis analysis;  ///< `thresholds` and `by_hand` say nothing here
  int participants_used = 0;
  std::vector<std::string> excluded;  ///< codes of those whom people excluded in the log
};

/// An analysis beside the one that was frozen.
struct FrozenComparison {
  std::string archive;                  ///< the file's name
  std::string sha256;                   ///< of its content
  std::vector<std::string> thresholds;  ///< that are confirmatory
  int participants = 0;                 ///< whose answers were to be used
  std::string why_so_many;              ///< in the words that were frozen, with what was assumed of people
  std::vector<Deviation> deviations;    ///< none: data and analysis are those that were frozen
  std::vector<std::string> remarks;     ///< what a reader has to judge, a sentence each
};

/// Every difference, the study first: study, set, program, number of participants, exclusions, options, and
/// rules of the program that are others today.
[[nodiscard]] FrozenComparison compare_with_frozen(const Archive& archive, const AnalysisDone& done);

/// "Data and analysis are those that were frozen." or how many things deviate; a sentence with the hash.
[[nodiscard]] std::string verdict_of(const FrozenComparison& comparison);

/// The same for a methods text: "Data and analysis were those that were frozen." or every deviation by name,
/// with what was frozen and what was found.
[[nodiscard]] std::string deviations_in_words(const FrozenComparison& comparison);

}  // namespace seamline::analysis
