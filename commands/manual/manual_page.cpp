#include "commands/manual/command_line.h"

#include <algorithm>
#include <cctype>

namespace seamline::packaging {
namespace {

/// Text that groff prints as it stands.
std::string plain(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '\\')
      out += "\\e";
    else if (letter == '-')
      out += "\\-";  // a hyphen that can be copied into a shell
    else if (letter == '\'' || letter == '`' || letter == '^' || letter == '~' || letter == '"')
      out += letter == '\''  ? "\\(aq"
             : letter == '`' ? "\\(ga"
             : letter == '^' ? "\\(ha"
             : letter == '~' ? "\\(ti"
                             : "\\(dq";
    else
      out += letter == '\n' ? ' ' : letter;
  }
  return out.starts_with('.') ? "\\&" + out : out;
}

std::string bold(const std::string& text) {
  return "\\fB" + plain(text) + "\\fR";
}

std::string slanted(const std::string& text) {
  return "\\fI" + plain(text) + "\\fR";
}

template <class Item, class Write>
std::string joined(const std::vector<Item>& items, const char* between, Write write) {
  std::string out;
  for (const Item& item : items) out += (out.empty() ? "" : between) + write(item);
  return out;
}

std::string value_text(const Argument& argument) {
  if (argument.value.empty()) return {};
  const std::string value =
      argument.choices.empty() ? slanted(argument.value) : joined(argument.choices, "|\\:", bold);
  return value + (argument.repeats ? " ..." : "");
}

std::string usual_form(const Argument& argument) {
  const std::string value = value_text(argument);
  return bold(argument.names.back()) + (value.empty() ? "" : "\\ " + value);
}

/// As a sentence: a large letter first, a full stop last.
std::string sentence(std::string text) {
  if (text.empty()) return text;
  if (text.size() > 1 && text.find(':') > 6)  // "fast: shared ..." explains a word as it is typed
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text.ends_with('.') || text.ends_with('?') ? text : text + ".";
}

std::string entry(const Argument& argument) {
  std::string out = ".TP\n";
  if (argument.positional)
    out += slanted(argument.names.front()) + (argument.repeats ? " ..." : "");
  else
    out += joined(argument.names, ", ", bold) + (argument.value.empty() ? "" : " " + value_text(argument));
  out += "\n" + plain(sentence(argument.description));
  if (!argument.range.empty()) out += "\nRange: " + plain(argument.range) + ".";
  if (!argument.usual.empty()) out += "\nDefault: " + bold(argument.usual) + ".";
  if (argument.required && !argument.positional) out += "\nMust be given.";
  if (!argument.needs.empty()) out += "\nNeeds " + joined(argument.needs, ", ", bold) + ".";
  if (!argument.excludes.empty()) out += "\nNot with " + joined(argument.excludes, ", ", bold) + ".";
  return out + "\n";
}

std::string title(const std::string& page, const std::string& version) {
  std::string large = page;
  std::transform(large.begin(), large.end(), large.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  // Ragged right and no hyphens: options and paths must be found by search.
  return ".TH " + plain(large) + " 1 \"\" \"seamline " + plain(version) + "\" \"Seamline\"\n.ad l\n.nh\n";
}

std::string options_section(const Command& command, bool positional) {
  std::string out;
  for (const Argument& argument : command.arguments)
    if (argument.positional == positional) out += entry(argument);
  return out.empty() ? out : (positional ? ".SH ARGUMENTS\n" : ".SH OPTIONS\n") + out;
}

const char* const exit_statuses = R"(.SH EXIT STATUS
.TP
0
Done.
.TP
1
The input is wrong: one sentence says which file or option, what was wanted and what was found.
Or what was printed on standard output was lost: the disk is full, or the output closed. Files are complete then.
.TP
2
A bug in the program.
.TP
130
Stopped by Ctrl\-C or SIGTERM; the same command, run again, goes on from what is on the disk.
)";

const char* const files = R"(.SH FILES
All lie beside the program's own folder, wherever that is:
.TP
.I ../share/seamline/scenes/builtin
The built\-in scenes and objects, which a study file calls
.BI builtin: NAME\fR.
.TP
.I ../share/seamline/stimuli
The studies that come with Seamline.
.TP
.I ../share/doc/seamline/documentation
The documentation; begin with
.IR tutorials/first_study.md .
)";

}  // namespace

std::string program_page(const CommandLine& line, const std::string& version) {
  std::string out = title(line.program.name, version);
  out += ".SH NAME\n" + plain(line.program.name) +
         " \\- perceptual thresholds of depth resolution in mixed reality\n.SH SYNOPSIS\n" +
         bold(line.program.name) + " \\fIcommand\\fR [\\fIargument\\fR ...]\n.SH DESCRIPTION\n" +
         plain(sentence(line.program.description)) +
         "\nIt renders pictures in which one object was composited through a depth map, shows them to "
         "people, and computes thresholds from their answers.\n.PP\nEach command has a page of its own, "
         "e.g.\n.BR seamline\\-render (1).\n"
         ".SH COMMANDS\n";
  for (const Command& command : line.commands)
    out += ".TP\n" + bold(command.name) + "\n" + plain(sentence(command.description)) + "\n";
  out += options_section(line.program, false) + exit_statuses + files;
  out += R"(.SH EXAMPLES
.nf
seamline demo
seamline check my_study.toml
seamline render my_study.toml \-\-out my_set
seamline study my_set \-\-log answers.sqlite \-\-observer threshold \-\-count 20
seamline analyze answers.sqlite \-\-out report
.fi
.SH SEE ALSO
)";
  return out +
         joined(line.commands, ",\n",
                [](const Command& command) { return ".BR " + plain(page_name(command)) + " (1)"; }) +
         "\n";
}

std::string command_page(const Command& command, const std::string& version) {
  const std::string page = page_name(command);
  std::string out = title(page, version) + ".SH NAME\n" + plain(page) + " \\- " + plain(command.description) +
                    "\n.SH SYNOPSIS\n.HP\n" + bold("seamline " + command.name);
  for (const Argument& argument : command.arguments) {
    const std::string form = argument.positional ? slanted(argument.names.front()) : usual_form(argument);
    if (argument.names.back() != "--help") out += "\n" + (argument.required ? form : "[" + form + "]");
  }
  return out + "\n.SH DESCRIPTION\n" + plain(sentence(command.description)) + "\n" +
         options_section(command, true) + options_section(command, false) + exit_statuses +
         ".SH SEE ALSO\n.BR seamline (1)\n";
}

}  // namespace seamline::packaging
