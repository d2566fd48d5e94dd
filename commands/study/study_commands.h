#pragma once
#include "study/running/participant_request.h"

// A study: what each file of this folder adds to the command line; render_command.h adds `render`.

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline check`.
void add_check_command(CLI::App& app);

/// `seamline job`: a set made by many machines.
void add_job_command(CLI::App& app);

}  // namespace seamline::renderer

namespace seamline::study {

/// The runner of a build without a window: throws InputError saying so.
[[noreturn]] void refuse_without_window(const ParticipantRequest& request);

/// `seamline study`: a person in a window, or simulated people.
void add_study_command(CLI::App& app, const ParticipantRunner& run_participant = refuse_without_window);

}  // namespace seamline::study

namespace seamline::study::online {

/// Adds `seamline serve`.
void add_serve_command(CLI::App& app);

/// `seamline ask`: a session whose pictures another program shows.
void add_ask_command(CLI::App& app);

}  // namespace seamline::study::online

namespace seamline::analysis {

/// `seamline analyze`: thresholds, figures and a report from a log.
void add_analyze_command(CLI::App& app);

}  // namespace seamline::analysis
