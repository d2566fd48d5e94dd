#include "commands/former_spelling.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "support/text/error.h"

namespace seamline {
namespace {

using Words = std::vector<std::string>;

/// An option that has become a command: `log LOG --exclude CODE` is `log exclude LOG CODE`.
struct MovedOption {
  const char* command;
  const char* option;
  Words today;     ///< the command's words
  bool has_value;  ///< the option's value is today's last argument
};

const std::vector<MovedOption>& moved_options() {
  static const std::vector<MovedOption> moved = {
      {"log", "--status", {"log", "status"}, false},
      {"log", "--tracks", {"log", "tracks"}, false},
      {"log", "--exclude", {"log", "exclude"}, true},
      {"log", "--forget", {"log", "forget"}, true},
      {"log", "--backup", {"log", "backup"}, true},
      {"log", "--identifiers", {"log", "identifiers"}, true},
      {"log", "--forget-identifiers", {"log", "forget-identifiers"}, false},
      {"log", "--recover", {"log", "recover"}, true},
      {"log", "--upgrade", {"log", "upgrade"}, true},
      {"export", "--web", {"export", "web"}, true},
      {"export", "--csv", {"export", "tables"}, true},
      {"export", "--psych-ds", {"export", "tables", "--layout=psych-ds"}, true},
      {"export", "--bids", {"export", "tables", "--layout=bids"}, true},
      {"export", "--y4m", {"export", "video"}, true},
      {"export", "--x3d", {"export", "x3d"}, true},
      {"render", "--status", {"job", "status"}, true}};
  return moved;
}

bool is_option(const std::string& word, const std::string& option) {
  return word == option || word.starts_with(option + "=");
}

/// The arguments without the option, which is at `at`, and its value at their end.
Words with_command(const MovedOption& moved, const Words& arguments, std::size_t at) {
  Words out = moved.today;
  std::optional<std::string> value;
  std::size_t skip = at;
  if (moved.has_value) {
    const std::size_t equals = arguments[at].find('=');
    if (equals != std::string::npos) value = arguments[at].substr(equals + 1);
    if (equals == std::string::npos && at + 1 < arguments.size()) value = arguments[skip = at + 1];
  }
  for (std::size_t i = 1; i < arguments.size(); ++i)
    if (i < at || i > skip) out.push_back(arguments[i]);
  if (value) out.push_back(*value);
  return out;
}

std::optional<Words> spelled_anew(const Words& arguments) {
  static const Words lab = {"bench", "convergence", "stability", "marker", "person", "field"};
  if (std::find(lab.begin(), lab.end(), arguments.front()) != lab.end()) {
    Words out = {"lab"};
    out.insert(out.end(), arguments.begin(), arguments.end());
    return out;
  }
  std::vector<std::pair<const MovedOption*, std::size_t>> found;
  for (std::size_t i = 1; i < arguments.size(); ++i)
    for (const MovedOption& moved : moved_options())
      if (moved.command == arguments.front() && is_option(arguments[i], moved.option))
        found.emplace_back(&moved, i);
  // A job of many machines keeps its options' names.
  if (found.empty() && arguments.front() == "render")
    for (const std::string& word : arguments)
      for (const char* option : {"--slurm", "--parallel", "--element"})
        if (is_option(word, option)) {
          Words out = {"job", std::string(option) == "--element" ? "piece" : "write"};
          out.insert(out.end(), arguments.begin() + 1, arguments.end());
          return out;
        }
  if (found.empty()) return std::nullopt;
  if (found.size() > 1)
    throw input_error(
        {.field = "seamline " + arguments.front(),
         .wanted = fmt::format("one of {} and {} at a time (they are commands now: seamline {})",
                               found[0].first->option, found[1].first->option,
                               fmt::join(found[0].first->today, " ")),
         .found = "both"});
  return with_command(*found.front().first, arguments, found.front().second);
}

}  // namespace

Words todays_spelling(Words arguments) {
  if (arguments.empty()) return arguments;
  std::optional<Words> today = spelled_anew(arguments);
  if (!today) return arguments;
  std::fprintf(stderr, "seamline: this is now %s; the old spelling ends with the next version\n",
               fmt::format("seamline {}", fmt::join(*today, " ")).c_str());
  return std::move(*today);
}

}  // namespace seamline
