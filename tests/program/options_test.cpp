// Every number of every command is checked before anything is done. The program's own list of options is
// walked, so that a new one is tried without being added here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <regex>
#include <set>

#include "commands/options/command_help.h"
#include "commands/program.h"
#include "run_program.h"
#include "support/files/atomic_file.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline {
namespace {

using test::fresh_folder;
using test::Outcome;
using test::run_seamline;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr std::array library_rooms = {
    "support",  "sensors", "scenes",     "window", "physics", "registration", "stimuli", "raytracer",
    "renderer", "sets",    "composites", "x3d",    "study",   "analysis",     "live",    "laboratory"};

/// Files whose product is a command line: of a page that is remade, of a job, of a kit, of the objects' file.
bool writes_command_lines(const std::string& path) {
  return path.starts_with("laboratory/evidence/") || path == "sets/cluster/job_scripts.cpp" ||
         path == "analysis/preregistration/replication_kit.cpp" || path == "composites/measured_places.cpp" ||
         path == "composites/place/place_window.cpp" ||
         path == "laboratory/stability/light/strong_light_cases.cpp";  // tries the reader of numbers
}

struct ListedOption {
  std::string command, name, kind;
  int values = 0;       ///< at least; 0 for flags
  int positionals = 0;  ///< of its command
};

std::vector<ListedOption> every_option() {
  bool failed = false;
  const std::unique_ptr<CLI::App> app = program(failed);
  std::vector<ListedOption> options;
  for (const auto& [name, command] : every_command(*app)) {
    const std::vector<CLI::Option*> all = command->get_options();
    const auto positionals = std::count_if(
        all.begin(), all.end(), [](const CLI::Option* option) { return option->get_positional(); });
    for (const CLI::Option* option : all)
      options.push_back({name, (option->get_positional() ? "" : "--") + option->get_single_name(),
                         option->get_type_name(), option->get_items_expected_min(),
                         static_cast<int>(positionals)});
  }
  return options;
}

/// Flags, and texts that are names of files, of columns and the like. Whatever else there is, is made of
/// numbers.
bool holds_numbers(const ListedOption& option) {
  return option.values > 0 && !option.kind.starts_with("TEXT") && option.kind != "NAME" &&
         option.kind != "COLUMN";
}

/// What a command line says to its arguments before it does anything.
std::string parsed(CLI::App& app, const std::vector<std::string>& arguments) {
  std::vector<const char*> pointers = {"seamline"};
  for (const std::string& argument : arguments) pointers.push_back(argument.c_str());
  try {
    app.parse(static_cast<int>(pointers.size()), pointers.data());
  } catch (const InputError& error) {
    return error.what();
  } catch (const CLI::ParseError& error) {
    return std::string("arguments: ") + error.what();
  }
  return "done";
}

std::string parsed(const std::vector<std::string>& arguments) {
  bool failed = false;
  return parsed(*program(failed), arguments);
}

std::vector<std::string> wrong_values(const ListedOption& option) {
  std::vector<std::string> wrong = {"nan", "-nan", "NaN(7)", "inf", "-inf", "infinity", "1e999", "",
                                    " ",   "1e",   "0x10",   "1 2", "1;2",  "none",     "\xFF"};
  const bool whole = option.kind.starts_with("INTEGER");
  const std::regex range(R"(:(\S+) to (\S+))");
  if (std::smatch found; std::regex_search(option.kind, found, range)) {
    const double least = std::stod(found[1]), most = std::stod(found[2]);
    for (const double outside :
         {least - std::max(1.0, std::abs(least)), most + std::max(1.0, std::abs(most)), -1e300, 1e300}) {
      std::ostringstream text;
      text << std::setprecision(whole ? 20 : 6) << outside;
      wrong.push_back(text.str());
    }
    if (whole) wrong.insert(wrong.end(), {"1.5", "99999999999999999999999"});
  } else {
    wrong.insert(wrong.end(), {"-1", "nan,nan", "free:nan", "free:inf", "1,inf", "nanxnan", "1/nan", "1,"});
  }
  return wrong;
}

/// `value` as each of the values that the option needs, the others being fine.
std::vector<std::vector<std::string>> settings(const ListedOption& option, const std::string& value) {
  std::vector<std::vector<std::string>> all;
  for (int place = 0; place < option.values; ++place) {
    std::vector<std::string> arguments = test::words_of(option.command);
    if (option.name.starts_with("-")) {
      arguments.insert(arguments.end(), static_cast<std::size_t>(option.positionals), "x");
      arguments.push_back(option.name);
    }
    for (int i = 0; i < option.values; ++i) arguments.push_back(i == place ? value : "1");
    all.push_back(std::move(arguments));
  }
  return all;
}

TEST(Options, EveryNumberOfEveryCommandIsChecked) {
  const std::set<std::string> formed = {"I/N", "WxH", "RATE", "MEAN,SD", "MEDIAN,SD", "A,B"};
  std::set<std::string> commands;
  int tried = 0;
  for (const ListedOption& option : every_option()) {
    if (!holds_numbers(option)) continue;
    commands.insert(option.command);
    EXPECT_TRUE(option.kind.find(" to ") != std::string::npos || formed.contains(option.kind))
        << option.command << " " << option.name << " is a " << option.kind
        << ": add it with add_number (support/text/number_option.h)";
    bool failed = false;
    const std::unique_ptr<CLI::App> app = program(failed);  // refuses, and is used again
    for (const std::string& value : wrong_values(option))
      for (const std::vector<std::string>& arguments : settings(option, value)) {
        const std::string said = parsed(*app, arguments);
        EXPECT_THAT(said, StartsWith(option.name + ": wanted "))
            << option.command << " with '" << value << "'";
        EXPECT_EQ(said.find('\n'), std::string::npos);
        ++tried;
      }
  }
  EXPECT_GE(commands.size(), 11U);
  EXPECT_GE(tried, 1000);
  RecordProperty("tried", tried);
}

TEST(Options, AWrongNumberIsExitStatusOneAndWritesNothing) {
  const auto folder = fresh_folder("options");
  std::set<std::string> commands;
  for (const ListedOption& option : every_option()) {
    if (!holds_numbers(option) || !commands.insert(option.command).second) continue;
    const Outcome outcome =
        run_seamline(option.command + " " + option.name + " nan --out " + (folder / "out.exr").string());
    EXPECT_EQ(outcome.status, 1) << option.command;
    EXPECT_THAT(outcome.output, StartsWith("seamline: " + option.name + ": wanted "));
    EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST(Options, TooFewNumbersAreSaidToBe) {
  const auto said = [](const std::string& arguments) {
    return run_seamline("picture a.glb " + arguments).output;
  };
  EXPECT_THAT(said("--environment 1 1"), StartsWith("seamline: --environment: wanted 3 values, found fewer"));
  EXPECT_THAT(said("--environment 1 1 --out a.png"),
              StartsWith("seamline: --environment: wanted 3 numbers, found \"--out\" after fewer"));
  EXPECT_THAT(said("--out"), StartsWith("seamline: --out: wanted a value, found nothing"));
}

TEST(Options, EndsOfARangeAreInside) {
  const std::string required = "is required";
  for (const char* text : {"2", "+2", "16384"})
    EXPECT_THAT(parsed({"capture", "--width", text}), HasSubstr(required)) << text;
  EXPECT_THAT(parsed({"composite", "--fov", "170", "--albedo", "0", "--exposure", "-60"}),
              HasSubstr(required));
  EXPECT_THAT(parsed({"study", "--seed", "18446744073709551615"}), HasSubstr(required));
  EXPECT_THAT(parsed({"study", "--seed", "18446744073709551616"}), HasSubstr("--seed: wanted"));
  EXPECT_THAT(parsed({"fit", "--lapse", "free:0.05", "--guess", "free", "--threshold-prior", "-3,1e2"}),
              HasSubstr(required));
  EXPECT_THAT(parsed({"plan", "--participants", "2,10000"}), HasSubstr(required));
}

TEST(Options, NumbersOnTheCommandLineAreReadInOnePlace) {
  const std::filesystem::path root = SEAMLINE_SOURCE_DIR;
  const std::regex other_ways(R"(\bsto[idlfu]|\bstrto|from_chars|sscanf|CLI::(Range|Bound|PositiveNumber))");
  int with_options = 0;
  std::vector<std::string> rooms(library_rooms.begin(), library_rooms.end());
  rooms.emplace_back("commands");
  for (const std::string& room : rooms)
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / room)) {
      const std::string path = std::filesystem::relative(entry.path(), root).generic_string();
      if (entry.path().extension() != ".cpp" || path == "support/text/number_option.cpp") continue;
      const std::string text = test::read_text(entry.path());
      if (text.find("CLI/CLI.hpp") == std::string::npos) continue;
      // Nothing but a command knows the command line. That case tries its reader of numbers.
      EXPECT_TRUE(room == "commands" || path == "laboratory/stability/light/strong_light_cases.cpp") << path;
      ++with_options;
      EXPECT_FALSE(std::regex_search(text, other_ways)) << path;
    }
  EXPECT_GE(with_options, 10);
}

/// Words of a command line in string literals: "--depth-width".
std::vector<std::string> options_in_texts(const std::string& source) {
  const std::regex literal(R"("(?:[^"\\\n]|\\.)*")"), option(R"((^|[ "`]|[ "]\()--[a-z][a-z-]+)");
  std::vector<std::string> found;
  for (auto it = std::sregex_iterator(source.begin(), source.end(), literal); it != std::sregex_iterator();
       ++it)
    if (const std::string text = it->str(); std::regex_search(text, option)) found.push_back(text);
  return found;
}

TEST(Options, LibrariesNameMembersOfRequestsThatAreOptions) {
  bool failed = false;
  const std::unique_ptr<CLI::App> app = program(failed);
  std::set<std::string> options;
  for (const auto& [name, command] : every_command(*app))
    for (const CLI::Option* option : command->get_options())
      for (const std::string& word : option->get_lnames()) options.insert(word);
  const std::regex named(R"re(request_name\("([a-z0-9_]+)"\))re");
  const std::filesystem::path root = SEAMLINE_SOURCE_DIR;
  int names = 0;
  for (const char* room : library_rooms)
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / room)) {
      const std::string path = std::filesystem::relative(entry.path(), root).generic_string();
      if (entry.path().extension() != ".cpp") continue;
      const std::string source = test::read_text(entry.path());
      for (auto it = std::sregex_iterator(source.begin(), source.end(), named); it != std::sregex_iterator();
           ++it, ++names) {
        std::string option = (*it)[1];
        std::replace(option.begin(), option.end(), '_', '-');
        EXPECT_TRUE(options.contains(option)) << path << " names " << option;
      }
      if (writes_command_lines(path)) continue;
      for (const std::string& text : options_in_texts(source))
        EXPECT_THAT(text, HasSubstr("seamline ")) << path;
    }
  EXPECT_GE(names, 150);
}

TEST(Options, AMessageCallsAMemberOfARequestAsItsReaderDoes) {
  EXPECT_EQ(request_name("depth_width"), "depth_width");
  {
    const RequestSpelling shouted([](std::string_view member) { return "<" + std::string(member) + ">"; });
    EXPECT_EQ(request_name("depth_width"), "<depth_width>");
  }
  EXPECT_EQ(request_name("depth_width"), "depth_width");
  const std::filesystem::path counts = fresh_folder("request-names") / "counts.csv";
  write_file_atomically(counts, "level,k,n\n1,1,2\n");
  EXPECT_THAT(run_seamline("fit '" + counts.string() + "' --alternatives 3 --times dose").output,
              HasSubstr("wanted a column 'dose' (--times)"));
}

TEST(Options, WhatIsNoOptionIsOneLineWithoutItsEscapes) {
  const Outcome outcome = run_seamline("verify a \"$(printf 'b\\033[31mc\\nd\\377')\"");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, Not(HasSubstr("\033")));
  EXPECT_THAT(outcome.output, HasSubstr("\\x1B[31mc\\nd\\xFF"));
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
}

}  // namespace
}  // namespace seamline
