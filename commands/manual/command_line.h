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

// What is written of it.

/// The manual page `seamline.1`: what the program is for, its commands, files and exit statuses. In the
/// language of groff's macros `man`. `version` e.g. "0.1.0"; the page bears no date.
[[nodiscard]] std::string program_page(const CommandLine& line, const std::string& version);

/// The manual page of one command, e.g. `seamline-render.1`.
[[nodiscard]] std::string command_page(const Command& command, const std::string& version);

/// The page of all commands (documentation/reference/commands.md): a section a command, a row an argument.
[[nodiscard]] std::string reference_page(const CommandLine& line);

/// A script for bash that completes commands, the options of each, the words that an option takes, and paths
/// wherever any text may stand. It needs no other script.
[[nodiscard]] std::string bash_completion(const CommandLine& line);

}  // namespace seamline::packaging
