#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace seamline {

// The only place that runs other programs (tests/program/manners_test.cpp keeps it).

struct ChildProcess {
  std::vector<std::string> command;           ///< its first word: a path, or a name on the PATH; no shell
  std::vector<std::string> environment = {};  ///< NAME=value, beside those of this program
  std::filesystem::path folder = {};          ///< where it runs; empty: where this program does
  bool keeps_errors = false;  ///< standard error is output too; else it goes where this program's goes
};

struct ChildResult {
  int status = 0;      ///< its exit status; 128 and the signal's number where a signal ended it
  std::string output;  ///< at most as much as a text file may hold
};

/// Runs a program to its end, without input. None where there is no such program. When the person stops this
/// program the child is asked to stop (SIGTERM), and its end is waited for. Throws std::system_error when it
/// cannot be started.
[[nodiscard]] std::optional<ChildResult> run_child(const ChildProcess& child);

}  // namespace seamline
