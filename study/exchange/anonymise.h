#pragma once
#include <string>
#include <vector>

#include "study/log/log.h"

namespace seamline::study {

/// One question of the form, as it leaves the house.
struct GroupedField {
  std::string field;
  int smallest_group =
      0;  ///< participants who share an answer, in the smallest group; empty ones count as one
  bool withheld = false;  ///< so few people that every answer is "other"
};

struct AnonymisedLog {
  LogContents log;
  std::vector<GroupedField> fields;
  int smallest_combination = 0;  ///< participants who share all their form answers, in the smallest group
};

/// A log that can be given away. Codes become `p001`, `p002`, ... in an order that says nothing of who came
/// first; times are rounded to a tenth of a second and days are left out; numbers of the form become decades
/// ("20-29"); and an answer of the form that fewer than `k` participants share becomes "other" together with
/// the next rarest, until `k` share that, too. Who is excluded, simulated or a trial run stays known. Equal
/// logs give equal results. Throws InputError when k is below 2.
[[nodiscard]] AnonymisedLog anonymise(LogContents log, int k);

}  // namespace seamline::study
