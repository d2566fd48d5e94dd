#include "support/running/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include "support/running/interrupt.h"
#include "support/text/limits.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace seamline {
namespace {

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Where two texts give a variable a value, the first counts.
std::vector<std::string> with_environment(const std::vector<std::string>& added) {
  std::vector<std::string> all = added;
  for (char** one = environ; *one != nullptr; ++one) all.emplace_back(*one);
  return all;
}

/// Starts the child with its output in `writing`. 0 where there is no such program.
pid_t start_child(const ChildProcess& child, int writing) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, writing, STDOUT_FILENO);
  if (child.keeps_errors) posix_spawn_file_actions_adddup2(&actions, writing, STDERR_FILENO);
  if (!child.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, child.folder.c_str());
  std::vector<std::string> command = child.command, environment = with_environment(child.environment);
  const std::vector<char*> arguments = pointers_to(command), variables = pointers_to(environment);
  pid_t id = 0;
  const int failure =
      posix_spawnp(&id, command.front().c_str(), &actions, nullptr, arguments.data(), variables.data());
  posix_spawn_file_actions_destroy(&actions);
  if (failure == ENOENT) return 0;
  if (failure != 0)
    throw std::system_error(failure, std::generic_category(), "starting " + child.command.front());
  return id;
}

/// All that is written until the last writer has closed. A signal wakes the waiting.
std::string output_of(int reading, pid_t child) {
  std::string output;
  std::array<char, 65536> block{};
  for (;;) {
    pollfd ready = {.fd = reading, .events = POLLIN, .revents = 0};
    if (poll(&ready, 1, -1) < 0) {
      if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waiting for output");
      if (interrupted()) kill(child, SIGTERM);
      continue;
    }
    const ssize_t count = read(reading, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return output;
    const auto bytes = static_cast<std::size_t>(count);
    if (output.size() + bytes <= static_cast<std::size_t>(limits::largest_text_file_bytes))
      output.append(block.data(), bytes);
  }
}

}  // namespace

std::optional<ChildResult> run_child(const ChildProcess& child) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "making a pipe");
  pid_t id = 0;
  try {
    id = start_child(child, ends[1]);
  } catch (...) {
    for (const int end : ends) close(end);
    throw;
  }
  close(ends[1]);
  ChildResult result;
  if (id != 0) result.output = output_of(ends[0], id);
  close(ends[0]);
  if (id == 0) return std::nullopt;
  int status = 0;
  while (waitpid(id, &status, 0) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waiting for a program");
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

}  // namespace seamline
