#include "commands/answers/answer_commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "study/log/log_admin.h"
#include "study/log/log_writer.h"
#include "study/log/online/invitation_codes.h"
#include "study/log/online/log_backup.h"
#include "study/log/online/recruits.h"
#include "study/log/recovery/log_recovery.h"
#include "study/log/recovery/log_recovery_text.h"
#include "study/log/recovery/log_upgrade.h"
#include "study/running/quest_plus_results.h"
#include "study/running/staircase_results.h"
#include "support/files/held/written_files.h"
#include "support/text/counted.h"

namespace seamline::study {
namespace {

/// From the log, and from the file that says whose invitation was whose. Somebody who is in that file alone
/// was forgotten before, without it.
void forget_person(const std::string& log, const std::string& code, const std::string& codes_file) {
  if (codes_file.empty()) {
    const bool in_browser = forget_participant(log, code);
    (void)forget_recruit(log, code);
    if (in_browser)
      fmt::print("{}: forgotten in {}. {}\n", code, log,
                 "If a server kept codes (seamline serve --codes FILE), FILE still has their line: the same "
                 "command with --codes FILE takes it out.");
    return;
  }
  const bool is_in_log = has_participant(log, code);
  const InvitationCodes codes = read_invitation_codes(codes_file);
  const bool is_in_codes =
      std::any_of(codes.begin(), codes.end(), [&](const auto& line) { return line.second == code; });
  if (is_in_log || !is_in_codes) forget_participant(log, code);
  (void)forget_recruit(log, code);
  fmt::print("{}: {} in {}, {} taken out of {}\n", code, is_in_log ? "forgotten" : "not there any more", log,
             counted(forget_invitation_of(codes_file, code), "line"), codes_file);
}

/// What a command of `log` was given: the log, one more word, and the value of its option.
struct LogArguments {
  std::string log, second, extra;
};

struct SecondArgument {
  const char* name;
  const char* meaning;
};

using LogAction = std::function<void(const LogArguments&)>;

/// A command of `log`; `extra` of its arguments is for the caller's own option.
std::pair<CLI::App*, std::shared_ptr<LogArguments>> add_action(CLI::App& log, const char* name,
                                                               const char* meaning, LogAction action) {
  const auto arguments = std::make_shared<LogArguments>();
  CLI::App* command = log.add_subcommand(name, meaning);
  command->add_option("log", arguments->log, "the log")->required();
  command->callback([arguments, action = std::move(action)] { action(*arguments); });
  return {command, arguments};
}

std::pair<CLI::App*, std::shared_ptr<LogArguments>> add_action(CLI::App& log, const char* name,
                                                               const char* meaning,
                                                               const SecondArgument& second,
                                                               LogAction action) {
  auto added = add_action(log, name, meaning, std::move(action));
  added.first->add_option(second.name, added.second->second, second.meaning)->required();
  return added;
}

void add_people(CLI::App& log) {
  add_action(log, "status", "print who has done what",
             [](const LogArguments& given) { fmt::print("{}", status_text(read_log(given.log))); });
  add_action(log, "tracks", "print the thresholds of an adaptive study (QUEST+, staircases)",
             [](const LogArguments& given) {
               const LogContents contents = read_log(given.log);
               fmt::print("{}", has_staircases(contents) ? staircases_text(staircase_estimates(contents))
                                                         : tracks_text(quest_plus_estimates(contents)));
             });
  add_action(log, "exclude", "leave a participant's answers out of the analysis",
             {"code", "of the participant"},
             [](const LogArguments& given) { exclude_participant(given.log, given.second); });
  const auto [forget, arguments] =
      add_action(log, "forget", "delete every trace of a participant", {"code", "of the participant"},
                 [](const LogArguments& given) { forget_person(given.log, given.second, given.extra); });
  forget->add_option("--codes", arguments->extra,
                     "the file in which `serve --codes` kept whose invitation was whose");
}

void add_panel(CLI::App& log) {
  add_action(log, "identifiers", "write who came from a panel as which participant, with which end, as CSV",
             {"file", "CSV to write"}, [](const LogArguments& given) {
               require_outputs(std::vector<OptionFile>{{"file", given.second}},
                               std::vector<OptionFile>{{"log", given.log}});
               fmt::print("{}: {}\n", given.second,
                          counted(write_recruits(given.log, given.second), "person", "people"));
             });
  add_action(log, "forget-identifiers", "delete all identifiers of a panel, and keep the answers",
             [](const LogArguments& given) {
               fmt::print("{}: the identifiers of {} are deleted; their answers stay\n", given.log,
                          counted(forget_identifiers(given.log), "person", "people"));
             });
}

void add_copies(CLI::App& log) {
  add_action(log, "backup", "copy the log as it is now, also while a server writes to it",
             {"new", "the copy"}, [](const LogArguments& given) {
               back_up_log(given.log, given.second);
               fmt::print("{}: a copy of {} as it was at one moment\n", given.second, given.log);
             });
  const auto [recover, arguments] = add_action(
      log, "recover", "save what can be read of a damaged log into a new one, and say what is lost",
      {"new", "the new log"}, [](const LogArguments& given) {
        const LogRecovery recovery = recover_log(given.log, given.second, given.extra);
        fmt::print("{}", recovery_text(recovery, given.log, given.second));
      });
  recover->add_option("--set", arguments->extra, "the set, where the log's own study is lost");
  add_action(log, "upgrade", "make a log of today's schema of one that an older seamline began",
             {"new", "the new log, with every answer"}, [](const LogArguments& given) {
               fmt::print("{}", upgrade_text(upgrade_log(given.log, given.second), given.log, given.second));
             });
}

}  // namespace

void add_log_command(CLI::App& app) {
  CLI::App* log = app.add_subcommand("log", "status, exclude, forget, backup, recover, upgrade of a log");
  log->require_subcommand(1);
  add_people(*log);
  add_panel(*log);
  add_copies(*log);
}

}  // namespace seamline::study
