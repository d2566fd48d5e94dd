// A server in a process of its own, so that it can be killed.
#pragma once
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "study/online/serving/serve.h"
#include "support/running/interrupt.h"
#include "tests/online/online_people.h"

namespace seamline::study::online {

/// A folder such as `seamline export web` writes, with what a server needs of it.
inline std::filesystem::path write_site(const RenderedSet& set, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "pictures");
  nlohmann::ordered_json study;
  study["format"] = message_format;
  study["study_hash"] = set.manifest.study_hash;
  study["set_hash"] = set.set_hash;
  study["study_name"] = set.study.name;
  study["slots"] = 200;
  study["pilot"] = false;
  study["adaptive"] = set.study.procedure.index() != 0;
  auto stimuli = nlohmann::ordered_json::array(), catches = nlohmann::ordered_json::array();
  const ShownNames names(set);
  for (int i = 0; i < static_cast<int>(set.manifest.stimuli.size()); ++i) {
    const std::string name = names.name_of({.stimulus = i});
    stimuli.push_back({{"id", name}, {"file", "pictures/" + name + ".png"}});
    for (const TrialKind kind : {TrialKind::attention, TrialKind::reference})
      catches.push_back({{"kind", word(kind)},
                         {"stimulus_id", names.name_of({.kind = kind, .stimulus = i})},
                         {"picture", "pictures/catch.png"}});
  }
  study["stimuli"] = stimuli;
  study["catches"] = catches;
  std::vector<std::pair<std::string, std::string>> files = {
      {"index.html", "<!doctype html><title>study</title>"},
      {"pictures/large.png", std::string(3 << 20, 'p')},
      {"seamline.js", "// nothing"},
      {"study.json", study.dump()}};
  auto listed = nlohmann::ordered_json::array();
  for (const auto& [name, text] : files) {
    write_file_atomically(folder / name, text);
    listed.push_back({{"name", name}, {"bytes", text.size()}, {"sha256", sha256(text)}});
  }
  nlohmann::ordered_json list;
  list["format"] = message_format;
  list["files"] = listed;
  write_file_atomically(folder / "files.json", list.dump());
  return folder;
}

/// What the server's process does after a signal is the program's own business.
class ServerProcess {
 public:
  explicit ServerProcess(const ServeRequest& request) {
    int ends[2] = {};
    if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
    std::fflush(nullptr);
    process_ = ::fork();
    if (process_ == 0) {
      ::close(ends[0]);
      catch_interrupts();
      try {
        serve(request, [&](const std::string& line) {
          const std::string text = line + "\n";
          (void)!::write(ends[1], text.data(), text.size());
        });
        ::_exit(0);
      } catch (const std::exception& error) {
        const std::string text = std::string("failed: ") + error.what() + "\n";
        (void)!::write(ends[1], text.data(), text.size());
        ::_exit(1);
      }
    }
    ::close(ends[1]);
    lines_ = ends[0];
    first_line_ = read_line();
    const std::size_t at = first_line_.find("http://127.0.0.1:");
    if (at != std::string::npos) port_ = std::atoi(first_line_.c_str() + at + 17);
  }
  ~ServerProcess() {
    if (process_ > 0) (void)end(SIGKILL);
    ::close(lines_);
  }
  ServerProcess(const ServerProcess&) = delete;
  ServerProcess& operator=(const ServerProcess&) = delete;

  [[nodiscard]] int port() const { return port_; }
  [[nodiscard]] pid_t process() const { return process_; }
  [[nodiscard]] const std::string& first_line() const { return first_line_; }
  /// Sends a signal and waits; the status as waitpid has it.
  int end(int signal) {
    ::kill(process_, signal);
    int status = 0;
    ::waitpid(process_, &status, 0);
    process_ = -1;
    return status;
  }
  /// What the server said until it ended.
  std::string rest() {
    std::string text;
    char block[4096];
    for (ssize_t count = 0; (count = ::read(lines_, block, sizeof block)) > 0;)
      text.append(block, static_cast<std::size_t>(count));
    return text;
  }

 private:
  std::string read_line() {
    std::string line;
    for (char letter = 0; ::read(lines_, &letter, 1) == 1 && letter != '\n';) line += letter;
    return line;
  }

  pid_t process_ = -1;
  int lines_ = -1, port_ = 0;
  std::string first_line_;
};

}  // namespace seamline::study::online
