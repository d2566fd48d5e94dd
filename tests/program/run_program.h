#pragma once
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

/// Runs the program as a person would.
namespace seamline::test {

struct Outcome {
  int status = -1;
  std::string output;  ///< standard output and standard error together
};

inline Outcome run_program(const std::string& program, const std::string& arguments) {
  const std::string command = program + " " + arguments + " 2>&1 </dev/null";
  Outcome outcome;
  FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return outcome;
  std::array<char, 4096> block{};
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), pipe))
    outcome.output.append(block.data(), count);
  const int status = ::pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return outcome;
}

inline Outcome run_seamline(const std::string& arguments) {
  return run_program(SEAMLINE_PROGRAM, arguments);
}

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

inline std::string read_text(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// A fresh folder for one test's files.
inline std::filesystem::path fresh_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(SEAMLINE_TEST_OUTPUT) / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

/// The study files that come with Seamline.
inline std::filesystem::path studies() {
  return std::filesystem::path(SEAMLINE_SOURCE_DIR) / "stimuli";
}

/// The quick study with some of its text replaced; throws when the text is not there.
inline std::string quick_study_with(std::initializer_list<std::pair<std::string, std::string>> replacements) {
  std::string text = read_text(studies() / "quick.toml");
  for (const auto& [from, to] : replacements) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::runtime_error("the quick study has no " + from);
    text.replace(at, from.size(), to);
  }
  return text;
}

}  // namespace seamline::test
