#include "analysis/commands/plan_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>

#include "analysis/foresight/plan_text.h"
#include "support/text/number_option.h"

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
  add_number(*command, "--wanted-octaves", request->wanted_octaves, {0.01, 100},
             "width of the 95 % intervals of PT and SN")
      ->capture_default_str();
  add_number(*command, "--participants", request->participants, {2, 10000}, "numbers of participants to try")
      ->delimiter(',')
      ->capture_default_str();
  add_number(*command, "--studies", request->studies, {1, 1000000},
             "simulated studies for each set of widths")
      ->capture_default_str();
  add_number(*command, "--seed", request->seed, any_seed, "of the simulated people")->capture_default_str();
  add_number(*command, "--threads", request->threads, {0, 1024}, "0: as many as the machine has")
      ->capture_default_str();
  command->callback([request] { plan(*request); });
}

}  // namespace seamline::analysis
