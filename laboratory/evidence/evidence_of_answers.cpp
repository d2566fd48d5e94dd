#include "laboratory/evidence/evidence_page.h"

#include <utility>

namespace seamline::laboratory {

namespace {

/// A quantity's coverage of one way to compute intervals: the mean, and the lowest single curve.
SummaryColumn covers(const std::string& quantity, const std::string& way, const std::string& heading) {
  return {.heading = heading,
          .of = "coverage_percent",
          .where = {{"quantity", quantity}, {"way", way}},
          .shows = Summary::mean_and_lowest,
          .decimals = 1};
}

const RowFilter all_curves_at_once = {{"artifact", "simultaneous"}};

EvidenceTable coverage_by_people() {
  return {.file = "by_people.csv",
          .from = {{"", "true_coverage.csv"}},
          .heading = "people",
          .row_of = {"people"},
          .columns = {covers("PT", "joint", "PT"), covers("SN", "joint", "SN"),
                      covers("PT corrected", "joint", "PT corrected"),
                      covers("SN corrected", "joint", "SN corrected"), covers("PT", "lines", "PT by lines")},
          .where = {{"widths", "paper"}},
          .but_not = all_curves_at_once};
}

EvidenceTable coverage_by_population() {
  EvidenceTable table{.file = "by_population.csv",
                      .from = {{"", "true_coverage.csv"}},
                      .heading = "population, widths",
                      .row_of = {"population", "widths"},
                      .columns = {},
                      .where = {{"way", "joint"}},
                      .but_not = all_curves_at_once};
  for (const char* people : {"5", "10", "20", "40", "80"})
    for (const char* quantity : {"PT", "SN", "PT corrected", "SN corrected"})
      table.columns.push_back({.heading = std::string(quantity) + ", " + people + " people",
                               .of = "coverage_percent",
                               .where = {{"quantity", quantity}, {"people", people}},
                               .shows = Summary::mean,
                               .decimals = 1});
  const RowFilter of_20 = {{"quantity", "PT"}, {"people", "20"}};
  table.columns.push_back({.heading = "length of PT's interval, octaves, 20 people",
                           .of = "median_octaves",
                           .where = of_20,
                           .shows = Summary::mean,
                           .decimals = 2});
  table.columns.push_back({.heading = "error of PT, octaves, 20 people",
                           .of = "rmse_octaves",
                           .where = of_20,
                           .shows = Summary::mean,
                           .decimals = 2});
  return table;
}

/// Studies of 20 people in which nothing differs, that say "differs": over all populations.
EvidenceTable false_alarms() {
  const auto of = [](const char* heading, const char* way, Summary shows) {
    return SummaryColumn{
        .heading = heading, .of = "false_percent", .where = {{"way", way}}, .shows = shows, .decimals = 1};
  };
  return {.file = "false_alarms.csv",
          .from = {{"", "true_sentences.csv"}},
          .heading = "sentence about",
          .row_of = {"family"},
          .columns = {of("joint model, %", "joint", Summary::mean),
                      of("worst population, %", "joint", Summary::highest),
                      of("ordinal model, %", "ordinal", Summary::mean)},
          .where = {{"people", "20"}}};
}

/// As `CoverageTally::print` writes them.
const std::vector<std::string> tally_columns = {
    "population",      "artifact",       "quantity",
    "planted_px",      "covers_percent", "too_high_percent",
    "too_low_percent", "open_percent",   "expanded_percentile_covers_percent"};

}  // namespace

EvidencePage coverage_page() {
  return {.name = "coverage",
          .shows = "how often intervals hold the truth",
          .takes = "67 minutes",
          .needs = tests_needed,
          .steps = {{"lines",
                     "SEAMLINE_TRUE_STUDIES=2000 tests/analysis_full_tests "
                     "--gtest_filter=TrueCoverage.OfThePapersWay",
                     Printed::progress},
                    {"joint",
                     "SEAMLINE_TRUE_STUDIES=2000 tests/analysis_full_tests "
                     "--gtest_filter=TrueCoverage.OfTheJointModel",
                     Printed::progress},
                    {"false_alarms",
                     "SEAMLINE_TRUE_STUDIES=300 tests/analysis_full_tests "
                     "--gtest_filter=TrueCoverage.FalseSentencesOfBothModels",
                     Printed::progress},
                    {"halves",
                     "SEAMLINE_TRUE_STUDIES=200 tests/analysis_full_tests "
                     "--gtest_filter=TrueCoverage.OfTheHalvesOfTheSession",
                     Printed::progress},
                    {"tasks", "tests/analysis_full_tests --gtest_filter=TaskCoverage.*"},
                    {"over_scenes",
                     "SEAMLINE_TRUE_STUDIES=400 tests/analysis_full_tests "
                     "--gtest_filter=OverScenesCoverage.*"},
                    {"papers_way", "tests/analysis_full_tests --gtest_filter=Coverage.Of*"}},
          .small_steps = {{"small", "tests/analysis_quick_tests --gtest_filter=SmallCoverage.*",
                           Printed::progress}},
          .shown = {"true_coverage.csv", "true_sentences.csv", "halves.csv"},
          .figures = {{"true_coverage.csv", "intervals of 95 %, all populations, widths, artifacts",
                       MeanCurves{.x = "people",
                                  .y = "coverage_percent",
                                  .curve = "way",
                                  .x_label = "people of a study",
                                  .y_label = "studies whose interval holds the truth, %"}}},
          .printed = {{.file = "tasks.csv",
                       .step = "tasks",
                       .columns = {"task", "people", "curves", "holds_percent", "with_number_percent",
                                   "error_octaves"}},
                      {.file = "over_scenes.csv",
                       .step = "over_scenes",
                       .columns = {"form", "between", "people", "scenes", "quantity", "studies", "found",
                                   "like_these", "these", "length", "between_found"}},
                      {.file = "lines.csv", .step = "papers_way", .columns = tally_columns}},
          .tables = {coverage_by_people(),
                     coverage_by_population(),
                     {.file = "by_task.csv",
                      .from = {{"", "tasks.csv"}},
                      .heading = "task",
                      .row_of = {"task"},
                      .columns = {{.heading = "people", .of = "people"},
                                  {.heading = "intervals that hold, %", .of = "holds_percent"},
                                  {.heading = "error, octaves", .of = "error_octaves"}}},
                     false_alarms()}};
}

EvidencePage replication_page() {
  const auto mean = [](const char* heading, const char* column, int decimals) {
    return SummaryColumn{.heading = heading, .of = column, .shows = Summary::mean, .decimals = decimals};
  };
  return {
      .name = "replication",
      .shows = "how often studies are said to agree with published values, and to differ",
      .takes = "1 minute",
      .needs = tests_needed,
      .steps = {{"planted",
                 "SEAMLINE_TRUE_STUDIES=200 tests/analysis_full_tests "
                 "--gtest_filter=PlantedReplications.*",
                 Printed::progress}},
      .small_steps = {{"small", "tests/analysis_quick_tests --gtest_filter=SmallReplication.*",
                       Printed::progress}},
      .shown = {"replication.csv", "replication_orders.csv"},
      .tables = {
          {.file = "by_distance.csv",
           .from = {{"", "replication.csv"}},
           .heading = "octaves away",
           .row_of = {"moved_octaves"},
           .columns = {mean("agrees, %", "agrees_percent", 1), mean("so promised, %", "promised_agrees", 1),
                       mean("differs, %", "differs_percent", 1), mean("promised, %", "promised_differs", 1),
                       mean("no number, %", "no_number_percent", 1)},
           .where = {{"published", "exact"}}}}};
}

namespace {

EvidenceTable log_scores_of_real_people() {
  EvidenceTable table{.file = "log_scores.csv",
                      .from = {{"", "real_people.csv"}},
                      .heading = "fitted to",
                      .row_of = {"fitted to"},
                      .columns = {}};
  for (const char* way : {"joint model", "straight lines", "ordinal model"})
    table.columns.push_back({.heading = way, .of = "log score", .where = {{"by", way}}});
  return table;
}

/// Of the four curves of a study: lowest and highest coverage, by what curves share.
EvidenceTable coverage_of_shared_curves() {
  EvidenceTable table{.file = "sharing.csv",
                      .from = {{"", "sharing_coverage.csv"}},
                      .heading = "curves differ in",
                      .row_of = {"curves_differ_in"},
                      .columns = {{.heading = "freed, %",
                                   .of = "freed_percent",
                                   .where = {{"way", "tested"}},
                                   .shows = Summary::highest}}};
  for (const auto& [way, heading] :
       {std::pair{"shared", "all shared"}, std::pair{"tested", "tested"}, std::pair{"own", "nothing shared"}})
    for (const char* quantity : {"PT", "SN corrected"})
      table.columns.push_back({.heading = std::string(heading) + ": " + quantity,
                               .of = "coverage_percent",
                               .where = {{"way", way}, {"quantity", quantity}},
                               .shows = Summary::range});
  return table;
}

}  // namespace

EvidencePage joint_model_page() {
  return {.name = "joint_model_checks",
          .shows = "the joint model on real people, and where curves differ",
          .takes = "5 minutes",
          .needs = tests_needed,
          .steps = {{"sharing",
                     "SEAMLINE_TRUE_STUDIES=1000 tests/analysis_full_tests --gtest_filter=SharingCoverage.*",
                     Printed::progress},
                    {"real_people", "tests/analysis_quick_tests --gtest_filter=RealPeople.*:JointMaxima.*"}},
          .small_steps = {{"real_people",
                           "tests/analysis_quick_tests --gtest_filter=RealPeople.*:JointMaxima.*"}},
          .shown = {"sharing_coverage.csv"},
          .printed = {{.file = "real_people.csv",
                       .step = "real_people",
                       .columns = {"fitted to", "by", "log score", "error of noticeability",
                                   "error of right answers"}}},
          .tables = {log_scores_of_real_people(), coverage_of_shared_curves()}};
}

namespace {

/// "95.3 to 95.9" of the rows of a group of sets.
SummaryColumn range_of(const std::string& heading, const std::string& column, int decimals) {
  return {.heading = heading, .of = column, .shows = Summary::range, .decimals = decimals};
}

EvidenceTable fit_intervals_by_place() {
  return {.file = "fit_intervals_by_place.csv",
          .from = {{"", "fit_intervals.csv"}},
          .heading = "planted threshold",
          .row_of = {"sets"},
          .columns = {range_of("profile interval holds it, %", "profile_covers_percent", 1),
                      range_of("bootstrap (BCa) holds it, %", "bootstrap_covers_percent", 1),
                      range_of("profile interval is closed, %", "closed_percent", 0),
                      range_of("fits that are a step, %", "step_percent", 0)},
          .to_comma = true};
}

EvidenceTable false_alarms_of_ordinal_models() {
  return {.file = "ordinal_by_question.csv",
          .from = {{"", "ordinal_false_alarms.csv"}},
          .heading = "people differ in, question",
          .row_of = {"participants_differ_in", "question"},
          .columns = {{.heading = "Seamline: one", .of = "jackknife_one"},
                      {.heading = "Seamline: any", .of = "jackknife_any"},
                      {.heading = "model's own errors: one", .of = "likelihood_one"},
                      {.heading = "model's own errors: any", .of = "likelihood_any"}}};
}

EvidenceTable screening_by_design() {
  return {.file = "screening_by_design.csv",
          .from = {{"", "screening_designs.csv"}},
          .heading = "design",
          .row_of = {"study"},
          .columns = {range_of("correlation judges in, % of studies", "correlation_judges_percent", 0),
                      range_of("good people it would name unjudged, %", "unjudged_named_percent", 1),
                      range_of("good people named, %", "good_named_percent", 2),
                      range_of("random raters named, %", "random_named_percent", 0)}};
}

}  // namespace

EvidencePage statistics_page() {
  const auto step = [](const char* name, const char* filter) {
    return EvidenceStep{name, std::string("tests/analysis_full_tests --gtest_filter=") + filter};
  };
  return {
      .name = "statistics",
      .shows = "fits, groups, comparisons, screening",
      .takes = "10 minutes",
      .needs = tests_needed,
      .steps = {step("fit_intervals", "PsychometricSimulated.*"),
                step("fit_groups", "PsychometricCoverage.*"),
                step("guess_correction", "GuessCorrectionCoverage.*"),
                step("ordinal_false_alarms", "OrdinalStudyFull.*"),
                step("screening_people", "ScreeningRates.*:-*Designs"),
                step("screening_designs", "ScreeningRates.*Designs")},
      .small_steps = {{"recovery", "tests/analysis_quick_tests --gtest_filter=PsychometricSciPy.*"}},
      .printed = {{.file = "fit_intervals.csv",
                   .step = "fit_intervals",
                   .columns = {"sets", "number", "step_percent", "closed_percent", "profile_covers_percent",
                               "profile_too_high_percent", "profile_too_low_percent", "profile_length_gaps",
                               "bootstrap_covers_percent", "bootstrap_too_high_percent",
                               "bootstrap_too_low_percent", "bootstrap_length_gaps", "profile_ms",
                               "bootstrap_ms", "contradictions"},
                   .last_of_a_name = true},
                  {.file = "fit_groups.csv",
                   .step = "fit_groups",
                   .columns = {"group", "planted_px", "covers_percent", "too_high_percent", "too_low_percent",
                               "length_octaves", "open", "jackknife_t_covers_percent",
                               "plain_profile_covers_percent", "mean_c", "step_fits"}},
                  {.file = "guess_correction.csv", .step = "guess_correction", .columns = tally_columns},
                  {.file = "ordinal_false_alarms.csv",
                   .step = "ordinal_false_alarms",
                   .columns = {"participants_differ_in", "question", "jackknife_one", "jackknife_any",
                               "likelihood_one", "likelihood_any"}},
                  {.file = "screening_people.csv",
                   .step = "screening_people",
                   .columns = {"population", "participants", "number", "kurtosis_percent",
                               "correlation_percent", "below_p913_percent"}},
                  {.file = "screening_designs.csv",
                   .step = "screening_designs",
                   .columns = {"study", "random_raters", "correlation_judges_percent",
                               "unjudged_named_percent", "good_named_percent", "random_named_percent"}}},
      .tables = {fit_intervals_by_place(), false_alarms_of_ordinal_models(), screening_by_design()}};
}

}  // namespace seamline::laboratory
