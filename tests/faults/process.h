#pragma once
#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace seamline::faults {

/// What surrounds a run of the program.
struct Surroundings {
  std::optional<std::uint64_t> file_limit_bytes = {};  ///< RLIMIT_FSIZE: writes beyond it fail
  std::optional<std::int64_t> kill_after_us = {};      ///< SIGKILL at this instant
  std::function<void()> before_kill = {};              ///< what a second reader looks at just before
  std::vector<std::string> environment = {};           ///< NAME=value, beside what is there
};

/// How a run ended.
struct Ending {
  int status = 0;       ///< exit status; 128 + number after a signal
  bool killed = false;  ///< by us
  std::int64_t duration_us = 0;
  std::int64_t peak_kb = 0;  ///< largest memory
  std::string output;        ///< standard output and standard error
};

using Arguments = std::vector<std::string>;

/// A program that is running.
struct Child {
  pid_t pid = 0;
  int output = -1;
};
[[nodiscard]] Child start(const Arguments& command, const Surroundings& around = {});
[[nodiscard]] Ending finish(const Child& child, const Surroundings& around = {});

/// Runs a program to its end, or to ours.
[[nodiscard]] Ending run(const Arguments& command, const Surroundings& around = {});

}  // namespace seamline::faults
