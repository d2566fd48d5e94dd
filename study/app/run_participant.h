#pragma once
#include "study/running/participant_request.h"

namespace seamline::study::app {

/// Runs a person's session in a window, from consent to thanks; the ParticipantRunner of builds with a
/// window. Throws InputError when there is no screen, the pictures do not fit it, the log refuses the
/// participant, or the session stopped because something could not be stored.
void run_participant_in_window(const ParticipantRequest& request);

}  // namespace seamline::study::app
