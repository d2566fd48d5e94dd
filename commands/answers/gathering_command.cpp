#include "commands/answers/answer_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "study/log/online/log_merge.h"
#include "study/log/online/online_log.h"
#include "study/online/intake/import.h"

namespace seamline::study::online {
namespace fs = std::filesystem;
namespace {

struct GatheringOptions {
  std::string log, set;
  std::vector<std::string> files;
  bool skip_foreign = false;
};

void run_import(const GatheringOptions& options) {
  const RenderedSet set = set_for_log(options.log, options.set);
  const std::vector<fs::path> files(options.files.begin(), options.files.end());
  const Foreign foreign = options.skip_foreign ? Foreign::left_out : Foreign::ends_the_import;
  fmt::print("{}", import_text(import_messages(set, options.log, files, foreign), options.log));
}

void run_merge(const GatheringOptions& options) {
  const std::vector<fs::path> logs(options.files.begin(), options.files.end());
  fmt::print("{}", merge_text(merge_logs(options.log, logs), options.log));
}

}  // namespace

void add_gathering_commands(CLI::App& app) {
  const auto imported = std::make_shared<GatheringOptions>();
  CLI::App* import =
      app.add_subcommand("import", "store results of JATOS, or downloads of a page, into a log");
  import->add_option("log", imported->log, "the log; made when it is missing")->required();
  import
      ->add_option("files", imported->files, "files of messages, or JATOS's archives of them (.jrzip, .zip)")
      ->required();
  import->add_option("--set", imported->set, "the rendered set; else where the log says");
  import->add_flag("--skip-foreign", imported->skip_foreign,
                   "leave out, by name, what is no message of this study and set (else it ends the command)");
  import->callback([imported] { run_import(*imported); });

  const auto merged = std::make_shared<GatheringOptions>();
  CLI::App* merge = app.add_subcommand("merge", "add the participants of other logs of the same study");
  merge->add_option("into", merged->log, "the log that gets them")->required();
  merge->add_option("from", merged->files, "the other logs, which stay as they are")->required();
  merge->callback([merged] { run_merge(*merged); });
}

}  // namespace seamline::study::online
