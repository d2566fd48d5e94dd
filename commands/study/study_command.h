#pragma once
#include "study/running/participant_request.h"

namespace CLI {
class App;
}

namespace seamline::study {

/// The runner of a build without a window: throws InputError saying so.
[[noreturn]] void refuse_without_window(const ParticipantRequest& request);

/// `seamline study`: a person in a window, or simulated people.
void add_study_command(CLI::App& app, const ParticipantRunner& run_participant = refuse_without_window);

}  // namespace seamline::study
