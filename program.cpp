// Seamline: study file -> plan -> stimuli -> sessions -> log -> thresholds -> report.
#include "program.h"

#include <CLI/CLI.hpp>

#include "analysis/commands/commands.h"
#include "demo.h"
#include "live/commands/commands.h"
#include "registration/commands/commands.h"
#include "renderer/commands/commands.h"
#include "renderer/commands/pictures/x3d_options.h"
#include "stability/commands.h"
#include "study/commands/commands.h"
#include "study/online/commands/export_command.h"
#include "study/online/commands/serve_command.h"
#include "support/files/assets.h"
#include "support/text/error.h"
#ifdef SEAMLINE_HAS_WINDOW
#include "live/window/show_live.h"
#include "place/place_window.h"
#include "study/app/run_participant.h"
#endif

namespace seamline {

namespace {

/// An empty text is most often a variable of the shell that is not set: `--slurm "$JOB"` would render
/// everything here and now. Numbers say by themselves what they want.
void refuse_empty_texts(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    for (CLI::Option* option : command->get_options()) {
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
  study::online::add_gathering_commands(*app);
  study::online::add_export_command(*app, [](CLI::App& command) {
    const renderer::X3dExport x3d = renderer::add_x3d_options(command);
    return study::online::OtherPage{.flag = "--x3d", .is_asked = x3d.is_asked, .write = x3d.write};
  });
  analysis::add_analysis_commands(*app);
  registration::add_registration_commands(*app);
  stability::add_stability_command(*app, any_case_failed);
  refuse_empty_texts(*app);
  return app;
}

}  // namespace seamline
