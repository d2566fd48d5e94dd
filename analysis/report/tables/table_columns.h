#pragma once
#include <cmath>
#include <cstdint>
#include <string>

#include "support/text/csv.h"

namespace seamline::analysis {

// Columns and values that several tables of the report share, so that they are explained once and alike.

inline const CsvColumn artifact_column{"artifact", "word",
                                       "receiver, shadow, occlusion or overlap (types 1 to 4 of the paper)"};
inline const CsvColumn quantity_column{
    "quantity", "word", "PT perceptual threshold, SN slightly noticeable, IP inflection point"};
inline const CsvColumn scene_column{"scene", "text", "name of the scene in the study file"};
inline const CsvColumn object_column{"object", "text", "name of the inserted object"};
inline const CsvColumn index_column{"object_index", "1 to 3", "its place: 1 left, 2 middle, 3 right"};
inline const CsvColumn width_column{"width_px", "px", "width W of the depth map; its height is W / 2"};
inline const CsvColumn participant_column{"participant", "text", "code"};
inline const CsvColumn source_column{"source", "text", "who answered: participants or simulated observers"};

[[nodiscard]] inline std::int64_t whole(auto value) {
  return static_cast<std::int64_t>(value);
}

/// The number, or an empty cell when it is NaN or infinite (an open end).
[[nodiscard]] inline CsvValue finite(double value) {
  return std::isfinite(value) ? CsvValue(value) : CsvValue(std::monostate{});
}

}  // namespace seamline::analysis
