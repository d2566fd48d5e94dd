#pragma once
#include "study/running/participant_request.h"

namespace CLI {
class App;
}

namespace seamline::study {

/// The runner of a build without a window: throws InputError saying so.
[[noreturn]] void refuse_without_window(const ParticipantRequest& request);

/// Adds the subcommands of `study/` to the program. Each is parse, load, compute, write.
void add_study_commands(CLI::App& app, const ParticipantRunner& run_participant = refuse_without_window);

}  // namespace seamline::study
