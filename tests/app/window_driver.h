// Runs the program in a window on an X server, and does to it what a person does.
#pragma once
#include <fmt/core.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <thread>

#include "x_server.h"

namespace seamline::test {

using Line = nlohmann::json;  ///< of the trace: what is on the screen

struct WindowRun {
  std::filesystem::path set = {}, log = {};
  std::string code = "p01";
  std::string options = {};           ///< further ones of `seamline study`
  std::filesystem::path folder = {};  ///< for the trace, the output and the configuration
};

class WindowDriver {
 public:
  WindowDriver(const XServer& server, const WindowRun& run)
      : display_(server.display()), trace_(run.folder / "trace"), output_(run.folder / "output") {
    std::filesystem::create_directories(run.folder);
    std::filesystem::remove(trace_);
    const std::string command = fmt::format(
        "exec env -u WAYLAND_DISPLAY DISPLAY={} XDG_CONFIG_HOME='{}' LIBGL_ALWAYS_SOFTWARE=1 "
        "ASAN_OPTIONS=detect_leaks=0 '{}' "
        "study '{}' --log '{}' --participant {} --trace '{}' {} >'{}' 2>&1 </dev/null",
        display_, (run.folder / "config").string(), SEAMLINE_PROGRAM, run.set.string(), run.log.string(),
        run.code, trace_.string(), run.options, output_.string());
    child_ = ::fork();
    if (child_ == 0) {
      ::execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
      ::_exit(127);
    }
  }
  ~WindowDriver() {
    if (child_ > 0) kill();
  }
  WindowDriver(const WindowDriver&) = delete;
  WindowDriver& operator=(const WindowDriver&) = delete;

  /// The newest complete line of the trace; none before the first frame.
  [[nodiscard]] std::optional<Line> now() const {
    std::ifstream in(trace_, std::ios::binary | std::ios::ate);
    if (!in) return std::nullopt;
    constexpr std::streamoff enough = 16384;  // for the last lines of a long trace
    const std::streamoff size = in.tellg();
    in.seekg(std::max<std::streamoff>(0, size - enough));
    std::ostringstream tail;
    tail << in.rdbuf();
    const std::string text = tail.str();
    const std::size_t end = text.rfind('\n');
    if (end == std::string::npos) return std::nullopt;
    const std::size_t begin = end == 0 ? 0 : text.rfind('\n', end - 1) + 1;
    return Line::parse(text.substr(begin, end - begin));
  }

  /// Waits until the screen is as wanted; throws when it never is.
  Line wait(const std::string& wanted, const std::function<bool(const Line&)>& is_so) {
    for (int look = 0; look < 6000; ++look) {
      const std::optional<Line> line = now();
      if (line && is_so(*line)) return *line;
      if (!running()) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    throw std::runtime_error("waited for " + wanted + ", but " +
                             (running() ? "the screen is " : "it ended: ") +
                             (now() ? now()->dump() : "nothing") + "; " + output());
  }
  Line wait_screen(const std::string& screen) {
    return wait(screen, [&](const Line& line) { return line["screen"] == screen; });
  }
  /// A trial (or practice trial) by its number, in a phase.
  Line wait_trial(const std::string& screen, int trial, const std::string& phase) {
    return wait(fmt::format("{} {} {}", screen, trial, phase), [&](const Line& line) {
      return line["screen"] == screen && line.value("trial", -1) == trial && line.value("phase", "") == phase;
    });
  }

  void key(const std::string& name) const { xdotool("key " + name); }
  void keys(const std::string& names) const { xdotool("key --delay 30 " + names); }
  void type(const std::string& text) const { xdotool("type --delay 30 '" + text + "'"); }
  void move(double x_px, double y_px) const { xdotool(fmt::format("mousemove {:.0f} {:.0f}", x_px, y_px)); }
  void click(double x_px, double y_px) const {
    xdotool(fmt::format("mousemove {:.0f} {:.0f} click 1", x_px, y_px));
  }
  void drag(double from_x_px, double from_y_px, double to_x_px, double to_y_px) const {
    xdotool(fmt::format("mousemove {:.0f} {:.0f} mousedown 1 mousemove {:.0f} {:.0f} mouseup 1", from_x_px,
                        from_y_px, to_x_px, to_y_px));
  }
  /// The middle of a rectangle of the trace.
  void click(const Line& rect) const {
    click(rect[0].get<double>() + rect[2].get<double>() / 2,
          rect[1].get<double>() + rect[3].get<double>() / 2);
  }

  [[nodiscard]] bool running() {
    if (child_ <= 0) return false;
    if (::waitpid(child_, &status_, WNOHANG) == child_) child_ = -1;
    return child_ > 0;
  }
  /// The exit status, once the program has ended by itself.
  int wait_end() {
    for (int look = 0; look < 3000 && running(); ++look)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (child_ > 0) throw std::runtime_error("the program does not end");
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  }
  void kill() {
    ::kill(child_, SIGKILL);
    ::waitpid(child_, &status_, 0);
    child_ = -1;
  }
  [[nodiscard]] pid_t process() const { return child_; }
  [[nodiscard]] std::string output() const {
    return std::filesystem::exists(output_) ? read_file(output_) : std::string();
  }
  [[nodiscard]] const std::filesystem::path& trace() const { return trace_; }

 private:
  void xdotool(const std::string& arguments) const {
    const std::string command = "DISPLAY=" + display_ + " xdotool " + arguments + " >/dev/null 2>&1";
    if (std::system(command.c_str()) != 0) throw std::runtime_error("xdotool " + arguments + " failed");
  }

  std::string display_;
  std::filesystem::path trace_, output_;
  pid_t child_ = -1;
  int status_ = 0;
};

/// What the display check would have measured: the file that a session on this screen keeps.
inline void keep_display_profile(const std::filesystem::path& config_home, int width_px, int height_px) {
  std::filesystem::create_directories(config_home / "seamline");
  const Line profile = {{"mm_per_px", 0.25}, {"viewing_distance_mm", 600}, {"gamma_confirmed", true}};
  write_file_atomically(
      config_home / "seamline" / "display.json",
      Line({{"format", "seamline display"},
            {"version", 1},
            {"screens", {{fmt::format("screen {}x{} {}", width_px, height_px, width_px), profile}}}})
          .dump());
}

}  // namespace seamline::test
