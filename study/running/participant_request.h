#pragma once
#include <filesystem>
#include <functional>
#include <string>

namespace seamline::study {

/// What a person's session in a window works on.
struct ParticipantRequest {
  std::filesystem::path set_folder = {};
  std::filesystem::path log = {};
  std::string code = {};
  std::string language = {};  ///< of the study's; empty: its own
  bool pilot = false;
  bool allow_scaling = false;              ///< show pictures that do not fit smaller, and say so in the log
  std::filesystem::path frame_times = {};  ///< CSV for the time of every frame; empty: none
  bool windowed = false;                   ///< a window instead of the whole screen
  bool display_check = false;              ///< measure the screen again, though it is known
  std::filesystem::path trace = {};        ///< what is on the screen, for tests that drive it; empty: none
};

/// Runs a person's session in a window. `study/app/` provides one where there is a display; study/ knows
/// none.
using ParticipantRunner = std::function<void(const ParticipantRequest&)>;

}  // namespace seamline::study
