#pragma once
#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <vector>

#include "run_program.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

/// The program while it runs.
namespace seamline::test {

/// A program that is running, its output in a file.
struct Running {
  pid_t process = -1;
  std::filesystem::path output;
};

/// `stand_still_at_ask`: the program stops itself when it asks for the n-th time whether to stop
/// (support/running/interrupt.h); 0: never. `standard_output`: where that goes, if not into the output.
inline Running start(const std::vector<std::string>& arguments, const std::filesystem::path& output,
                     int stand_still_at_ask = 0, const char* standard_output = nullptr) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                   0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  if (standard_output != nullptr)
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, standard_output, O_WRONLY, 0);
  std::vector<std::string> words = {SEAMLINE_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  std::string standstill = "SEAMLINE_STAND_STILL_AT_ASK=" + std::to_string(stand_still_at_ask);
  std::vector<char*> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) variables.push_back(*variable);
  variables.push_back(standstill.data());
  variables.push_back(nullptr);
  Running running{.process = -1, .output = output};
  if (posix_spawn(&running.process, SEAMLINE_PROGRAM, &actions, nullptr, pointers.data(), variables.data()) !=
      0)
    throw std::runtime_error("the program cannot be started");
  posix_spawn_file_actions_destroy(&actions);
  return running;
}

/// Waits until the program stands still at the ask that it was started with; false when it ended before.
inline bool stands_still(const Running& running) {
  int status = 0;
  ::waitpid(running.process, &status, WUNTRACED);
  return WIFSTOPPED(status);
}

/// Sends the signal, lets a program that stands still go on, and waits for the end: its exit status.
inline int status_after(const Running& running, int signal) {
  ::kill(running.process, signal);
  ::kill(running.process, SIGCONT);
  int status = 0;
  ::waitpid(running.process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace seamline::test
