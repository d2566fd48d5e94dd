// The program without its start: every run is the child of a process that was forked before the first test,
// when it had one thread, and that has loaded the libraries of pictures since the first run which asked for
// them. Signals, Cluster, Demo and Tutorial start the built program itself.
#include <dlfcn.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <iostream>
#include <vector>

#include "commands/program.h"
#include "run_program.h"
#include "support/files/assets.h"
#include "support/files/picture_library.h"

namespace seamline::test {
namespace {

void write_all(int file, const void* bytes, std::size_t count) {
  for (const char* at = static_cast<const char*>(bytes); count > 0;) {
    const ssize_t written = ::write(file, at, count);
    if (written <= 0) throw std::runtime_error("the program's process has ended");
    at += written;
    count -= static_cast<std::size_t>(written);
  }
}

bool read_all(int file, void* bytes, std::size_t count) {
  for (char* at = static_cast<char*>(bytes); count > 0;) {
    const ssize_t got = ::read(file, at, count);
    if (got <= 0) return false;
    at += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

/// Words as the shell makes them, each ended by a zero.
std::string words_of(const std::string& arguments) {
  return arguments.empty() ? std::string() : run_program("printf '%s\\0'", arguments).output;
}

class ProgramProcess : public testing::Environment {
 public:
  void SetUp() override {
    output_ = ::memfd_create("output", MFD_CLOEXEC);
    loaded_ = static_cast<bool*>(
        ::mmap(nullptr, sizeof(bool), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    int requests[2], answers[2];
    if (output_ < 0 || loaded_ == MAP_FAILED || ::pipe2(requests, O_CLOEXEC) != 0 ||
        ::pipe2(answers, O_CLOEXEC) != 0)
      throw std::runtime_error("no pipe");
    std::fflush(nullptr);
    process_ = ::fork();
    if (process_ == 0) {
      ::close(requests[1]);  // its end is the end of the tests
      serve(requests[0], answers[1]);
    }
    ::close(requests[0]);
    ::close(answers[1]);
    to_ = requests[1];
    from_ = answers[0];
  }
  void TearDown() override {
    ::close(to_);
    ::waitpid(process_, nullptr, 0);
  }

  [[nodiscard]] Outcome run(const std::string& arguments, Outputs outputs) const {
    const std::string words = words_of(arguments);
    const std::size_t size = words.size();
    if (::ftruncate(output_, 0) != 0 || ::lseek(output_, 0, SEEK_SET) != 0)
      throw std::runtime_error("no output");
    write_all(to_, &size, sizeof size);
    write_all(to_, words.data(), size);
    write_all(to_, &outputs, sizeof outputs);
    Outcome outcome;
    if (!read_all(from_, &outcome.status, sizeof outcome.status))
      throw std::runtime_error("the program's process has ended");
    outcome.output.resize(static_cast<std::size_t>(::lseek(output_, 0, SEEK_END)));
    ::lseek(output_, 0, SEEK_SET);
    if (!read_all(output_, outcome.output.data(), outcome.output.size()))
      throw std::runtime_error("no output");
    return outcome;
  }

 private:
  [[noreturn]] void serve(int requests, int answers) const {
    for (std::size_t size = 0; read_all(requests, &size, sizeof size);) {
      std::string words(size, '\0');
      Outputs outputs = Outputs::kept;
      if (!read_all(requests, words.data(), size) || !read_all(requests, &outputs, sizeof outputs)) break;
      const pid_t child = ::fork();
      if (child == 0) become_the_program(words, outputs);
      int status = 0;
      ::waitpid(child, &status, 0);
      const int ended = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      if (*loaded_) (void)picture_codec();
      write_all(answers, &ended, sizeof ended);
    }
    ::_exit(0);
  }

  [[noreturn]] void become_the_program(std::string words, Outputs outputs) const {
    ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
    ::dup2(outputs == Outputs::full ? ::open("/dev/full", O_WRONLY) : output_, STDOUT_FILENO);
    ::dup2(output_, STDERR_FILENO);
    if (outputs == Outputs::closed || outputs == Outputs::both_closed) ::close(STDOUT_FILENO);
    if (outputs == Outputs::both_closed) ::close(STDERR_FILENO);
    std::string name = "seamline";
    std::vector<char*> arguments = {name.data()};
    for (std::size_t at = 0; at < words.size(); at = words.find('\0', at) + 1)
      arguments.push_back(words.data() + at);
    arguments.push_back(nullptr);
    const int status = run_command_line(static_cast<int>(arguments.size()) - 1, arguments.data());
    if (::dlopen(picture_codec_file().c_str(), RTLD_LAZY | RTLD_NOLOAD) != nullptr) *loaded_ = true;
    std::cout.flush();
    std::fflush(nullptr);
    // Not exit: the libraries would wait for threads that the fork has left behind.
    ::_exit(status);
  }

  int output_ = -1, to_ = -1, from_ = -1;
  pid_t process_ = -1;
  bool* loaded_ = nullptr;  ///< whether a run has loaded the libraries of pictures; shared by all processes
};

// Google Test deletes it.
ProgramProcess* const program_process = new ProgramProcess;
[[maybe_unused]] const testing::Environment* const registered =
    testing::AddGlobalTestEnvironment(program_process);

}  // namespace

Outcome run_seamline(const std::string& arguments, Outputs outputs) {
  return program_process->run(arguments, outputs);
}

}  // namespace seamline::test
