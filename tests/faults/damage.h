#pragma once
#include <string>

#include "lab.h"

namespace seamline::faults {

/// A line of the table of damaged logs.
struct Damage {
  std::string what;
  int tries = 0;
  int refused = 0;    ///< log status says in a sentence that the log is damaged
  int unnoticed = 0;  ///< a value changed into another possible one; the others hit nothing that counts
  std::int64_t answers = 0;       ///< before the damage, summed over the tries
  std::int64_t recovered = 0;     ///< by log recover, as they were
  std::int64_t without_code = 0;  ///< by log recover, of somebody whose code is lost
  std::int64_t changed = 0;       ///< by log recover, with another value
  int nothing_recovered = 0;      ///< tries in which nothing of a log could be read
};

/// `how` is "bit flipped", "page lost" or "cut short".
[[nodiscard]] Damage damage_log(Lab& lab, const std::string& how);

}  // namespace seamline::faults
