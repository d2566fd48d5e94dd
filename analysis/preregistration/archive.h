#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace seamline::analysis {

/// How a log will be analysed, and what of it is the outcome that was promised.
struct FrozenAnalysis {
  std::vector<std::string> thresholds;  ///< PT, SN, IP: those that are confirmatory; others explore
  bool include_pilot = false;
  bool exclude_screened = false;
  bool exclude_inattentive = false;  ///< those whom catch trials name
  bool exclude_uncorrected = false;  ///< those whose vision is neither normal nor corrected
  double field_of_view_deg = 90;
  int bootstrap_replicates = 10000;
  std::uint64_t seed = 1;                 ///< of the bootstrap
  std::vector<std::string> rules;         ///< the program's own, a sentence each (`rules_of_analysis`)
  std::string by_hand;                    ///< whom people will exclude, in words; empty: nobody
  std::vector<std::string> compare = {};  ///< what people are grouped by (analyze --compare)

  bool operator==(const FrozenAnalysis&) const = default;
};

struct FrozenSet {
  std::string set_hash;  ///< SHA-256 of its manifest, which holds the hashes of its pictures
  int stimuli = 0;

  bool operator==(const FrozenSet&) const = default;
};

/// Everything that is decided before anybody is asked.
struct Preregistration {
  std::string program_version;
  std::string study_name, study_hash;
  std::string study_text;  ///< the study file, byte for byte
  std::vector<FrozenSet> sets;
  FrozenAnalysis analysis;
  int participants = 0;           ///< whose answers will be used
  std::string why_so_many;        ///< in words
  std::vector<std::string> plan;  ///< lines of `seamline plan`, where it said how many; else none

  bool operator==(const Preregistration&) const = default;
};

/// A preregistration as it was read, with its hash.
struct Archive {
  std::filesystem::path file;
  Preregistration content;
  std::string sha256;
};

/// One JSON file. Its last key is `sha256`: that of all lines before it, so that
/// `head -n -2 FILE | sha256sum` says the same.
[[nodiscard]] std::string archive_text(const Preregistration& content);

/// Throws InputError when the file is no archive, or not all of its bytes are those that were frozen.
[[nodiscard]] Archive read_archive(const std::filesystem::path& file);

/// The rules that no option changes: who is left out, what each screen says, what the thresholds are.
[[nodiscard]] std::vector<std::string> rules_of_analysis();

}  // namespace seamline::analysis
