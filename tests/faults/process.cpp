#include "process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace seamline::faults {
namespace {

using Clock = std::chrono::steady_clock;

std::int64_t us_since(Clock::time_point start) {
  return std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - start).count();
}

[[noreturn]] void become(const Arguments& command, const Surroundings& around, int output) {
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  if (around.file_limit_bytes) {
    const rlimit limit{.rlim_cur = *around.file_limit_bytes, .rlim_max = *around.file_limit_bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  for (const std::string& variable : around.environment) {
    const std::size_t sign = variable.find('=');
    ::setenv(variable.substr(0, sign).c_str(), variable.substr(sign + 1).c_str(), 1);
  }
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  ::execv(words.front(), words.data());
  ::_exit(127);
}

}  // namespace

Child start(const Arguments& command, const Surroundings& around) {
  int ends[2] = {};
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  const pid_t pid = ::fork();
  if (pid < 0) throw std::runtime_error("no process");
  if (pid == 0) {
    ::setpgid(0, 0);  // what the program itself starts ends with it
    become(command, around, ends[1]);
  }
  ::setpgid(pid, pid);
  ::close(ends[1]);
  return {pid, ends[0]};
}

Ending finish(const Child& child, const Surroundings& around) {
  const Clock::time_point begin = Clock::now();
  Ending ending;
  char block[4096];
  for (;;) {
    int wait_ms = -1;
    if (around.kill_after_us && !ending.killed)
      wait_ms = static_cast<int>(std::max<std::int64_t>(0, *around.kill_after_us - us_since(begin)) / 1000);
    pollfd ready{.fd = child.output, .events = POLLIN, .revents = 0};
    if (::poll(&ready, 1, wait_ms) > 0) {
      const ssize_t count = ::read(child.output, block, sizeof block);
      if (count <= 0) break;
      ending.output.append(block, static_cast<std::size_t>(count));
      if (!around.kill_after_us || ending.killed || us_since(begin) < *around.kill_after_us) continue;
    }
    if (!around.kill_after_us || ending.killed) continue;
    const std::int64_t left_us = *around.kill_after_us - us_since(begin);
    if (left_us > 0) ::usleep(static_cast<useconds_t>(left_us));
    if (around.before_kill) around.before_kill();
    ::kill(-child.pid, SIGKILL);
    ending.killed = true;
  }
  ::close(child.output);
  int status = 0;
  rusage used = {};
  ::wait4(child.pid, &status, 0, &used);
  ending.peak_kb = used.ru_maxrss;
  ending.duration_us = us_since(begin);
  ending.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  ending.killed = ending.killed && WIFSIGNALED(status);
  return ending;
}

Ending run(const Arguments& command, const Surroundings& around) {
  return finish(start(command, around), around);
}

}  // namespace seamline::faults
