#pragma once
#include <filesystem>
#include <optional>

#include "study/exchange/anonymise.h"
#include "study/exchange/dataset.h"

namespace seamline::study {

/// What `seamline export tables LOG DIR` asks for.
struct TableRequest {
  std::filesystem::path log;
  std::filesystem::path out_folder;     ///< not there yet, or empty
  std::optional<int> anonymise_k = {};  ///< the smallest group of `anonymise`; none: as it is
  TableLayout layout = TableLayout::plain;
};

struct TableSummary {
  int participants = 0;
  int answers = 0;
  std::optional<Anonymity> anonymity = {};
  std::vector<GroupedField> fields = {};  ///< of an anonymised log
  int smallest_group = 0;
};

/// Writes the tables of `answer_tables` in the layout: whole or not at all, the same bytes for the same log
/// and program. What is not anonymised is for its owner's eyes alone (0600, as the log). Throws InputError
/// when the log cannot be read or the folder holds something.
TableSummary export_tables(const TableRequest& request);

}  // namespace seamline::study
