// A command of the program in a window on an X server of its own, and a person's keys and mouse.
#pragma once
#include <fmt/core.h>

#include <chrono>
#include <regex>
#include <thread>

#include "x_server.h"

namespace seamline::test {

class ProgramWindow {
 public:
  /// `command`: what follows the program's name.
  ProgramWindow(const std::filesystem::path& folder, const std::string& command)
      : output_(folder / "output"), server_(folder / "x", 1280, 800) {
    std::filesystem::remove(output_);
    const std::string line = fmt::format(
        "exec env -u WAYLAND_DISPLAY DISPLAY={} LIBGL_ALWAYS_SOFTWARE=1 ASAN_OPTIONS=detect_leaks=0 '{}' {} "
        ">'{}' 2>&1 </dev/null",
        server_.display(), SEAMLINE_PROGRAM, command, output_.string());
    child_ = ::fork();
    if (child_ == 0) {
      ::execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
      ::_exit(127);
    }
  }
  ~ProgramWindow() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
  }
  ProgramWindow(const ProgramWindow&) = delete;
  ProgramWindow& operator=(const ProgramWindow&) = delete;

  [[nodiscard]] std::string said() const {
    return std::filesystem::exists(output_) ? read_file(output_) : "";
  }
  [[nodiscard]] ByteImage picture() const { return server_.picture(); }

  /// Waits until the program has said something so often.
  void wait_for(const std::string& words, std::ptrdiff_t times) const {
    for (int look = 0; look < 6000; ++look) {
      const std::string text = said();
      const std::regex wanted(words);
      if (std::distance(std::sregex_iterator(text.begin(), text.end(), wanted), std::sregex_iterator()) >=
          times)
        return;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    throw std::runtime_error("waited for \"" + words + "\": " + said());
  }

  /// Waits until the screen has shown so many other pictures.
  void wait_for_changes(int times) const {
    std::vector<std::uint8_t> last = picture().values;
    for (int look = 0; look < 6000 && times > 0; ++look) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      std::vector<std::uint8_t> now = picture().values;
      if (now == last) continue;
      last = std::move(now);
      --times;
    }
    if (times > 0) throw std::runtime_error("the screen stands still: " + said());
  }

  void xdotool(const std::string& arguments) const {
    const std::string command = "DISPLAY=" + server_.display() + " xdotool " + arguments + " >/dev/null 2>&1";
    if (std::system(command.c_str()) != 0) throw std::runtime_error("xdotool " + arguments);
  }

  /// Presses a key and says with which status the program ends.
  int end(const std::string& key) {
    xdotool("key " + key);
    int status = 0;
    ::waitpid(child_, &status, 0);
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  std::filesystem::path output_;
  XServer server_;
  pid_t child_ = -1;
};

}  // namespace seamline::test
