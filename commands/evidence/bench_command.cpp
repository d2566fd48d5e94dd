#include "commands/evidence/evidence_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "commands/options/output_files.h"
#include "laboratory/bench/bench.h"
#include "raytracer/common/parallel.h"
#include "raytracer/tracing/ray_device.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/text/csv.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

struct BenchChoices {
  BenchOptions options;
  std::string only, csv;
  bool json = false;
};

std::string wanted_text(const Wanted& wanted) {
  switch (wanted.kind) {
    case Wanted::Kind::nothing:
      return "";
    case Wanted::Kind::at_least:
      return fmt::format("at least {:g}", wanted.value);
    case Wanted::Kind::at_most:
      return fmt::format("at most {:g}", wanted.value);
  }
  return "";
}

void print_heading(const Benchmark& benchmark) {
  fmt::print("\n{}: {}\n", benchmark.name, benchmark.explain);
  fmt::print("  {:64}  {:12}  {:>9}  {:>9}  {:>7}  wanted\n", "measurement", "unit", "found", "beside",
             "ratio");
}

void print_line(const BenchLine& m) {
  const auto number = [](std::optional<double> value) { return value ? fmt::format("{:.4g}", *value) : ""; };
  const std::optional<bool> met = is_met(m);
  fmt::print("  {:64}  {:12}  {:>9}  {:>9}  {:>7}  {}{}\n", m.what, m.unit, number(m.found), number(m.beside),
             number(m.ratio), wanted_text(m.wanted), met ? (*met ? ": met" : ": NOT MET") : "");
  std::fflush(stdout);
}

nlohmann::ordered_json json_of(std::string_view benchmark, const BenchLine& m) {
  nlohmann::ordered_json json = {
      {"benchmark", benchmark}, {"measurement", m.what}, {"unit", m.unit}, {"found", m.found}};
  json["beside"] = m.beside ? nlohmann::ordered_json(*m.beside) : nlohmann::ordered_json();
  json["ratio"] = m.ratio ? nlohmann::ordered_json(*m.ratio) : nlohmann::ordered_json();
  if (const std::optional<bool> met = is_met(m)) {
    json[m.wanted.kind == Wanted::Kind::at_least ? "wanted_at_least" : "wanted_at_most"] = m.wanted.value;
    json["met"] = *met;
  }
  return json;
}

/// A row a measurement, for figures.
CsvTable table_of_measurements() {
  return {.name = "bench",
          .columns = {{"measurement", "", "what was measured"},
                      {"unit", "", "of found and beside"},
                      {"found", "", "Seamline's"},
                      {"beside", "", "what ran beside it"},
                      {"ratio", "1", "found over beside"},
                      {"wanted", "", "a goal that was set before"}},
          .rows = {}};
}

std::vector<CsvValue> row_of(const BenchLine& m) {
  const auto cell = [](std::optional<double> value) { return value ? CsvValue(*value) : CsvValue(); };
  return {m.what, m.unit, m.found, cell(m.beside), cell(m.ratio), wanted_text(m.wanted)};
}

void run_bench(const BenchChoices& line) {
  CsvTable table = table_of_measurements();
  nlohmann::ordered_json measurements = nlohmann::ordered_json::array();
  if (!line.json)
    fmt::print(
        "Rays a second are of one thread, builds of {}; instruction set {}. Every number is of this run.\n",
        line.options.threads, RayDevice::instruction_set());
  for (const Benchmark& benchmark : benchmarks()) {
    if (!line.only.empty() && line.only != benchmark.name) continue;
    if (!line.json) print_heading(benchmark);
    for (const BenchLine& measurement : benchmark.run(line.options)) {
      table.rows.push_back(row_of(measurement));
      if (line.json)
        measurements.push_back(json_of(benchmark.name, measurement));
      else
        print_line(measurement);
    }
  }
  if (!line.csv.empty()) write_file_atomically(line.csv, csv_text(table));
  if (!line.json) return;
  const nlohmann::ordered_json report = {{"format", "seamline bench 1"},
                                         {"program_version", program_version()},
                                         {"instruction_set", RayDevice::instruction_set()},
                                         {"threads", line.options.threads},
                                         {"quick", line.options.quick},
                                         {"measurements", std::move(measurements)}};
  fmt::print("{}\n", report.dump(2));
}

}  // namespace

void add_bench_command(CLI::App& app) {
  auto line = std::make_shared<BenchChoices>();
  line->options.threads = default_thread_count();
  line->options.said = [](const std::string& found) { fmt::print(stderr, "  {}\n", found); };
  CLI::App* bench = app.add_subcommand("bench", "how fast the renderer is, beside what it could be");
  std::vector<std::string> names;
  for (const Benchmark& benchmark : benchmarks()) names.emplace_back(benchmark.name);
  bench->add_option("--only", line->only, "one benchmark")->check(CLI::IsMember(names));
  bench->add_flag("--quick", line->options.quick, "small: whether it runs, not how fast");
  add_number(*bench, "--threads", line->options.threads, {1, 1024}, "threads of builds and pictures");
  bench->add_option("--csv", line->csv, "also write the measurements to this file, a row each");
  bench->add_flag("--json", line->json, "as data");
  bench->callback([line, bench] {
    require_outputs(*bench, {"--csv"});
    run_bench(*line);
  });
}

}  // namespace seamline::renderer
