#include "commands/planning/plan_options.h"

#include <CLI/CLI.hpp>
#include <array>
#include <set>

#include "commands/options/setting_option.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::analysis {
namespace {

/// What is assumed of people besides the study file's [observer].
std::vector<CLI::Option*> add_assumptions(CLI::App& command, AssumedPeople& assumed) {
  return {add_number(command, "--lapses", assumed.lapse, {0, 0.5},
                     "assumed: share of the trials in which a person does not look")
              ->capture_default_str(),
          add_number(command, "--slope-sd", assumed.slope_sd, {0, 1.5},
                     "assumed: how the slopes of people differ, standard deviation of ln scale")
              ->capture_default_str(),
          add_number(command, "--criteria-sd", assumed.criteria_sd, {0, 1000},
                     "assumed: how the rating curves of people differ from their seeing curves, standard "
                     "deviation in octaves (or the level's unit)")
              ->capture_default_str(),
          add_number(command, "--artifact-sd", assumed.artifact_sd, {0, 1000},
                     "assumed: shift of each person for each curve, standard deviation likewise")
              ->capture_default_str(),
          add_number(command, "--high-guesses", assumed.high_guesses, {0, 1},
                     "assumed: share of the guesses rated 2 instead of 1")
              ->capture_default_str(),
          add_number(command, "--false-alarms", assumed.false_alarms, {0, 0.9},
                     "assumed, of tasks yes_no (0.1) and rating (0): how often people who see nothing answer "
                     "that they do")};
}

std::vector<CLI::Option*> add_wanted(CLI::App& command, WantedTargets& wanted) {
  return {
      command
          .add_option(
              "--quantities", wanted.quantities,
              "what is wanted: PT, SN, corrected-PT, corrected-SN, detection, with commas (PT,SN; without "
              "ratings: detection)")
          ->delimiter(','),
      command.add_option("--artifacts", wanted.artifacts, "of these artifacts, with commas (all)")
          ->delimiter(','),
      command.add_option("--conditions", wanted.conditions, "in these conditions, with commas (all)")
          ->delimiter(','),
      command
          .add_option("--difference", wanted.differences,
                      "A:B, two artifacts or conditions: the difference of their thresholds, B less A")
          ->delimiter(','),
      command.add_flag("--differences-alone", wanted.differences_alone,
                       "only the differences of --difference are wanted"),
      add_number(command, "--stated-difference", wanted.stated_difference, {-1000, 1000},
                 "power for this difference, in octaves (or the level's unit), whatever [observer] says")};
}

}  // namespace

std::vector<CLI::Option*> add_plan_options(CLI::App& command, PlanOptions& options) {
  PlanRequest& request = options.request;
  std::vector<CLI::Option*> added = add_wanted(command, request.wanted);
  for (CLI::Option* option : add_assumptions(command, request.assumed)) added.push_back(option);
  const std::vector<CLI::Option*> others = {
      command
          .add_option("--estimator", options.estimator, "which analysis is foreseen: joint or straight-lines")
          ->check(
              CLI::IsMember(option_words(std::array{PlanEstimator::joint, PlanEstimator::straight_lines})))
          ->capture_default_str(),
      add_number(command, "--wanted-octaves", request.wanted_length, {0.01, 1000},
                 "length of the 95 % intervals (on linear axes in the level's unit)")
          ->capture_default_str(),
      add_number(
          command, "--scene-sd", request.between_scenes, {0, 1000},
          "assumed: how the thresholds of scenes differ, standard deviation in octaves (or the level's "
          "unit); also says what 1, 3, 5 and 10 scenes can claim")
          ->capture_default_str(),
      add_number(command, "--assurance", request.assurance, {0.01, 0.999},
                 "chance that all intervals are at most so long")
          ->capture_default_str(),
      add_number(command, "--equal-within", request.equal_within, {0.001, 1000},
                 "equivalence: the difference counts as none within so much, same unit"),
      add_number(command, "--no-seam-at", options.no_seam_at, {0, 1e9},
                 "equivalence: at this level no seam is seen"),
      add_number(command, "--margin", options.no_seam_margin, {0.001, 4},
                 "noticeability, corrected for guessing, that counts as none (with --no-seam-at)"),
      add_number(command, "--studies", request.studies, {1, 1000000},
                 "simulated studies for each set of levels")
          ->capture_default_str(),
      add_number(command, "--threads", request.threads, {0, 1024}, "0: as many as the machine has")
          ->capture_default_str()};
  added.insert(added.end(), others.begin(), others.end());
  return added;
}

PlanRequest plan_request(const PlanOptions& options) {
  PlanRequest request = options.request;
  request.estimator = plan_estimator_from_word(options.estimator).value_or(PlanEstimator::joint);
  const std::set<int> sorted(request.participants.begin(), request.participants.end());
  request.participants.assign(sorted.begin(), sorted.end());
  if (options.no_seam_at.has_value() != options.no_seam_margin.has_value())
    throw input_error({.field = options.no_seam_at ? "--no-seam-at" : "--margin",
                       .wanted = options.no_seam_at ? "--margin beside it: how much counts as none"
                                                    : "--no-seam-at LEVEL beside it",
                       .found = "it alone"});
  if (options.no_seam_at)
    request.no_seam = NoSeamClaim{.level = *options.no_seam_at, .margin = *options.no_seam_margin};
  return request;
}

}  // namespace seamline::analysis
