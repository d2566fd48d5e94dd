// A screen without a monitor: Xvfb, and what is on it.
#pragma once
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "support/files/atomic_file.h"
#include "support/files/image.h"

namespace seamline::test {

inline bool has_program(const std::string& name) {
  return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

/// Why the window cannot be driven here; empty: it can.
inline std::string what_is_missing() {
  for (const char* program : {"Xvfb", "xdotool"})
    if (!has_program(program)) return std::string(program) + " is not installed";
  return "";
}

class XServer {
 public:
  XServer(const std::filesystem::path& folder, int width_px, int height_px) : folder_(folder) {
    std::filesystem::create_directories(folder);
    const std::string screen = std::to_string(width_px) + "x" + std::to_string(height_px) + "x24";
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
    child_ = ::fork();
    if (child_ == 0) {
      ::dup2(ends[1], 9);
      const int nothing = ::open("/dev/null", O_RDWR);
      for (const int stream : {0, 1, 2}) ::dup2(nothing, stream);
      ::execlp("Xvfb", "Xvfb", "-displayfd", "9", "-screen", "0", screen.c_str(), "-fbdir", folder_.c_str(),
               "-nolisten", "tcp", static_cast<char*>(nullptr));
      ::_exit(127);
    }
    ::close(ends[1]);
    std::string number;
    for (char letter = 0; ::read(ends[0], &letter, 1) == 1 && letter != '\n';) number += letter;
    ::close(ends[0]);
    if (number.empty()) throw std::runtime_error("Xvfb did not start");
    display_ = ":" + number;
  }
  ~XServer() {
    ::kill(child_, SIGTERM);
    int status = 0;
    ::waitpid(child_, &status, 0);
  }
  XServer(const XServer&) = delete;
  XServer& operator=(const XServer&) = delete;

  [[nodiscard]] const std::string& display() const { return display_; }

  /// What the screen shows now: the server's own framebuffer, an XWD file.
  [[nodiscard]] ByteImage picture() const {
    const std::string bytes = read_file(folder_ / "Xvfb_screen0");
    const auto field = [&](std::size_t index) {
      std::uint32_t value = 0;
      for (std::size_t i = 0; i < 4; ++i)
        value = value << 8U | static_cast<unsigned char>(bytes.at(index * 4 + i));
      return static_cast<std::size_t>(value);
    };
    const std::size_t start = field(0) + field(19) * 12, row = field(12);
    ByteImage picture{static_cast<int>(field(4)), static_cast<int>(field(5)), 3, {}};
    for (std::size_t y = 0; y < field(5); ++y)
      for (std::size_t x = 0; x < field(4); ++x)
        for (const std::size_t channel : {2, 1, 0})  // stored blue first
          picture.values.push_back(static_cast<std::uint8_t>(bytes.at(start + y * row + x * 4 + channel)));
    return picture;
  }

 private:
  std::filesystem::path folder_;
  pid_t child_ = -1;
  std::string display_;
};

}  // namespace seamline::test
