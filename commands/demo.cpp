#include "commands/demo.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <optional>

#include "analysis/analyze_log.h"
#include "analysis/report_folder.h"
#include "sets/render_set.h"
#include "stimuli/study_file/study_file.h"
#include "study/running/simulation.h"
#include "support/files/assets.h"
#include "support/running/progress.h"
#include "support/text/number_option.h"

namespace seamline {
namespace {

constexpr int demo_observers = 20;

/// Study file -> stimuli -> sessions -> log -> thresholds -> report.
void run_demo(const std::filesystem::path& out, std::optional<int> spp) {
  analysis::require_report_folder(out / "report");
  const auto start = std::chrono::steady_clock::now();
  const StudyDefinition study = read_study(builtin_study("quick"));
  fmt::print("1/3 stimuli: {} into {}\n", study.file.string(), (out / "set").string());
  std::fflush(stdout);
  renderer::render_set(study, {.set_folder = out / "set", .spp = spp, .contact_sheet = true});

  const std::filesystem::path log = out / "log.sqlite";
  for (const char* suffix : {"", "-wal", "-shm", "-lock"})
    std::filesystem::remove(log.string() + suffix);  // simulated: made again
  fmt::print("2/3 sessions: {} simulated observers into {}\n", demo_observers, log.string());
  std::fflush(stdout);
  study::run_simulated_study({.set_folder = out / "set", .log = log, .count = demo_observers});

  fmt::print("3/3 analysis\n\n");
  std::fflush(stdout);
  const analysis::AnalysisSummary summary =
      analysis::analyze_log({.log = log, .report_folder = out / "report"});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  fmt::print("{}\nThese answers are simulated: they show the chain, not people.\n", summary.table);
  fmt::print("Done in {}. Open the report in a browser: {}\n", duration_text(seconds),
             std::filesystem::absolute(summary.report_html).lexically_normal().string());
}

}  // namespace

void add_demo_command(CLI::App& app) {
  auto out = std::make_shared<std::string>("out/demo");
  auto spp = std::make_shared<std::optional<int>>();
  CLI::App* demo = app.add_subcommand("demo", "the whole chain, small: stimuli, simulated people, report");
  demo->add_option("--out", *out, "folder of everything the demo makes")->capture_default_str();
  add_number(*demo, "--spp", *spp, {1, 65536},
             "samples a pixel, instead of the study's: fewer are faster and noisier");
  demo->callback([out, spp] { run_demo(*out, *spp); });
}

}  // namespace seamline
