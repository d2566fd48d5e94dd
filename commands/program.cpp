// Seamline: study file -> plan -> stimuli -> sessions -> log -> thresholds -> report.
#include "commands/program.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>

#include "commands/answers/answer_commands.h"
#include "commands/demo.h"
#include "commands/depth_cameras/depth_camera_commands.h"
#include "commands/evidence/evidence_commands.h"
#include "commands/former_spelling.h"
#include "commands/options/command_help.h"
#include "commands/photographs/photograph_commands.h"
#include "commands/planning/planning_commands.h"
#include "commands/study/render_command.h"
#include "commands/study/study_commands.h"
#include "support/files/assets.h"
#include "support/text/error.h"
#ifdef SEAMLINE_HAS_WINDOW
#include "composites/place/place_window.h"
#include "live/window/show_live.h"
#include "study/app/run_participant.h"
#endif

namespace seamline {

namespace {

/// `lab`: what shows how well the program itself works, and what only figures of the papers need.
void add_lab(CLI::App& app, bool& any_case_failed) {
  CLI::App* lab =
      app.add_subcommand("lab", "evidence, bench, convergence, stability; scenes, marker, person...");
  lab->require_subcommand(1);
  laboratory::add_evidence_command(*lab);
  renderer::add_bench_command(*lab);
  renderer::add_convergence_command(*lab);
  renderer::add_marker_command(*lab);
  renderer::add_person_command(*lab);
  laboratory::add_scenes_command(*lab);
  renderer::add_field_command(*lab);
  stability::add_stability_command(*lab, any_case_failed);
}

/// What this build has of a window.
struct Windows {
  study::ParticipantRunner of_study = study::refuse_without_window;
  renderer::PlaceInWindow of_place = nullptr;
  live::ShowInWindow of_live = {};
};

Windows windows() {
#ifdef SEAMLINE_HAS_WINDOW
  return {study::app::run_participant_in_window, place::place_in_window, live::show_live};
#else
  return {};
#endif
}

/// Commands of one group of --help.
using AddCommand = std::function<void(CLI::App&)>;

struct CommandGroup {
  const char* name;
  std::vector<AddCommand> commands;  ///< in the order in which they are used
};

std::vector<CommandGroup> command_groups(bool& any_case_failed) {
  const Windows shown = windows();
  return {
      {"A study",
       {add_demo_command, renderer::add_check_command, renderer::add_render_command,
        renderer::add_job_command, [shown](CLI::App& app) { study::add_study_command(app, shown.of_study); },
        study::online::add_serve_command, study::online::add_ask_command, analysis::add_analyze_command}},
      {"Before it",
       {analysis::add_plan_command, analysis::add_predict_command, analysis::add_observe_command,
        analysis::add_freeze_command}},
      {"Answers",
       {study::add_log_command, study::online::add_gathering_commands, study::online::add_export_command,
        analysis::add_fit_command}},
      {"Photographs",
       {[shown](CLI::App& app) { renderer::add_place_command(app, shown.of_place); },
        renderer::add_composite_command, renderer::add_picture_command, renderer::add_flip_command,
        renderer::add_views_command}},
      {"Depth cameras",
       {registration::add_register_command, registration::add_calibrate_command, renderer::add_sense_command,
        live::add_record_command, [shown](CLI::App& app) { live::add_live_command(app, shown.of_live); },
        renderer::add_settle_command, renderer::add_relight_command, sensors::add_animate_command,
        renderer::add_workbench_commands}},
      {"Evidence", {[&any_case_failed](CLI::App& app) { add_lab(app, any_case_failed); }}}};
}

/// An empty text is most often a variable of the shell that is not set: `--slurm "$JOB"` would render
/// everything here and now. Numbers say by themselves what they want.
void refuse_empty_texts(CLI::App& app) {
  for (const NamedCommand& command : every_command(app))
    for (CLI::Option* option : command.app->get_options()) {
      if (option->get_items_expected_max() == 0 || !option->get_type_name().starts_with("TEXT")) continue;
      const std::string field = (option->get_positional() ? "" : "--") + option->get_single_name();
      option->check([field](const std::string& text) {
        if (text.empty())
          throw input_error({.field = field, .wanted = "a text that is not empty", .found = "nothing"});
        return std::string();
      });
    }
}

}  // namespace

std::unique_ptr<CLI::App> program(bool& any_case_failed) {
  auto app = std::make_unique<CLI::App>(
      "Seamline measures how much depth resolution mixed reality needs before people stop seeing the seam.",
      "seamline");
  app->set_version_flag("--version", "seamline " + program_version());
  app->require_subcommand(1);
  app->formatter(help_formatter());
  for (const CommandGroup& group : command_groups(any_case_failed))
    for (const AddCommand& add : group.commands) {
      const std::vector<CLI::App*> before = app->get_subcommands({});
      add(*app);
      for (CLI::App* command : app->get_subcommands({}))
        if (std::find(before.begin(), before.end(), command) == before.end()) command->group(group.name);
    }
  refuse_empty_texts(*app);
  return app;
}

}  // namespace seamline
