#include "analysis/commands/plan_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>

#include "analysis/plan_study.h"

namespace seamline::analysis {
namespace {

void plan(PlanRequest request) {
  const std::set<int> sorted(request.participants.begin(), request.participants.end());
  request.participants.assign(sorted.begin(), sorted.end());
  std::printf("%s", plan_text(plan_study(request)).c_str());
}

}  // namespace

void add_plan_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "plan", "how many participants and which widths a wanted interval needs, by simulated studies");
  const auto request = std::make_shared<PlanRequest>();
  command->add_option("study", request->study_file, "the study file")->required();
  command->add_option("--wanted-octaves", request->wanted_octaves, "width of the 95 % intervals of PT and SN")
      ->check(CLI::Range(0.01, 100.0))
      ->capture_default_str();
  command->add_option("--participants", request->participants, "numbers of participants to try")
      ->delimiter(',')
      ->check(CLI::Range(2, 10000))
      ->capture_default_str();
  command->add_option("--studies", request->studies, "simulated studies for each set of widths")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->add_option("--seed", request->seed, "of the simulated people")->capture_default_str();
  command->add_option("--threads", request->threads, "0: as many as the machine has")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command->callback([request] { plan(*request); });
}

}  // namespace seamline::analysis
