#include "commands/study/study_commands.h"

#include <fmt/core.h>
#include <poll.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "study/online/asking/ask.h"
#include "study/online/messages/message.h"
#include "support/running/interrupt.h"

namespace seamline::study::online {
namespace {

/// Lines of the standard input; Ctrl-C ends the waiting for one (Interrupted).
class StandardInput {
 public:
  [[nodiscard]] bool next_line(std::string& line) {
    for (;;) {
      if (const std::size_t end = read_.find('\n'); end != std::string::npos) {
        line = read_.substr(0, end);
        read_.erase(0, end + 1);
        return true;
      }
      if (read_.size() > 2 * most_line_bytes) read_.resize(most_line_bytes + 1);  // refused when it ends
      if (!more()) break;
    }
    line = std::exchange(read_, {});
    return !line.empty();
  }

 private:
  [[nodiscard]] bool more() {
    constexpr int between_looks_ms = 50;
    for (;;) {
      stop_if_interrupted();
      pollfd waiting{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
      if (::poll(&waiting, 1, between_looks_ms) <= 0) continue;
      std::array<char, 4096> block = {};
      const ssize_t count = ::read(STDIN_FILENO, block.data(), block.size());
      if (count <= 0) return false;
      read_.append(block.data(), static_cast<std::size_t>(count));
      return true;
    }
  }

  std::string read_;
};

}  // namespace

void add_ask_command(CLI::App& app) {
  const auto request = std::make_shared<AskRequest>();
  CLI::App* command = app.add_subcommand("ask", "a session that another program shows, by lines of JSON");
  command
      ->add_option("source", request->source,
                   "folder of the rendered set, or a study file whose pictures the other program makes")
      ->required();
  command->add_option("--log", request->log, "SQLite log of answers; made when it is missing")->required();
  command->add_option("--participant", request->participant, "a person's code, never a name")->required();
  command->add_flag("--pilot", request->pilot, "mark the participant as a trial run");
  command->callback([request] {
    StandardInput input;
    ask(
        *request, [&](std::string& line) { return input.next_line(line); },
        [](const std::string& line) {
          fmt::print("{}\n", line);
          std::fflush(stdout);  // the other program waits for it
        });
  });
}

}  // namespace seamline::study::online
