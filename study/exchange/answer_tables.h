#pragma once
#include <optional>
#include <string>
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

/// What columns of a log say of places: "1 left, 2 middle, 3 right", or "1 to 5 from the left".
[[nodiscard]] std::string place_words(const LogContents& log);
/// And of choices: "which object was said to be inserted, 1 to 3".
[[nodiscard]] std::string choice_words(const LogContents& log);
/// And of right ones: "1 where that is object_index".
[[nodiscard]] std::string correct_words(const LogContents& log);

/// The table without the columns that an anonymised one must not have.
[[nodiscard]] CsvTable without_order(CsvTable table, const Anonymity& anonymity);

}  // namespace seamline::study
