// Seamline: study file -> plan -> stimuli -> sessions -> log -> thresholds -> report.
#include "commands/program.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "commands/analysis_commands.h"
#include "commands/answers/export_command.h"
#include "commands/demo.h"
#include "commands/depth_cameras/live_commands.h"
#include "commands/depth_cameras/registration_commands.h"
#include "commands/evidence/stability_command.h"
#include "commands/options/command_help.h"
#include "commands/photographs/x3d_options.h"
#include "commands/renderer_commands.h"
#include "commands/study/ask_command.h"
#include "commands/study/serve_command.h"
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

/// The commands of --help, under what they are for, in the order in which they are used.
struct CommandGroup {
  const char* name;
  std::vector<const char*> commands;
};

const std::vector<CommandGroup>& command_groups() {
  static const std::vector<CommandGroup> groups = {
      {"A study", {"demo", "check", "render", "verify", "study", "serve", "ask", "analyze"}},
      {"Before it", {"plan", "predict", "freeze"}},
      {"Answers", {"log", "import", "merge", "export", "fit"}},
      {"Photographs", {"place", "composite", "picture", "flip", "views"}},
      {"Depth cameras",
       {"register", "calibrate", "sense", "record", "live", "settle", "relight", "capture", "mesh"}},
      {"Evidence", {"lab"}}};
  return groups;
}

void group_commands(CLI::App& app) {
  for (const CommandGroup& group : command_groups())
    for (const char* name : group.commands) app.get_subcommand(name)->group(group.name);
}

/// --help lists commands as they stand here, whatever library adds them first.
void order_commands(CLI::App& app) {
  for (const CommandGroup& group : command_groups())
    for (const char* name : group.commands) {
      const CLI::App_p command = app.get_subcommand_ptr(name);
      app.remove_subcommand(command.get());
      app.add_subcommand(command);
    }
}

/// `lab`: what shows how well the program itself works, and what only figures of the papers need.
void add_lab(CLI::App& app, bool& any_case_failed) {
  CLI::App* lab = app.add_subcommand("lab", "bench, convergence, stability; marker, person, field");
  lab->require_subcommand(1);
  renderer::add_lab_commands(*lab);
  stability::add_stability_command(*lab, any_case_failed);
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
  add_demo_command(*app);
#ifdef SEAMLINE_HAS_WINDOW
  renderer::add_renderer_commands(*app, place::place_in_window);
  study::add_study_commands(*app, study::app::run_participant_in_window);
  live::add_live_commands(*app, live::show_live);
#else
  renderer::add_renderer_commands(*app);
  study::add_study_commands(*app);
  live::add_live_commands(*app);
#endif
  study::online::add_serve_command(*app);
  study::online::add_ask_command(*app);
  study::online::add_gathering_commands(*app);
  study::online::add_export_command(*app, [](CLI::App& command) {
    const renderer::X3dExport x3d = renderer::add_x3d_options(command);
    return study::online::OtherPage{.flag = "--x3d", .is_asked = x3d.is_asked, .write = x3d.write};
  });
  analysis::add_analysis_commands(*app);
  registration::add_registration_commands(*app);
  add_lab(*app, any_case_failed);
  app->get_subcommand("analyze")->alias("analyse");
  order_commands(*app);
  group_commands(*app);
  refuse_empty_texts(*app);
  return app;
}

std::vector<std::string> todays_spelling(std::vector<std::string> arguments) {
  if (arguments.empty()) return arguments;
  static const std::vector<std::string> moved = {"bench",  "convergence", "stability",
                                                 "marker", "person",      "field"};
  if (std::find(moved.begin(), moved.end(), arguments.front()) == moved.end()) return arguments;
  std::fprintf(stderr, "seamline: %s is now lab %s; the old spelling ends with the next version\n",
               arguments.front().c_str(), arguments.front().c_str());
  arguments.insert(arguments.begin(), "lab");
  return arguments;
}

}  // namespace seamline
