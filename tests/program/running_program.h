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

inline Running start(const std::vector<std::string>& arguments, const std::filesystem::path& output) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                   0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  std::vector<std::string> words = {SEAMLINE_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  Running running{.process = -1, .output = output};
  if (posix_spawn(&running.process, SEAMLINE_PROGRAM, &actions, nullptr, pointers.data(), environ) != 0)
    throw std::runtime_error("the program cannot be started");
  posix_spawn_file_actions_destroy(&actions);
  return running;
}

/// Whether the process catches the signal by now, so that it no longer ends it by itself.
inline bool catches(pid_t process, int signal) {
  const std::string status = read_text("/proc/" + std::to_string(process) + "/status");
  const std::size_t at = status.find("SigCgt:");
  if (at == std::string::npos) return true;  // it has ended
  return (std::stoull(status.substr(at + 7), nullptr, 16) >> (signal - 1) & 1U) != 0;
}

/// Sends the signal and waits for the end: its exit status.
inline int status_after(const Running& running, int signal) {
  ::kill(running.process, signal);
  int status = 0;
  ::waitpid(running.process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace seamline::test
