#pragma once
#include <filesystem>
#include <optional>

#include "study/exchange/anonymise.h"

namespace seamline::study {

/// What `seamline export LOG --csv DIR` asks for.
struct TableRequest {
  std::filesystem::path log;
  std::filesystem::path out_folder;     ///< not there yet, or empty
  std::optional<int> anonymise_k = {};  ///< the smallest group of `anonymise`; none: as it is
};

struct TableSummary {
  int participants = 0;
  int answers = 0;
  std::vector<GroupedField> fields = {};  ///< of an anonymised log
  int smallest_combination = 0;
};

/// Writes the tables of `answer_tables` as CSV: whole or not at all, the same bytes for the same log and
/// program. Throws InputError when the log cannot be read or the folder holds something.
TableSummary export_tables(const TableRequest& request);

}  // namespace seamline::study
