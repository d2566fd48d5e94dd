#pragma once
#include <filesystem>
#include <string>

#include "analysis/preregistration/archive.h"

namespace seamline::analysis {

struct KitRequest {
  std::filesystem::path folder;   ///< to be written; must not be there yet
  std::filesystem::path archive;  ///< what was frozen, as a file
  std::filesystem::path set;      ///< one of its stimulus sets: it says how many trials a participant has
  std::string published = {};     ///< file of published thresholds, or "paper"; empty: none
  double published_margin = 0.5;
};

/// All that a laboratory needs that repeats a study: the study file, the frozen archive, the consent text
/// with what has to be filled in, the published thresholds, and a page of steps with the number of people,
/// the trials and minutes of each, and every command. Files: README.md, study.toml, frozen.json, consent.txt
/// and, where values were published, published.csv.
///
/// Minutes are trials times 8 to 15 s, and 5 minutes for form and practice: an assumption, and said to be
/// one. Throws InputError when the folder is there, or the set cannot be read.
void write_replication_kit(const KitRequest& request);

}  // namespace seamline::analysis
