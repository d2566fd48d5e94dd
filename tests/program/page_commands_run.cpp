#include "page_commands_run.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <functional>
#include <map>
#include <regex>
#include <set>

#include "browser_person.h"
#include "page_commands_inputs.h"
#include "page_commands_steps.h"
#include "study/trials/rendered_set.h"
#include "tests/app/x_server.h"

namespace seamline::page_commands {
namespace {

namespace fs = std::filesystem;
using test::read_text;
using test::write_text;

constexpr int status_interrupted = 130;  ///< of everything that a signal ends, but for `serve`

/// A command line taken apart.
struct Command {
  std::string line;
  std::vector<std::string> words;
  std::string name;  ///< "render", "log status"

  explicit Command(const std::string& text) : line(text), words(words_of_line(text)) {
    static const std::set<std::string> groups = {"lab", "log", "job", "export"};
    name = words.at(1);
    if (groups.contains(name)) name += " " + words.at(2);
  }
  [[nodiscard]] bool has(const std::string& word) const {
    return std::find(words.begin(), words.end(), word) != words.end();
  }
  /// The word behind an option; empty: none.
  [[nodiscard]] std::string behind(const std::string& option) const {
    const auto at = std::find(words.begin(), words.end(), option);
    return at == words.end() || at + 1 == words.end() ? "" : *(at + 1);
  }
  [[nodiscard]] bool opens_window() const {
    return (name == "study" && !has("--observer") && !has("--print-texts")) || name == "place" ||
           (name == "live" && !has("--headless"));
  }
  [[nodiscard]] bool serves() const {
    return name == "serve" && words.at(2).front() != '-' && !has("--systemd");
  }
};

/// The one screen of this process.
const test::XServer& screen() {
  static const test::XServer server(
      fs::path(SEAMLINE_TEST_OUTPUT) / "pages-screen" / std::to_string(::getpid()), 1280, 800);
  return server;
}

bool shows_something() {
  const std::vector<std::uint8_t> values = screen().picture().values;
  return std::any_of(values.begin(), values.end(),
                     [&](std::uint8_t value) { return value != values.front(); });
}

/// A command that runs until it is stopped.
class Begun {
 public:
  Begun(const fs::path& script, const fs::path& output) : output_(output) {
    write_text(output, "");
    child_ = ::fork();
    if (child_ != 0) return;
    ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
    ::dup2(::open(output.c_str(), O_WRONLY | O_APPEND), STDOUT_FILENO);
    ::dup2(STDOUT_FILENO, STDERR_FILENO);
    ::execlp("bash", "bash", script.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  ~Begun() {
    if (child_ > 0) (void)stopped_by(SIGKILL);
  }
  Begun(const Begun&) = delete;
  Begun& operator=(const Begun&) = delete;

  [[nodiscard]] std::string said() const { return read_text(output_); }

  /// Waits until it is so; false where the command ended before.
  bool waits_until(const std::function<bool()>& is_so) {
    constexpr int most_looks = 3000;
    for (int look = 0; look < most_looks; ++look) {
      if (is_so()) return true;
      if (::waitpid(child_, &status_, WNOHANG) == child_) {
        child_ = -1;
        return false;
      }
      ::usleep(20000);
    }
    return false;
  }
  int stopped_by(int signal) {
    if (child_ > 0) {
      ::kill(child_, signal);
      ::waitpid(child_, &status_, 0);
      child_ = -1;
    }
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  }

 private:
  fs::path output_;
  pid_t child_ = -1;
  int status_ = 0;
};

class Follower {
 public:
  explicit Follower(fs::path folder) : folder_(std::move(folder)) {}

  void follow(const std::string& page) {
    page_ = page;
    for (const PageStep& step : steps_of(test::pages().at(page))) switch (step.kind) {
        case PageStep::Kind::command:
          run_command(step.text);
          break;
        case PageStep::Kind::file:
          write_text(folder_ / step.file, step.text);
          break;
        case PageStep::Kind::lines_of_file:
          write_text(folder_ / step.file, read_text(folder_ / step.file) + "\n" + step.text);
          break;
        case PageStep::Kind::other_program:
          break;
      }
  }

 private:
  void run_command(const std::string& printed) {
    for (const NotRun& one : not_run())
      if (one.page == page_ && printed.starts_with(one.begins)) return;
    SCOPED_TRACE(page_ + ": " + printed);
    const Command command(std::regex_replace(smaller_line(printed), std::regex("INVITATION"), invitation_));
    prepare(command);
    const auto begun = std::chrono::steady_clock::now();
    if (command.serves())
      serve(command);
    else if (command.opens_window())
      open_window(command);
    else
      finish(command);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
    fmt::print("{:7.2f} s  {}\n", took.count(), command.line);
    std::fflush(stdout);
  }

  /// Brings what the command reads, and takes away what it would refuse to write again.
  void prepare(const Command& command) {
    static const std::set<std::string> outputs = {"--out", "--log", "--report", "--csv", "--angles"};
    static const std::set<std::string> refuses_again = {"export web", "export x3d"};
    if (refuses_again.contains(command.name)) fs::remove_all(folder_ / command.words.at(4));
    if (command.name == "freeze") fs::remove(folder_ / command.behind("--out"));
    for (std::size_t i = 2; i < command.words.size(); ++i) {
      const std::string& word = command.words[i];
      if (outputs.contains(command.words[i - 1])) continue;
      if (const auto served = unanswered_.find(word); served != unanswered_.end()) {
        const std::string set = served->second;
        finish(Command(
            fmt::format("seamline study {} --log {} --observer threshold --count 6 --seed 5", set, word)));
      }
      provide(folder_, page_, word);
    }
    make_smaller(command);
  }

  /// Of studies that are rendered; rules are looked at in whole pictures.
  void make_smaller(const Command& command) const {
    static const std::set<std::string> of_pictures = {"render", "job write", "lab convergence"};
    if (!of_pictures.contains(command.name)) return;
    for (const std::string& word : command.words)
      if (const fs::path file = folder_ / word; word.ends_with(".toml") && fs::is_regular_file(file))
        write_text(file, smaller_study(read_text(file), command.has("--only")));
  }

  [[nodiscard]] fs::path script_of(const std::string& line, const std::string& before = {}) const {
    write_text(folder_ / "command",
               fmt::format("cd '{}'\nexport HOME=$PWD PATH='{}':$PATH\n{}\n{}\n", folder_.string(),
                           fs::path(SEAMLINE_PROGRAM).parent_path().string(), before, line));
    return folder_ / "command";
  }

  void finish(const Command& command) {
    const test::Outcome outcome = test::run_program("bash", "'" + script_of(command.line).string() + "'");
    if (outcome.output.find("wanted a Seamline that was built with") != std::string::npos)
      GTEST_SKIP() << outcome.output;
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    if (command.name == "study") mark_answered(command);
    if (command.name == "export web") is_pilot_ = command.has("--pilot");
    if (command.has("--make-tokens")) invitation_ = outcome.output.substr(0, outcome.output.find('\n'));
  }

  void serve(const Command& command) {
    const bool has_port = command.has("--port");
    Begun server(
        script_of("exec " + test::with_replaced(command.line, {{" --log", (has_port ? "" : " --port 0") +
                                                                              std::string(" --log")}})),
        folder_ / "said");
    std::smatch port;
    std::string said;
    const bool is_ready = server.waits_until([&] {
      said = server.said();
      return std::regex_search(said, port, std::regex(R"(at http://[^:/]+:(\d+)/ into )"));
    });
    EXPECT_TRUE(is_ready) << server.said();
    const bool is_answered = is_ready && answer(command, std::stoi(port[1]));
    EXPECT_EQ(server.stopped_by(SIGINT), 0) << server.said();
    if (is_answered)
      mark_answered(command);
    else if (command.has("--set"))
      mark_unanswered(command, command.behind("--set"));
  }

  /// Somebody answers in a browser, where it can be one of this test's: not from another host, and not in a
  /// headset. False: nobody did.
  bool answer(const Command& command, int port) {
    if (command.has("--host") || !command.has("--set")) return false;
    const study::RenderedSet set = study::load_rendered_set(folder_ / command.behind("--set"));
    if (set.study.look) return false;
    test::answer_in_browser({.set = &set, .number = ++people_, .pilot = is_pilot_}, port,
                            command.has("--tokens") ? invitation_ : "");
    return true;
  }

  void open_window(const Command& command) {
    if (const std::string missing = test::what_is_missing(); !missing.empty()) {
      GTEST_SKIP() << missing;
      return;
    }
    Begun window(
        script_of("exec " + command.line, "unset WAYLAND_DISPLAY\nexport DISPLAY=" + screen().display() +
                                              " LIBGL_ALWAYS_SOFTWARE=1 ASAN_OPTIONS=detect_leaks=0"),
        folder_ / "said");
    const bool is_ready = window.waits_until(shows_something);
    EXPECT_TRUE(is_ready) << window.said();
    EXPECT_EQ(window.stopped_by(SIGINT), status_interrupted) << window.said();
    if (command.name == "study") mark_unanswered(command, command.words.at(2));
  }

  void mark_answered(const Command& command) {
    unanswered_.erase(command.behind("--log"));
    answered_.insert(command.behind("--log"));
  }
  void mark_unanswered(const Command& command, const std::string& set) {
    const std::string log = command.behind("--log");
    if (!answered_.contains(log)) unanswered_[log] = set;
  }

  fs::path folder_;
  std::string page_;
  std::string invitation_;    ///< the first that was made
  bool is_pilot_ = false;     ///< whether the last page for browsers was for trial runs
  std::uint64_t people_ = 0;  ///< who answered in a browser
  std::set<std::string> answered_;
  std::map<std::string, std::string> unanswered_;  ///< logs of people who did not come, and their sets
};

}  // namespace

void follow_pages(const std::vector<std::string>& pages) {
  std::string name = fs::path(pages.front()).replace_extension().generic_string();
  std::replace(name.begin(), name.end(), '/', '-');
  Follower follower(test::fresh_folder("pages-" + name));
  for (const std::string& page : pages) follower.follow(page);
}

}  // namespace seamline::page_commands
