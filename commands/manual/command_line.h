#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace seamline::packaging {

/// What one argument of a command is, as --help says it.
struct Argument {
  std::vector<std::string> names =
      {};                  ///< as typed, "-h" and "--help"; one word without dashes for a positional
  std::string value = {};  ///< stands for its value, e.g. "INTEGER"; empty: it takes none
  std::string range = {};  ///< of a number, e.g. "1 to 4096"; may be empty
  std::vector<std::string> choices = {};  ///< the only words it takes; empty: any
  std::string usual = {};                 ///< its value when it is not given; may be empty
  std::string description;
  std::vector<std::string> needs = {}, excludes = {};  ///< names of others
  bool positional = false, required = false, repeats = false;
};

struct Command {
  std::string name;  ///< as typed, "render", "lab bench"; "seamline" for the program itself
  std::string description;
  std::vector<Argument> arguments = {};  ///< without hidden ones
};

/// A program as its users type it.
struct CommandLine {
  Command program;
  std::vector<Command> commands = {};
};

/// What CLI11 knows of a program and its commands: the source of manual pages and completion, which
/// therefore cannot miss an option.
[[nodiscard]] CommandLine command_line(const CLI::App& app);

/// The name of a command's manual page: "seamline-lab-bench".
[[nodiscard]] std::string page_name(const Command& command);

}  // namespace seamline::packaging
