#pragma once
#include <functional>
#include <string>

#include "laboratory/stability/common/stability_case.h"
#include "support/text/csv.h"

namespace seamline::stability {

/// A case with what this run found.
struct CaseOutcome {
  StabilityCase of;
  Finding finding;
  bool passed = false;
  double seconds = 0;
};

/// Runs one case. An exception of the product is a failure whose sentence is what was found; only
/// `Interrupted` is thrown on.
[[nodiscard]] CaseOutcome run_case(const StabilityCase& one, const StabilityOptions& options);

/// Runs cases, those that need much memory one after the other with all threads, the rest side by side with
/// one thread each. `begun` is called before each (number of the case), `done` with the outcomes in the
/// cases' order; neither by two threads at a time.
[[nodiscard]] std::vector<CaseOutcome> run_cases(const StabilityCases& cases, const StabilityOptions& options,
                                                 const std::function<void(std::size_t)>& begun,
                                                 const std::function<void(const CaseOutcome&)>& done);

/// One line for a terminal.
[[nodiscard]] std::string outcome_line(const CaseOutcome& outcome);
/// `seamline lab stability --json`: format, version, and an entry a case.
[[nodiscard]] std::string outcomes_json(const std::vector<CaseOutcome>& outcomes);
/// A row a case, with its group (documentation/evidence/stability/cases.csv).
[[nodiscard]] CsvTable outcomes_table(const std::vector<CaseOutcome>& outcomes);
/// A Markdown table a group.
[[nodiscard]] std::string outcomes_markdown(const std::vector<CaseOutcome>& outcomes);

}  // namespace seamline::stability
