#pragma once
#include <filesystem>
#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace seamline::study {

/// What `seamline study SET --log LOG --participant CODE [--pilot]
/// [--allow-scaling] [--frame-times CSV]` asks for.
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

/// The runner of a build without a window: throws InputError saying so.
[[noreturn]] void refuse_without_window(const ParticipantRequest& request);

/// Adds the subcommands of `study/` to the program. Each is parse, load, compute, write.
void add_study_commands(CLI::App& app, const ParticipantRunner& run_participant = refuse_without_window);

}  // namespace seamline::study
