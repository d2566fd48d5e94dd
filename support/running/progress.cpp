#include "support/running/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "support/text/printable.h"

namespace seamline {

std::string duration_text(double seconds) {
  const long whole = static_cast<long>(seconds + 0.5);
  if (whole >= 3600) return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
  if (whole >= 60) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} s", whole);
}

Progress::Progress(std::string title, double work_total)
    : title_(printable(title, 80)),
      work_total_(std::max(work_total, 1e-9)),
      on_terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (on_terminal_) std::fputs("\r\033[K", stderr);
}

void Progress::advance(double work, const std::string& now_doing) {
  work_done_ += work;
  const auto now = Clock::now();
  const auto interval = on_terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10000);
  if (now - last_print_ < interval && work_done_ < work_total_) return;
  last_print_ = now;
  print(now_doing);
}

void Progress::print(const std::string& now_doing) {
  const double share = std::clamp(work_done_ / work_total_, 0.0, 1.0);
  const double elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count();
  const std::string left = share > 0.002 ? duration_text(elapsed_s * (1 - share) / share) + " left" : "";
  fmt::print(stderr, "{}{}: {:3.0f} %, {} {}{}", on_terminal_ ? "\r\033[K" : "", title_, 100 * share, left,
             now_doing, on_terminal_ ? "" : "\n");
  std::fflush(stderr);
}

}  // namespace seamline
