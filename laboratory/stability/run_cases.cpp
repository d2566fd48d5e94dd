#include "laboratory/stability/run_cases.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

#include "laboratory/stability/common/namespaces.h"
#include "raytracer/tracing/ray_device.h"
#include "support/files/assets.h"
#include "support/files/markdown_table.h"
#include "support/running/interrupt.h"
#include "support/running/parallel.h"
#include "support/text/numbers.h"

namespace seamline::stability {
namespace {

std::string number(double value) {
  return fmt::format("{:.3g}", value);
}

/// NaN and infinity, which JSON does not have, as words.
nlohmann::ordered_json json_number(double value) {
  if (std::isfinite(value)) return value;
  return number(value);
}

}  // namespace

CaseOutcome run_case(const StabilityCase& one, const StabilityOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  CaseOutcome outcome{.of = one, .finding = {}};
  try {
    outcome.finding = one.run(options);
  } catch (const std::exception& error) {
    outcome.finding = {.error = nan, .found = std::string("stopped: ") + error.what()};
  }
  outcome.passed = outcome.finding.error <= one.tolerance;  // false for NaN
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

std::vector<CaseOutcome> run_cases(const StabilityCases& cases, const StabilityOptions& options,
                                   const std::function<void(std::size_t)>& begun,
                                   const std::function<void(const CaseOutcome&)>& done) {
  std::vector<std::optional<CaseOutcome>> outcomes(cases.size());
  std::size_t told = 0;
  std::mutex mutex;
  const auto run = [&](std::size_t number, const StabilityOptions& how) {
    {
      const std::lock_guard lock(mutex);
      begun(number);
    }
    CaseOutcome outcome = run_case(cases[number], how);
    const std::lock_guard lock(mutex);
    outcomes[number] = std::move(outcome);
    for (; told < outcomes.size() && outcomes[told]; ++told) done(*outcomes[told]);
  };
  std::vector<std::size_t> beside;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    stop_if_interrupted();
    if (cases[i].slow)
      run(i, options);
    else
      beside.push_back(i);
  }
  run_parallel(static_cast<int>(beside.size()), options.threads,
               [&](int i) { run(beside[i], {.threads = 1}); });
  std::vector<CaseOutcome> all;
  for (std::optional<CaseOutcome>& outcome : outcomes) all.push_back(std::move(outcome.value()));
  return all;
}

std::string outcome_line(const CaseOutcome& outcome) {
  const StabilityCase& one = outcome.of;
  return fmt::format("{}  {}/{}: {}; expected {}; found {}; error {} of at most {} {} ({})\n",
                     outcome.passed ? "pass" : "FAIL", one.group, one.name, one.tried, one.expected,
                     outcome.finding.found, number(outcome.finding.error), number(one.tolerance), one.unit,
                     one.reason);
}

std::string outcomes_json(const std::vector<CaseOutcome>& outcomes) {
  nlohmann::ordered_json cases = nlohmann::ordered_json::array();
  int failed = 0;
  for (const CaseOutcome& outcome : outcomes) {
    failed += outcome.passed ? 0 : 1;
    cases.push_back({{"group", outcome.of.group},
                     {"name", outcome.of.name},
                     {"tried", outcome.of.tried},
                     {"expected", outcome.of.expected},
                     {"found", outcome.finding.found},
                     {"error", json_number(outcome.finding.error)},
                     {"tolerance", outcome.of.tolerance},
                     {"unit", outcome.of.unit},
                     {"reason_of_tolerance", outcome.of.reason},
                     {"passed", outcome.passed},
                     {"seconds", outcome.seconds}});
  }
  const nlohmann::ordered_json report = {{"format", "seamline stability 1"},
                                         {"program_version", program_version()},
                                         {"instruction_set", RayDevice::instruction_set()},
                                         {"cases", outcomes.size()},
                                         {"failed", failed},
                                         {"results", std::move(cases)}};
  return report.dump(2) + "\n";
}

CsvTable outcomes_table(const std::vector<CaseOutcome>& outcomes) {
  CsvTable table{.name = "cases",
                 .columns = {{"group", "", ""},
                             {"case", "", ""},
                             {"tried", "", ""},
                             {"expected", "", ""},
                             {"found", "", ""},
                             {"error", "", ""},
                             {"tolerance", "", ""},
                             {"unit", "", ""},
                             {"where_the_tolerance_comes_from", "", ""},
                             {"verdict", "", ""}},
                 .rows = {}};
  for (const CaseOutcome& outcome : outcomes)
    table.rows.push_back({outcome.of.group, outcome.of.name, outcome.of.tried, outcome.of.expected,
                          outcome.finding.found, number(outcome.finding.error), number(outcome.of.tolerance),
                          outcome.of.unit, outcome.of.reason, std::string(outcome.passed ? "pass" : "FAIL")});
  return table;
}

std::string outcomes_markdown(const std::vector<CaseOutcome>& outcomes) {
  std::string text;
  for (auto first = outcomes.begin(); first != outcomes.end();) {
    const std::string& group = first->of.group;
    const auto next =
        std::find_if(first, outcomes.end(), [&](const CaseOutcome& one) { return one.of.group != group; });
    CsvTable table = outcomes_table({first, next});
    table.columns.erase(table.columns.begin());  // the group is the heading
    for (CsvColumn& column : table.columns) std::replace(column.name.begin(), column.name.end(), '_', ' ');
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      table.rows[i].erase(table.rows[i].begin());
      table.rows[i].front() = "`" + (first + static_cast<std::ptrdiff_t>(i))->of.name + "`";
    }
    text += "### " + group + "\n\n" + markdown_table(table) + "\n";
    first = next;
  }
  return text;
}

}  // namespace seamline::stability
