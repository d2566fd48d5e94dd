#pragma once
#include <string>

#include "analysis/scores/level_axis.h"

namespace seamline::analysis {

/// The words with which sentences speak of a study's levels. A sentence is written once, with these in its
/// places; none is made by replacing words in another sentence.
struct LevelWords {
  std::string level;     ///< "width"; "level"
  std::string levels;    ///< "widths"; "levels"
  std::string Levels;    ///< the same at the beginning of a sentence
  std::string quantity;  ///< "depth map width"; "mesh tolerance"
  std::string sought;    ///< what PT and SN are: "the largest depth map widths"; "the smallest levels of the
                         ///< angular radius of the sun"
  std::string symbol;    ///< "width W"; "level"
  std::string axis;      ///< on which curves are smooth: "log2 width", "log2 level", "the level"
  std::string short_axis;            ///< "log2 W", "log2 level", "the level"
  std::string with_level;            ///< "with width"; "with the level"
  std::string falls, fall, falling;  ///< how noticeability changes with the level: "falls"; "rises"
  std::string monotone;              ///< "non-increasing"; "non-decreasing"
};

[[nodiscard]] LevelWords level_words(const LevelAxis& axis);

/// Why there is no estimate, for people: "above 512"; empty where there is one.
[[nodiscard]] std::string reason_text(const ThresholdEstimate& estimate, const LevelAxis& axis);

}  // namespace seamline::analysis
