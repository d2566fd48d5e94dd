// A build tool: writes the manual pages, the page of all commands and the completion of bash from the
// program's own list of options, and the tables of the page of study files from its settings.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "commands/manual/command_line.h"
#include "commands/program.h"
#include "stimuli/settings/whole/settings_page.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: write_manual FOLDER PAGE_OF_STUDY_FILES\n");
    return 1;
  }
  try {
    bool any_case_failed = false;
    const auto app = seamline::program(any_case_failed);
    const seamline::packaging::CommandLine line = seamline::packaging::command_line(*app);
    const std::filesystem::path folder = argv[1];
    const std::string version = seamline::program_version();
    std::filesystem::remove_all(folder / "man1");  // pages of commands that are no more
    std::filesystem::create_directories(folder / "man1");
    seamline::write_file_atomically(folder / "man1" / "seamline.1",
                                    seamline::packaging::program_page(line, version));
    for (const seamline::packaging::Command& command : line.commands)
      seamline::write_file_atomically(folder / "man1" / (seamline::packaging::page_name(command) + ".1"),
                                      seamline::packaging::command_page(command, version));
    seamline::write_file_atomically(folder / "commands.md", seamline::packaging::reference_page(line));
    seamline::write_file_atomically(folder / "study_file.md",
                                    seamline::with_settings_tables(seamline::read_file(argv[2])));
    seamline::write_file_atomically(folder / "seamline.bash", seamline::packaging::bash_completion(line));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "write_manual: %s\n", error.what());
    return 1;
  }
}
