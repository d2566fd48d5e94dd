// Seamline: study file -> plan -> stimuli -> sessions -> log -> thresholds -> report.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>

#include "analysis/commands/commands.h"
#include "demo.h"
#include "renderer/commands.h"
#include "stability/commands.h"
#include "stimuli/support/assets.h"
#include "stimuli/support/error.h"
#include "stimuli/support/interrupt.h"
#include "stimuli/support/memory.h"
#include "study/commands.h"
#ifdef SEAMLINE_HAS_WINDOW
#include "study/app/run_participant.h"
#endif

namespace {

constexpr int exit_wrong_input = 1;
constexpr int exit_unstable = 1;
constexpr int exit_bug = 2;
constexpr int exit_interrupted = 130;

int run(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_wrong_input;
  }
}

}  // namespace

int main(int argc, char** argv) {
  seamline::keep_freed_memory();
  CLI::App app{
      "Seamline measures how much depth resolution mixed reality needs before people stop seeing the seam.",
      "seamline"};
  app.set_version_flag("--version", "seamline " + seamline::program_version());
  app.require_subcommand(1);
  seamline::add_demo_command(app);
  seamline::renderer::add_renderer_commands(app);
#ifdef SEAMLINE_HAS_WINDOW
  seamline::study::add_study_commands(app, seamline::study::app::run_participant_in_window);
#else
  seamline::study::add_study_commands(app);
#endif
  seamline::analysis::add_analysis_commands(app);
  bool any_case_failed = false;
  seamline::stability::add_stability_command(app, any_case_failed);
  seamline::catch_interrupts();
  try {
    const int status = run(app, argc, argv);
    return status == 0 && any_case_failed ? exit_unstable : status;
  } catch (const seamline::InputError& error) {
    std::fprintf(stderr, "seamline: %s\n", error.what());
    return exit_wrong_input;
  } catch (const seamline::Interrupted&) {
    std::fprintf(stderr, "seamline: stopped; run the same command again to continue\n");
    return exit_interrupted;
  } catch (const std::filesystem::filesystem_error& error) {
    std::fprintf(stderr, "seamline: %s: wanted a path that can be used, found %s\n", error.path1().c_str(),
                 error.code().message().c_str());
    return exit_wrong_input;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "seamline: wanted input that fits into memory, found more than there is\n");
    return exit_wrong_input;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "seamline: this is a bug in seamline: %s\n", error.what());
    return exit_bug;
  }
}
