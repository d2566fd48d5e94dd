#include "commands/evidence/evidence_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "commands/options/output_files.h"
#include "laboratory/stability/catalogue.h"
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/convergence_cases.h"
#include "laboratory/stability/run_cases.h"
#include "raytracer/common/parallel.h"
#include "support/files/atomic_file.h"
#include "support/files/gnuplot.h"
#include "support/text/number_option.h"

namespace seamline::stability {
namespace {

struct StabilityChoices {
  StabilityOptions options;
  std::string only;
  std::filesystem::path figure, csv;
  bool list = false, json = false, markdown = false;
};

void print_list(const StabilityCases& cases) {
  for (const StabilityCase& one : cases) fmt::print("{}/{}: {}\n", one.group, one.name, one.tried);
}

/// Whether all passed.
bool run_stability(const StabilityChoices& line) {
  const StabilityCases cases = chosen_cases(line.only);
  if (line.list) {
    print_list(cases);
    return true;
  }
  if (!line.figure.empty()) require_gnuplot();
  std::size_t begun = 0, passed = 0;
  const std::vector<CaseOutcome> outcomes = run_cases(
      cases, line.options,
      [&](std::size_t number) {
        fmt::print(stderr, "stability: {} of {}: {}/{}\n", ++begun, cases.size(), cases[number].group,
                   cases[number].name);
      },
      [&](const CaseOutcome& outcome) {
        passed += outcome.passed ? 1 : 0;
        if (line.json || line.markdown) return;
        fmt::print("{}", outcome_line(outcome));
        std::fflush(stdout);
      });
  if (line.json) fmt::print("{}", outcomes_json(outcomes));
  if (line.markdown) fmt::print("{}", outcomes_markdown(outcomes));
  if (!line.csv.empty()) write_file_atomically(line.csv, csv_text(outcomes_table(outcomes)));
  if (!line.json && !line.markdown) fmt::print("{} of {} cases passed\n", passed, cases.size());
  if (!line.figure.empty()) draw_orders(order_series(), line.figure);
  return passed == cases.size();
}

}  // namespace

void add_stability_command(CLI::App& app, bool& any_failed) {
  auto line = std::make_shared<StabilityChoices>();
  line->options.threads = default_thread_count();
  CLI::App* stability =
      app.add_subcommand("stability", "does the program keep its promises on stiff and extreme input");
  stability->add_option("--only", line->only, "one case, or one group of cases");
  stability->add_flag("--list", line->list, "names of the cases; nothing is run");
  stability->add_option("--figure", line->figure,
                        "an SVG file: observed orders of convergence beside the expected ones");
  add_number(*stability, "--threads", line->options.threads, {1, 1024}, "threads of renders and builds");
  auto* json = stability->add_flag("--json", line->json, "as data");
  stability->add_option("--csv", line->csv, "also write the cases to this file, a row each");
  stability->add_flag("--markdown", line->markdown, "as Markdown tables, one a group")->excludes(json);
  stability->callback([line, stability, &any_failed] {
    require_outputs(*stability, {"--csv"});
    any_failed = !run_stability(*line);
  });
}

}  // namespace seamline::stability
