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
#ifdef SEAMLINE_HAS_WINDOW
#include "live/window/show_live.h"
#include "place/place_window.h"
#include "study/app/run_participant.h"
#endif

namespace seamline {

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
  return app;
}

}  // namespace seamline
