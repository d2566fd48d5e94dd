#pragma once
#include <chrono>
#include <string>

namespace seamline {

/// One line on standard error that says how far a long job is and how long it will still take. On a terminal
/// the line is rewritten in place; in a file a line is printed at most every ten seconds.
class Progress {
 public:
  /// `work_total` in any unit that grows evenly with time (samples, pixels, stimuli).
  Progress(std::string title, double work_total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Adds finished work; `now_doing` names the piece under way. Not thread-safe: call from one thread.
  void advance(double work, const std::string& now_doing);

 private:
  using Clock = std::chrono::steady_clock;
  void print(const std::string& now_doing);

  std::string title_;
  double work_total_;
  double work_done_ = 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_print_{};
  bool on_terminal_;
};

/// "2 h 05 min", "3 min 20 s", "14 s".
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace seamline
