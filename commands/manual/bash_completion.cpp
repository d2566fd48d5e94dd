#include "commands/manual/command_line.h"

#include <map>

namespace seamline::packaging {
namespace {

std::string words(const std::vector<std::string>& all) {
  std::string out;
  for (const std::string& word : all) out += (out.empty() ? "" : " ") + word;
  return out;
}

std::string options_of(const Command& command) {
  std::vector<std::string> names;
  for (const Argument& argument : command.arguments)
    if (!argument.positional) names.insert(names.end(), argument.names.begin(), argument.names.end());
  return words(names);
}

std::string pattern(const Argument& argument) {
  std::string out;
  for (const std::string& name : argument.names) out += (out.empty() ? "" : "|") + name;
  return out;
}

/// What stands after an option: one of its words, a path, or what cannot be foreseen.
std::string values_of(const Command& command) {
  std::string out;
  for (const Argument& argument : command.arguments) {
    if (argument.positional || argument.value.empty()) continue;
    out += "        " + pattern(argument) + ") ";
    if (!argument.choices.empty())
      out += "values='" + words(argument.choices) + "'";
    else
      out += argument.value == "TEXT" ? "kind=path" : "kind=number";
    out += " ;;\n";
  }
  return out;
}

std::string case_of(const Command& command) {
  const std::string values = values_of(command);
  std::string out = "    '" + command.name + "')\n      options='" + options_of(command) + "'\n";
  if (!values.empty()) out += "      case $previous in\n" + values + "      esac\n";
  return out + "      ;;\n";
}

}  // namespace

std::string bash_completion(const CommandLine& line) {
  const std::string& name = line.program.name;
  std::vector<std::string> commands;
  std::map<std::string, std::vector<std::string>> inner;  // of groups, "lab bench"
  std::string cases, groups;
  for (const Command& command : line.commands) {
    const std::size_t space = command.name.find(' ');
    const std::string first = command.name.substr(0, space);
    if (space != std::string::npos) inner[first].push_back(command.name.substr(space + 1));
    if (commands.empty() || commands.back() != first) commands.push_back(first);
    cases += case_of(command);
  }
  for (const auto& [group, names] : inner)
    groups += "  if [[ $command == " + group +
              " ]]; then\n    if [[ $COMP_CWORD -eq 2 ]]; then\n      mapfile -t " +
              "COMPREPLY < <(compgen -W '" + words(names) + "' -- \"$word\")\n      return\n    fi\n" +
              "    command+=\" ${COMP_WORDS[2]}\"\n  fi\n";
  return "# bash completion for " + name +
         "; the build writes it from the program's own list of options.\n_" + name + R"(() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} options= values= kind=
  local command=${COMP_WORDS[1]}
  COMPREPLY=()
  if [[ $COMP_CWORD -eq 1 ]]; then
    mapfile -t COMPREPLY < <(compgen -W ')" +
         words(commands) + " " + options_of(line.program) + R"(' -- "$word")
    return
  fi
  if [[ $word == = ]]; then  # --option=VALUE is three words to bash
    word=
  elif [[ $previous == = ]]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi
)" + groups +
         "  case $command in\n" + cases +
         R"(  esac
  if [[ -n $values ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$values" -- "$word")
  elif [[ $kind == number ]]; then
    compopt +o default 2>/dev/null  # no path stands here
  elif [[ $kind != path && $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  fi
}
complete -o default -F _)" +
         name + " " + name + "\n";
}

}  // namespace seamline::packaging
