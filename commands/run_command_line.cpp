// One place that catches: what ends a command with which exit status.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <string_view>

#include "commands/former_spelling.h"
#include "commands/options/command_help.h"
#include "commands/program.h"
#include "support/running/interrupt.h"
#include "support/running/memory.h"
#include "support/running/standard_streams.h"
#include "support/text/error.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

namespace seamline {
namespace {

constexpr int exit_wrong_input = 1;
constexpr int exit_unstable = 1;
constexpr int exit_bug = 2;
constexpr int exit_interrupted = 130;
constexpr std::size_t longest_sentence = 2000;  ///< letters; its parts are shortened already

/// The option that sets a member of a request: "allow_scaling" is "--allow-scaling".
std::string option_of(std::string_view member) {
  std::string option = "--" + std::string(member);
  std::replace(option.begin(), option.end(), '_', '-');
  return option;
}

int parse(CLI::App& app, int argc, char** argv) {
  std::vector<std::string> arguments = todays_spelling({argv + 1, argv + argc});
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the end
  try {
    app.parse(std::move(arguments));
    return 0;
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    const int status = app.exit(help, text);
    std::fputs(text.str().c_str(), stdout);
    return status;
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "seamline: %s (see --help)\n", printable(refusal_of_arguments(app, error)).c_str());
    return exit_wrong_input;
  }
}

}  // namespace

int run_command_line(int argc, char** argv) {
  guard_standard_streams();
  keep_freed_memory();
  const RequestSpelling as_options(&option_of);
  bool any_case_failed = false;
  const std::unique_ptr<CLI::App> app = program(any_case_failed);
  catch_interrupts();
  try {
    const int status = parse(*app, argc, argv);
    if (status == 0) require_standard_output();
    return status == 0 && any_case_failed ? exit_unstable : status;
  } catch (const InputError& error) {
    std::fprintf(stderr, "seamline: %s\n", printable(error.what(), longest_sentence).c_str());
    return exit_wrong_input;
  } catch (const Interrupted&) {
    std::fprintf(stderr,
                 "seamline: stopped; the same command, run again, goes on from what is on the disk\n");
    return exit_interrupted;
  } catch (const std::filesystem::filesystem_error& error) {
    std::fprintf(stderr, "seamline: %s: wanted a path that can be used, found %s\n",
                 printable(error.path1().native()).c_str(), error.code().message().c_str());
    return exit_wrong_input;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "seamline: wanted input that fits into memory, found more than there is\n");
    return exit_wrong_input;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "seamline: this is a bug in seamline: %s\n",
                 printable(error.what(), longest_sentence).c_str());
    return exit_bug;
  }
}

}  // namespace seamline
