#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "pages.h"

/// Every command on every page, run (page_commands_full_test.cpp): what a page says is done in an order.
namespace seamline::page_commands {

/// A step of a page: a command line of `seamline`, one of another program, or a file that the page writes.
struct PageStep {
  enum class Kind { command, other_program, file, lines_of_file };
  Kind kind = Kind::command;
  std::string text;       ///< the line as it is printed, or the file's lines
  std::string file = {};  ///< its name
};

/// Commands of other programs, by their beginning: out of scope here.
struct OtherProgram {
  std::string_view begins, why;
};
inline constexpr std::array other_programs = {
    OtherProgram{"./quickstart", "installs what the build needs, builds, runs all tests"},
    OtherProgram{"apt-get ", "as root; packaging/try_on_bare_debian runs it"},
    OtherProgram{"(cd build/release && cpack", "makes what packaging/try_on_bare_debian tries"},
    OtherProgram{"cmake --install", "Install.* run it"},
    OtherProgram{"cmake --build build/release --target site", "runs documentation/site/build"},
    OtherProgram{"documentation/site/build", "CI runs it"},
    OtherProgram{"/shared/job/", "ClusterScripts.* run it with stand-ins, Slurm.* with Slurm"},
    OtherProgram{"certbot ", "asks a certificate authority"},
    OtherProgram{"shuf ", "coreutils"},
    OtherProgram{"export ", "sets variables: Python.* have them"},
    OtherProgram{"fuzz/", "builds with clang; CI runs it"},
    OtherProgram{"tests/sanitize ", "builds with sanitizers; CI runs it"},
    OtherProgram{"tests/faults/run", "Faults.Quick is what it runs"},
    OtherProgram{"documentation/papers/", "scripts for figures, of hours"}};

/// A command of `seamline` that is not run.
struct NotRun {
  std::string_view page, begins, why;
};
/// Each entry stands on its page; no line else is left out.
[[nodiscard]] const std::vector<NotRun>& not_run();

/// The steps of a page, in its order. Blocks without a command say what the program prints.
[[nodiscard]] std::vector<PageStep> steps_of(const test::ManualPage& page);

/// Whether a page has a command of `seamline`.
[[nodiscard]] bool has_commands(const test::ManualPage& page);

/// The first word of a line's command without its spaces: "build/release/seamline" is "seamline".
[[nodiscard]] bool is_own(std::string_view line);

/// Words of a command line without its comment, quotes and joints.
[[nodiscard]] std::vector<std::string> words_of_line(const std::string& line);

/// The same work in smaller pictures of fewer samples, with fewer simulations, on this computer.
[[nodiscard]] std::string smaller_line(std::string line);

/// The patterns that `smaller_line` replaces.
[[nodiscard]] std::vector<std::string> replaced_patterns();

/// A study file in small pictures of few samples with coarse meshes; unless `every_stimulus` is wanted, with
/// its first scene, conditions and levels alone. Another text stays.
[[nodiscard]] std::string smaller_study(const std::string& text, bool every_stimulus);

}  // namespace seamline::page_commands
