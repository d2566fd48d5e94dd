#include "stimuli/support/gnuplot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "stimuli/support/atomic_file.h"
#include "stimuli/support/error.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace seamline {

namespace fs = std::filesystem;

namespace {

InputError no_gnuplot() {
  return input_error({.file = "gnuplot",
                      .field = "",
                      .wanted = "the program gnuplot, which draws the figures (Debian package gnuplot-nox)",
                      .found = "none on the PATH"});
}

/// Exit status of `gnuplot ARGUMENT` with its errors in `messages`.
int run_gnuplot(const std::string& argument, const fs::path& messages) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                   0644);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  std::string program = "gnuplot", script = argument;
  std::array<char*, 3> arguments = {program.data(), script.data(), nullptr};
  pid_t child = 0;
  const int failure = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure == ENOENT) throw no_gnuplot();
  if (failure != 0) throw std::system_error(failure, std::generic_category(), "starting gnuplot");
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waiting for gnuplot");
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/// A text as gnuplot reads it between single quotes.
std::string quoted(const std::string& text) {
  std::string safe = "'";
  for (const char letter : text) safe += letter == '\'' ? "''" : std::string(1, letter);
  return safe + "'";
}

/// Files that are gone at the end, however it comes.
struct Removed {
  std::vector<fs::path> files;
  ~Removed() {
    std::error_code error;
    for (const fs::path& file : files) fs::remove(file, error);
  }
};

bool is_whole_svg(const fs::path& file) {
  const std::string text = fs::exists(file) ? read_file(file) : std::string();
  const std::size_t end = text.find_last_not_of(" \n");
  return end != std::string::npos && text.substr(0, end + 1).ends_with("</svg>");
}

}  // namespace

PlotStyle plot_style(std::size_t index) {
  constexpr std::array<PlotStyle, 7> styles = {{{"#0072B2", 7},
                                                {"#D55E00", 5},
                                                {"#009E73", 9},
                                                {"#CC79A7", 13},
                                                {"#E69F00", 11},
                                                {"#56B4E9", 15},
                                                {"#7F7F7F", 7}}};
  return styles[index % styles.size()];
}

void require_gnuplot() {
  const char* path = std::getenv("PATH");
  std::string folders = path == nullptr ? "/usr/local/bin:/usr/bin:/bin" : path;
  for (std::size_t begin = 0; begin <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', begin), folders.size());
    if (access((fs::path(folders.substr(begin, end - begin)) / "gnuplot").c_str(), X_OK) == 0) return;
    begin = end + 1;
  }
  throw no_gnuplot();
}

void draw_svg(const fs::path& svg, int width_px, int height_px, const std::string& script) {
  const fs::path script_file = fs::path(svg).replace_extension(".gnuplot");
  // Of this process alone: two programs may draw into one folder.
  const auto passing = [&](const char* what) {
    return svg.parent_path() / fmt::format(".{}.{}.{}", svg.stem().string(), getpid(), what);
  };
  const fs::path messages = passing("messages"), caller = passing("call");
  // Run from the figure's folder, so that the script names no folder and can be moved with the report.
  write_file_atomically(
      script_file,
      fmt::format("set encoding utf8\nset terminal svg size {},{} dynamic enhanced font 'Helvetica,Arial,"
                  "DejaVu Sans,sans-serif,14' butt linewidth 1.2\nset output ARGC > 0 ? ARG1 : '{}'\n{}",
                  width_px, height_px, svg.filename().string(), script));
  const Removed at_the_end{{messages, caller}};
  write_file_atomically(svg, [&](const fs::path& temporary) {
    write_file_atomically(
        caller, fmt::format("call {} {}\n", quoted(script_file.string()), quoted(temporary.string())));
    const int status = run_gnuplot(caller.string(), messages);
    if (status != 0)
      throw std::runtime_error("gnuplot failed on " + script_file.string() + ": " + read_file(messages));
    if (!is_whole_svg(temporary))  // gnuplot does not notice a disk that is full
      throw input_error({.file = svg.string(), .wanted = "room for a figure", .found = "a full disk"});
  });
}

std::string gnuplot_text(const std::string& text) {
  std::string safe;
  for (char c : text) {
    if (c == '\\' || c == '"' || c == '`' || c == '\n') c = c == '"' ? '\'' : ' ';
    if (std::string_view("^_@&~{}").find(c) != std::string_view::npos) safe += "\\\\";
    safe += c;
  }
  return safe;
}

}  // namespace seamline
