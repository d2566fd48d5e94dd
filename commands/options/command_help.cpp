#include "commands/options/command_help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <string_view>

#include "support/text/suggest.h"

namespace seamline {
namespace {

constexpr std::size_t line_letters = 80;
constexpr const char* common = "Options";  ///< the group of CLI11 where none is said

std::vector<CLI::App*> subcommands(CLI::App& app) {
  return app.get_subcommands([](CLI::App*) { return true; });
}

/// Words of `text`, in lines that begin at `indent`; the first line stands where `column` letters are
/// written.
std::string wrapped(const std::string& text, std::size_t column, std::size_t indent) {
  std::string out;
  std::istringstream words(text);
  bool begins_line = true;
  for (std::string word; words >> word; begins_line = false) {
    if (!begins_line && column + 1 + word.size() > line_letters) {
      out += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!begins_line) {
      out += " ";
      ++column;
    }
    out += word;
    column += word.size();
  }
  return out;
}

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    if (mode == CLI::AppFormatMode::Sub) return make_expanded(app);
    return wrapped(make_description(app), 0, 0) + "\n" + make_usage(app, std::move(name)) +
           make_positionals(app) + options_by_groups(*app, mode) + make_subcommands(app, mode) + "\n" +
           make_footer(app);
  }

  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const std::string left = "  " + make_option_name(option, is_positional) + make_option_opts(option);
    const std::size_t column = get_column_width();
    std::string out = wrapped(left.substr(2), 2, 6);
    out.insert(0, "  ");
    if (make_option_desc(option).empty()) return out + "\n";
    const std::size_t last_line =
        out.size() - (out.rfind('\n') == std::string::npos ? 0 : out.rfind('\n') + 1);
    out += last_line + 2 > column ? "\n" + std::string(column, ' ') : std::string(column - last_line, ' ');
    return out + wrapped(make_option_desc(option), column, column) + "\n";
  }

  std::string make_subcommand(const CLI::App* command) const override {
    const std::string left = "  " + command->get_name();
    constexpr std::size_t column = 14;
    return left + std::string(left.size() < column ? column - left.size() : 1, ' ') +
           wrapped(command->get_description(), column, column) + "\n";
  }

 private:
  std::string options_by_groups(const CLI::App& app, CLI::AppFormatMode mode) const {
    std::string out, further;
    for (const std::string& group : app.get_groups()) {
      const std::vector<const CLI::Option*> options = app.get_options(
          [&](const CLI::Option* option) { return option->get_group() == group && option->nonpositional(); });
      if (group.empty() || options.empty()) continue;
      if (group == common || mode == CLI::AppFormatMode::All || app.get_help_all_ptr() == nullptr)
        out += make_group(group, false, options);
      else
        further += (further.empty() ? "" : ", ") + group + " (" + std::to_string(options.size()) + ")";
    }
    if (further.empty()) return out;
    const std::string begin = "More options with --help-all: ";
    return out + "\n" + begin + wrapped(further + ".", begin.size(), 2) + "\n";
  }
};

std::vector<std::string> long_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// The command that was being read when something was not understood.
CLI::App& innermost(CLI::App& app) {
  for (CLI::App* command : subcommands(app))
    if (command->parsed()) return innermost(*command);
  return app;
}

std::string meant(const std::string& typed, const std::vector<std::string>& known) {
  const std::string nearest = nearest_word(typed.substr(0, typed.find('=')), known);
  return nearest.empty() ? std::string() : "; did you mean " + nearest + "?";
}

/// What CLI11 says of an option with too few values ("--at: 3 required NUMBER:0 to 1 missing"), in words.
std::string missing_in_words(const std::string& why) {
  constexpr std::string_view required = " required ", missing = " missing";
  const std::size_t colon = why.find(": "), after = why.find(required);
  if (colon == std::string::npos || after == std::string::npos || !why.ends_with(missing)) return why;
  const std::string name = why.substr(0, colon), count = why.substr(colon + 2, after - colon - 2);
  if (count.find_first_not_of("0123456789") != std::string::npos) return why;
  return count == "1" ? name + ": wanted a value, found nothing"
                      : fmt::format("{}: wanted {} values, found fewer", name, count);
}

/// What CLI11 says of an option given too often ("--out: At Most 1 required but received 2"), in words.
std::string counted_in_words(const std::string& why) {
  constexpr std::string_view at_most = ": At Most ", received = " required but received ";
  const std::size_t end_of_name = why.rfind(at_most), between = why.rfind(received);
  if (end_of_name == std::string::npos || between == std::string::npos || between < end_of_name) return why;
  const std::size_t start = end_of_name + at_most.size();
  const std::string name = why.substr(0, end_of_name), most = why.substr(start, between - start),
                    found = why.substr(between + received.size());
  if (most != "1") return fmt::format("{}: wanted at most {} values, found {}", name, most, found);
  return fmt::format("{}: wanted once, found {}", name, found == "2" ? "twice" : found + " times");
}

}  // namespace

void group_options(CLI::App& command, std::initializer_list<OptionGroup> groups) {
  for (const OptionGroup& group : groups)
    for (const char* name : group.options) command.get_option(name)->group(group.name);
  command.set_help_all_flag("--help-all", "print every option, by groups, and exit");
}

std::shared_ptr<CLI::Formatter> help_formatter() {
  return std::make_shared<HelpFormatter>();
}

std::vector<NamedCommand> every_command(CLI::App& program) {
  std::vector<NamedCommand> all;
  for (CLI::App* command : subcommands(program)) {
    const std::vector<CLI::App*> inner = subcommands(*command);
    if (inner.empty()) all.push_back({command->get_name(), command});
    for (CLI::App* one : inner) all.push_back({command->get_name() + " " + one->get_name(), one});
  }
  return all;
}

std::string refusal_of_arguments(CLI::App& program, const CLI::ParseError& error) {
  const std::string why = missing_in_words(counted_in_words(error.what()));
  CLI::App& command = innermost(program);
  const std::vector<std::string> rest = program.remaining(true);
  std::vector<std::string> names;
  for (const CLI::App* one : subcommands(command)) names.push_back(one->get_name());
  if (!rest.empty() && !names.empty() && !rest.front().starts_with("-"))
    return "no command " + rest.front() + meant(rest.front(), names);
  if (!rest.empty() && rest.front().starts_with("--"))
    return "no option " + rest.front().substr(0, rest.front().find('=')) + " of " + command.get_name() +
           meant(rest.front(), long_options(command));
  if (!names.empty() && rest.empty())
    return fmt::format("{}: wanted one of its commands: {}", command.get_name(), fmt::join(names, ", "));
  return why;
}

}  // namespace seamline
