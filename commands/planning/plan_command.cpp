#include "commands/planning/planning_commands.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "analysis/foresight/plan_text.h"
#include "commands/planning/plan_options.h"
#include "support/text/number_option.h"

namespace seamline::analysis {

void add_plan_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("plan", "how many participants a wanted precision needs, by simulation");
  const auto options = std::make_shared<PlanOptions>();
  PlanRequest& request = options->request;
  command->add_option("study", request.study_file, "the study file")->required();
  add_number(*command, "--participants", request.participants, {2, 10000}, "numbers of participants to try")
      ->delimiter(',')
      ->capture_default_str();
  add_plan_options(*command, *options);
  command->add_flag("--sequential", request.sequential,
                    "also: ask until the intervals are short enough, looking after each number");
  add_number(*command, "--seed", request.seed, any_seed, "of the simulated people")->capture_default_str();
  command->callback([options] { std::printf("%s", plan_text(plan_study(plan_request(*options))).c_str()); });
}

}  // namespace seamline::analysis
