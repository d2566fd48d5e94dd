// Drives a whole session by keyboard, with answers that follow from the trial's number.
#pragma once
#include "window_driver.h"

namespace seamline::test {

struct ScriptedAnswer {
  int chosen = 0, rating = 0;
};

inline ScriptedAnswer scripted_answer(int person, int trial) {
  return {1 + (person + trial * 2) % 3, 1 + (person * 3 + trial * 5) % 4};
}

/// Presses what the screen asks for; nothing where it asks for nothing.
inline void press_for(const WindowDriver& window, const Line& line, int person) {
  const std::string screen = line["screen"];
  if (screen == "consent") return window.keys("Tab Tab Return");
  if (screen == "instructions" || screen == "ready" || screen == "break" || screen == "thanks" ||
      screen == "feedback")
    return window.key("Return");
  const std::string phase = line.value("phase", "");
  const ScriptedAnswer answer = scripted_answer(person, line.value("trial", 0));
  if (phase == "choosing") window.key(std::to_string(answer.chosen));
  if (phase == "rating") window.key(std::to_string(answer.rating));
}

/// What identifies a line that asks for something to be pressed.
inline std::string place_of(const Line& line) {
  return line["screen"].get<std::string>() + line.value("phase", "") +
         std::to_string(line.value("trial", -1)) + (line["items"].contains("back") ? "b" : "");
}

/// Presses and waits until `stop` says so or the program has ended. `pressed` hears of every line that was
/// acted on.
inline void drive(WindowDriver& window, int person, const std::function<bool(const Line&)>& stop) {
  std::string acted_on;
  int looks = 0;
  while (window.running()) {
    const std::optional<Line> line = window.now();
    if (line && stop(*line)) return;
    if (line && (place_of(*line) != acted_on || ++looks > 500)) {
      acted_on = place_of(*line);
      looks = 0;
      try {
        press_for(window, *line, person);
      } catch (const std::runtime_error&) {
        return;  // the program was killed under the hand
      }
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(4));
    }
  }
}

}  // namespace seamline::test
