#include "commands/study/study_commands.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "analysis/analyze_log.h"
#include "support/text/number_option.h"

namespace seamline::analysis {

namespace {

void run_analyze(const AnalysisRequest& request) {
  const AnalysisSummary summary = analyze_log(request);
  std::printf("%s%s\n%s\n%s", summary.frozen.c_str(), summary.table.c_str(), summary.checks.c_str(),
              summary.sections.c_str());
  for (const std::string& note : summary.notes) std::printf("Note: %s\n", note.c_str());
  std::printf("Report: %s\n", summary.report_html.c_str());
}

}  // namespace

void add_analyze_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("analyze", "thresholds, figures and a report from a log of answers");
  command->alias("analyse");
  const auto request = std::make_shared<AnalysisRequest>();
  command->add_option("log", request->log, "the log, LOG.sqlite")->required();
  command->add_option("--out", request->report_folder, "folder of the report; made when missing")->required();
  add_number(*command, "--bootstrap", request->bootstrap_replicates, {100, 1000000}, "bootstrap replicates")
      ->capture_default_str();
  add_number(*command, "--seed", request->seed, any_seed, "seed of the bootstrap")->capture_default_str();
  command->add_flag("--include-pilot", request->include_pilot, "use pilot data as well");
  add_number(*command, "--field-of-view", request->field_of_view_deg, {1, 179, "degrees"},
             "horizontal field of view for which thresholds are also stated")
      ->capture_default_str();
  command->add_flag("--exclude-screened", request->exclude_screened,
                    "leave out the participants whom a screen names (else they are named and used)");
  command->add_flag("--exclude-inattentive", request->exclude_inattentive,
                    "leave out the participants whom catch trials name");
  command->add_flag("--exclude-uncorrected", request->exclude_uncorrected,
                    "leave out the participants whose vision is neither normal nor corrected");
  command->add_option("--compare", request->compare,
                      "groups of people whose thresholds are compared: a question of the form, with bands "
                      "(age=30,45) or split at the median, or origin; may be given several times");
  command
      ->add_option("--own", request->own,
                   "what each curve of the joint model has of its own whatever the tests say, with commas: "
                   "scale, criteria, lapse, guess_ratings")
      ->delimiter(',');
  add_number(*command, "--no-seam-at", request->no_seam_at, {0, 1e9},
             "equivalence: whether no seam is seen at this level, by two one-sided tests");
  add_number(*command, "--margin", request->no_seam_margin, {0.001, 4},
             "noticeability, corrected for guessing, that counts as none (with --no-seam-at)");
  CLI::Option* published = command->add_option(
      "--published", request->published,
      "published thresholds to compare with: a CSV file (artifact, quantity, value; condition, low, high, n, "
      "source where known), or paper: Table 1");
  add_number(*command, "--published-margin", request->published_margin, {0.001, 100},
             "difference within which a threshold agrees with a published one: octaves, or the level's unit")
      ->capture_default_str()
      ->needs(published);
  command->add_option("--frozen", request->frozen,
                      "an archive of seamline freeze: says what deviates from it");
  command->callback([request] { run_analyze(*request); });
}

}  // namespace seamline::analysis
