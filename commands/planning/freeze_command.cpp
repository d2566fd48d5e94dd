#include "commands/planning/planning_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <sstream>

#include "analysis/foresight/plan_text.h"
#include "analysis/preregistration/freeze.h"
#include "analysis/preregistration/replication_kit.h"
#include "analysis/replication/published_text.h"
#include "commands/options/command_help.h"
#include "commands/planning/plan_options.h"
#include "support/files/atomic_file.h"
#include "support/files/held/written_files.h"
#include "support/text/counted.h"
#include "support/text/error.h"
#include "support/text/number_option.h"
#include "support/text/printable.h"

namespace seamline::analysis {
namespace {

struct FreezeOptions {
  std::string study, out, why, thresholds = "PT,SN", published, kit;
  double published_margin = 0.5;
  std::vector<std::string> sets;
  FrozenAnalysis analysis = {.thresholds = {}, .rules = {}, .by_hand = {}};
  std::optional<int> participants;
  PlanOptions plan;
};

std::vector<std::string> pieces_of(const std::string& text, char between) {
  std::vector<std::string> pieces;
  std::istringstream stream(text);
  for (std::string piece; std::getline(stream, piece, between);) pieces.push_back(piece);
  return pieces;
}

/// How many people `seamline plan` asks for, and its own words why.
void add_planned_number(Preregistration& content, const FreezeOptions& options) {
  PlanRequest request = plan_request(options.plan);
  request.study_file = options.study;
  if (!options.sets.empty()) request.idle = IdleSettings::kept;
  const StudyPlan plan = plan_study(request);
  const std::optional<DesignRow> design = fewest_participants(plan, 0);  // of the study's own levels
  if (!design)
    throw input_error(
        {.file = options.study,
         .wanted = fmt::format("a number of participants with which, for the study's levels, {}; or "
                               "--participants N --why TEXT",
                               wish_text(plan)),
         .found = "none among those that seamline plan tries"});
  content.participants = design->participants;
  content.why_so_many = fmt::format(
      "The fewest tried with which {}, of every threshold that lies within the study's levels. {}",
      wish_text(plan), plan.assumptions);
  content.plan = pieces_of(plan_text(plan), '\n');
}

void require_kit(const FreezeOptions& options) {
  if (options.sets.empty())
    throw input_error({.field = "--kit",
                       .wanted = "a set beside the study: it says how many trials a participant has",
                       .found = "none"});
  require_apart(std::vector<OptionFile>{{"--out", options.out}, {"--kit", options.kit}});
  if (std::filesystem::exists(std::filesystem::symlink_status(options.kit)))
    throw input_error(
        {.file = options.kit, .field = "--kit", .wanted = "a folder that is not there yet", .found = "one"});
}

void freeze(const FreezeOptions& options) {
  namespace fs = std::filesystem;
  if (fs::exists(fs::symlink_status(options.out)))
    throw input_error({.file = options.out,
                       .wanted = "a file that is not there yet (what is frozen is never written again)",
                       .found = "one"});
  if (!options.kit.empty()) require_kit(options);
  if (options.participants && options.why.empty())
    throw input_error({.field = "--participants", .wanted = "--why TEXT beside it", .found = "no reason"});
  if (!is_utf8(options.why)) throw input_error({.field = "--why", .wanted = "UTF-8", .found = "other bytes"});
  FrozenAnalysis analysis = options.analysis;
  analysis.thresholds = pieces_of(options.thresholds, ',');
  Preregistration content =
      freeze_study(options.study, std::vector<fs::path>(options.sets.begin(), options.sets.end()), analysis);
  if (!options.published.empty())
    content.analysis.rules.push_back(
        rule_of_published(read_published(options.published).values, options.published_margin));
  if (options.participants) {
    content.participants = *options.participants;
    content.why_so_many = options.why;
  } else {
    add_planned_number(content, options);
  }
  write_file_atomically(options.out, archive_text(content));
  fmt::print(
      "{}: study {}, {}, {}\nSHA-256 {}\nKeep the file as it is, and publish it "
      "or this hash where a date is put to it, before anybody is asked.\n",
      options.out, printable(content.study_name), counted(content.sets.size(), "stimulus set"),
      counted(content.participants, "participant"), read_archive(options.out).sha256);
  if (options.kit.empty()) return;
  write_replication_kit({.folder = options.kit,
                         .archive = options.out,
                         .set = options.sets.front(),
                         .published = options.published,
                         .published_margin = options.published_margin});
  fmt::print("{}: all that a laboratory needs that repeats the study; begin with its README.md\n",
             options.kit);
}

}  // namespace

void add_freeze_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("freeze", "a preregistration, before anyone is asked");
  const auto options = std::make_shared<FreezeOptions>();
  FrozenAnalysis& analysis = options->analysis;
  command->add_option("study", options->study, "the study file")->required();
  command->add_option("sets", options->sets, "folders of the sets rendered from it");
  command->add_option("--out", options->out, "the archive, ARCHIVE.json; must not be there yet")->required();
  command
      ->add_option("--thresholds", options->thresholds,
                   "the confirmatory ones of PT, SN, PT corrected, SN corrected, IP and detection, with "
                   "commas; all else explores")
      ->capture_default_str();
  command->add_flag("--exclude-screened", analysis.exclude_screened,
                    "analyze will leave out the participants whom a screen names");
  command->add_flag("--exclude-inattentive", analysis.exclude_inattentive,
                    "analyze will leave out the participants whom catch trials name");
  command->add_flag("--exclude-uncorrected", analysis.exclude_uncorrected,
                    "analyze will leave out the participants whose vision is neither normal nor corrected");
  command->add_flag("--include-pilot", analysis.include_pilot, "analyze will use pilot data as well");
  command->add_option("--compare", analysis.compare, "groups that analyze will compare, as its --compare");
  command->add_option("--by-hand", analysis.by_hand,
                      "whom people will exclude in the log, in words (else nobody may be)");
  CLI::Option* published = command->add_option(
      "--published", options->published,
      "published thresholds that analyze will compare with, as its --published: a CSV file, or \"paper\"");
  add_number(*command, "--published-margin", options->published_margin, {0.001, 100}, "of analyze")
      ->needs(published)
      ->capture_default_str();
  command->add_option(
      "--kit", options->kit,
      "also write a folder for a laboratory that repeats the study: steps, study file, archive, "
      "consent to fill in");
  add_number(*command, "--bootstrap", analysis.bootstrap_replicates, {100, 1000000}, "of analyze")
      ->capture_default_str();
  add_number(*command, "--seed", analysis.seed, any_seed, "of analyze")->capture_default_str();
  add_number(*command, "--field-of-view", analysis.field_of_view_deg, {1, 179, "degrees"}, "of analyze")
      ->capture_default_str();
  CLI::Option* participants = add_number(*command, "--participants", options->participants, {2, 1000000},
                                         "how many will be used (else as many as seamline plan asks for)");
  command->add_option("--why", options->why, "why so many, in words")->needs(participants);
  for (CLI::Option* option : add_plan_options(*command, options->plan))
    option->excludes(participants)->group("As seamline plan");
  group_options(*command, {});
  command->callback([options] { freeze(*options); });
}

}  // namespace seamline::analysis
