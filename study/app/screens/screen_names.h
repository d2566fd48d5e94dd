#pragma once
#include <string>

#include "study/visit/visit.h"

namespace seamline::study::app {

/// Short names of screens and phases, for traces.
[[nodiscard]] std::string screen_name(const Screen& screen);
[[nodiscard]] std::string phase_name(const Phase& phase);

/// Whether Esc begins a pause here.
[[nodiscard]] bool is_pausable(const Screen& screen);

}  // namespace seamline::study::app
