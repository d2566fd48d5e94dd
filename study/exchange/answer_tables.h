#pragma once
#include <optional>
#include <vector>

#include "study/exchange/anonymise.h"
#include "study/log/log.h"
#include "support/text/csv.h"

namespace seamline::study {

/// A log as tables for other programs: `answers` (a row for each answer to a stimulus), `catch_answers`,
/// `participants` (with a column for each question of the form) and `dictionary`, which says what every
/// column is. All participants are in it, the excluded and the simulated too, each marked. `anonymity`: the
/// log is one of `anonymise`, and columns that would tell who came when are left out.
[[nodiscard]] std::vector<CsvTable> answer_tables(const LogContents& log,
                                                  const std::optional<Anonymity>& anonymity = {});

/// The table without the columns that an anonymised one must not have.
[[nodiscard]] CsvTable without_order(CsvTable table, const Anonymity& anonymity);

}  // namespace seamline::study
