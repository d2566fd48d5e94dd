#include "study/app/pictures/frame_times.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>

#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::study::app {

FrameTimes::FrameTimes(const std::filesystem::path& file) {
  if (file.empty()) return;
  file_.reset(std::fopen(file.c_str(), "we"));
  if (!file_)
    throw input_error({.file = file.string(),
                       .field = request_name("frame_times"),
                       .wanted = "a file that can be written to",
                       .found = std::strerror(errno)});
  std::fputs("swap,screen,begun_ns,frame_ns,late,turn_to_shown_ns\n", file_.get());
}

void FrameTimes::add(const FrameTime& frame) {
  if (!file_) return;
  // Not fmt::print, which throws on a full disk: a session goes on without its times.
  const std::string line = fmt::format(
      "{},{},{},{},{},{}\n", frame.swap, frame.screen, frame.begun_ns, frame.shown_ns - frame.begun_ns,
      frame.late ? 1 : 0, frame.turn_ns ? fmt::format("{}", frame.shown_ns - *frame.turn_ns) : "");
  std::fputs(line.c_str(), file_.get());
}

}  // namespace seamline::study::app
