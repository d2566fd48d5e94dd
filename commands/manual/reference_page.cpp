#include "commands/manual/command_line.h"

#include <cctype>
#include <vector>

namespace seamline::packaging {
namespace {

/// Text in a cell of a table.
std::string cell_text(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '|' || letter == '<' || letter == '*' || letter == '_') out += '\\';
    out += letter == '\n' ? ' ' : letter;
  }
  return out;
}

/// With a large first letter.
std::string begun(std::string text) {
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

std::string code(const std::string& text) {
  return text.empty() ? text : "`" + text + "`";
}

std::string codes(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : ", ") + code(word);
  return out;
}

std::string value_cell(const Argument& argument) {
  if (argument.value.empty()) return "";
  std::string out = argument.choices.empty() ? cell_text(argument.value) : codes(argument.choices);
  if (!argument.range.empty()) out += ", " + cell_text(argument.range);
  return out + (argument.repeats ? " ..." : "");
}

std::string meaning_cell(const Argument& argument) {
  std::string out = cell_text(argument.description);
  if (!argument.needs.empty()) out += "; needs " + codes(argument.needs);
  if (!argument.excludes.empty()) out += "; not with " + codes(argument.excludes);
  return out;
}

std::string section(const Command& command) {
  std::string out =
      "\n## seamline " + command.name + "\n\n" + cell_text(begun(command.description)) + ".\n\n";
  out += "| argument | value | default | meaning |\n| --- | --- | --- | --- |\n";
  for (const Argument& argument : command.arguments) {
    if (argument.names.back() == "--help") continue;
    const std::string usual = argument.required ? "must be given" : code(argument.usual);
    out += "| " + codes(argument.names) + " | " + value_cell(argument) + " | " + usual + " | " +
           meaning_cell(argument) + " |\n";
  }
  return out;
}

}  // namespace

std::string reference_page(const CommandLine& line) {
  std::string out = "# Commands\n\n" + line.program.description +
                    "\nThis page is written by the build from the program's own list of options. "
                    "Every command also takes `--help`.\n\n"
                    "Exit status: 0 done; 1 wrong input, or printed output that was lost; 2 a bug; "
                    "130 stopped, and the same command goes on.\n\n"
                    "| command | what it does |\n| --- | --- |\n";
  for (const Command& command : line.commands)
    out += "| [`" + command.name + "`](#" + page_name(command) + ") | " + cell_text(command.description) +
           " |\n";
  for (const Command& command : line.commands) out += section(command);
  return out;
}

}  // namespace seamline::packaging
