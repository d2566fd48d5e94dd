#include "commands/manual/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <set>
#include <sstream>

namespace seamline::packaging {
namespace {

std::vector<std::string> names_of(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  std::sort(names.begin(), names.end());
  return names;
}

/// CLI11 keeps a type as "INTEGER:1 to 4096" or "TEXT:{fast,path}".
void read_type(const std::string& type, Argument& argument) {
  const std::size_t colon = type.find(':');
  argument.value = type.substr(0, colon);
  if (colon == std::string::npos) return;
  const std::string rest = type.substr(colon + 1);
  if (!rest.starts_with('{')) {
    argument.range = rest;
    return;
  }
  std::istringstream words(rest.substr(1, rest.find('}') - 1));
  for (std::string word; std::getline(words, word, ',');) argument.choices.push_back(word);
}

Argument argument_of(const CLI::Option& option) {
  Argument argument{.usual = option.get_default_str(),
                    .description = option.get_description(),
                    .needs = names_of(option.get_needs()),
                    .excludes = names_of(option.get_excludes()),
                    .positional = option.get_positional(),
                    .required = option.get_required()};
  if (argument.positional) {
    argument.names = {option.get_single_name()};
  } else {
    for (const std::string& name : option.get_snames()) argument.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) argument.names.push_back("--" + name);
  }
  if (option.get_items_expected_max() > 0) read_type(option.get_type_name(), argument);
  argument.repeats = option.get_items_expected_max() > 1;
  return argument;
}

Command command_of(const CLI::App& app) {
  Command command{.name = app.get_name(), .description = app.get_description()};
  for (const CLI::Option* option : app.get_options())
    if (!option->get_group().empty()) command.arguments.push_back(argument_of(*option));
  // Positionals first, as they are typed.
  std::stable_partition(command.arguments.begin(), command.arguments.end(),
                        [](const Argument& argument) { return argument.positional; });
  return command;
}

std::vector<const CLI::App*> commands_in(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

}  // namespace

CommandLine command_line(const CLI::App& app) {
  CommandLine line{.program = command_of(app)};
  for (const CLI::App* command : commands_in(app)) {
    const std::vector<const CLI::App*> inner = commands_in(*command);
    if (inner.empty()) line.commands.push_back(command_of(*command));
    for (const CLI::App* one : inner) {
      line.commands.push_back(command_of(*one));
      line.commands.back().name = command->get_name() + " " + one->get_name();
    }
  }
  return line;
}

std::string page_name(const Command& command) {
  std::string name = "seamline-" + command.name;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

}  // namespace seamline::packaging
