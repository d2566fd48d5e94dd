#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "stimuli/definition/artifact.h"

namespace seamline::analysis {

/// One threshold as somebody published it.
struct PublishedThreshold {
  Artifact artifact = Artifact::none;
  std::string condition;            ///< of this study, beside which it stands; empty: its only one
  std::string quantity;             ///< "PT", "SN", "IP", "PT corrected", "SN corrected" or "detection"
  std::optional<double> level;      ///< in the unit of the study's level; none where nothing was reported
  std::optional<double> low, high;  ///< its 95 % interval; none: the value is taken as exact
  std::optional<int> participants;  ///< behind it
  std::string source;               ///< where it stands, in words
};

struct PublishedThresholds {
  std::string name;    ///< of the file, or "the paper's Table 1"
  std::string sha256;  ///< of the file's bytes; empty for values that the program holds
  std::vector<PublishedThreshold> values;
};

/// The word that stands for the values of "Visual Perception of Real World Depth Map Resolution for Mixed
/// Reality Rendering", Table 1.
inline constexpr const char* published_paper_word = "paper";

/// Reads a CSV table with the columns artifact, quantity and value, and, where they are known, condition,
/// low, high, n and source; or the paper's values for the word "paper". An empty value says that nothing was
/// reported. Throws InputError at an artifact or quantity that there is not, a value that is no positive
/// number, an interval that does not hold its value or lacks an end, and a threshold that stands there twice.
[[nodiscard]] PublishedThresholds read_published(const std::string& file_or_word);

}  // namespace seamline::analysis
