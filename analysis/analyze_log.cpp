#include "analysis/analyze_log.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "analysis/by_task/log_of_task.h"
#include "analysis/by_task/tasks_page.h"
#include "analysis/log_analysis/analysis.h"
#include "analysis/log_analysis/no_seam.h"
#include "analysis/report/figures/figures.h"
#include "analysis/report/figures/stimulus_samples.h"
#include "analysis/report/json/report_json.h"
#include "analysis/report/json/thresholds_json.h"
#include "analysis/report/matching/match_report.h"
#include "analysis/report/page/methods_text.h"
#include "analysis/report/page/report_html.h"
#include "analysis/report/tables/all_tables.h"
#include "analysis/report/tables/dictionary.h"
#include "analysis/report/tables/late_tables.h"
#include "analysis/report/tables/looking_tables.h"
#include "analysis/report/tables/preregistration_table.h"
#include "analysis/report/tables/still_tables.h"
#include "analysis/report/text/checks_text.h"
#include "analysis/report/text/depth_error_notes.h"
#include "analysis/report/text/numbers_text.h"
#include "analysis/report/text/scenes_text.h"
#include "analysis/report/text/threshold_text.h"
#include "analysis/report_folder.h"
#include "analysis/screening/late_marks.h"
#include "stimuli/definition/methods/analysis_definition.h"
#include "stimuli/definition/parts/task_definition.h"
#include "support/files/atomic_file.h"
#include "support/files/gnuplot.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::analysis {

namespace {

void require_shared_blocks(const std::vector<std::string>& words) {
  for (const std::string& word : words)
    if (shared_block(word) == nullptr)
      throw input_error({.field = request_name("own"),
                         .wanted = "scale, criteria, lapse or guess_ratings",
                         .found = "\"" + word + "\""});
}

/// Published thresholds beside those of the joint model. Throws InputError where they name what is not there.
void lay_beside_published(Analysis& analysis, PublishedThresholds published, const AnalysisRequest& request) {
  for (const PublishedThreshold& one : published.values)
    if (!one.condition.empty() && std::find(analysis.conditions.begin(), analysis.conditions.end(),
                                            one.condition) == analysis.conditions.end())
      throw input_error({.file = request.published,
                         .field = "condition",
                         .wanted = analysis.conditions.empty()
                                       ? "no condition: the study has one"
                                       : fmt::format("one of {}", fmt::join(analysis.conditions, ", ")),
                         .found = one.condition});
  if (!analysis.joint) {
    analysis.notes.emplace_back("Published thresholds are not compared: there is no joint model.");
    return;
  }
  if (!analysis.joint->fit.estimated()) {
    analysis.notes.push_back("Published thresholds are not compared: the joint model has no numbers.");
    return;
  }
  analysis.replication = compare_with_published(*analysis.joint, {.published = std::move(published),
                                                                  .margin = request.published_margin,
                                                                  .replicates = 10000,
                                                                  .seed = request.seed});
}

/// What is made of choices alone.
void require_nothing_of_choices(const AnalysisRequest& request) {
  const std::pair<std::string, bool> options[] = {
      {request_name("exclude_screened"), request.exclude_screened},
      {request_name("exclude_inattentive"), request.exclude_inattentive},
      {request_name("compare"), !request.compare.empty()},
      {request_name("own"), !request.own.empty()},
      {request_name("no_seam_at"), request.no_seam_at.has_value()},
      {request_name("published"), !request.published.empty()},
      {request_name("frozen"), !request.frozen.empty()}};
  for (const auto& [option, is_given] : options)
    if (is_given)
      throw input_error({.field = option,
                         .wanted = "a log of choices or ratings",
                         .found = "one of kind = \"match\", in which people moved the level themselves"});
}

AnalysisSummary analyze_match_log(study::LogContents log, const AnalysisRequest& request) {
  require_nothing_of_choices(request);
  std::vector<ParticipantUse> people = select_participants(log, request.include_pilot);
  for (ParticipantUse& person : people)
    if (request.exclude_uncorrected && person.use == Use::used && has_uncorrected_vision(person.record))
      person.use = Use::vision;
  const MatchAnalysis analysis = analyze_matches(std::move(log), std::move(people));
  return {.frozen = {},
          .table = match_text(analysis),
          .checks = {},
          .sections = {},
          .notes = analysis.notes,
          .report_html = write_match_report(analysis, request.report_folder)};
}

/// The log as it is analysed, and the other one of with and without the marked trials.
struct LogsBeside {
  std::optional<LateMarks> marks;          ///< none where no frames were counted
  std::optional<study::LogContents> rest;  ///< of clips: the log without the marked trials; none: none marked
  [[nodiscard]] bool leaves_out() const { return rest && marks->rule.trials == LateTrials::left_out; }
};

LogsBeside set_marked_aside(const study::LogContents& log) {
  LogsBeside logs{.marks = late_marks(log), .rest = {}};
  if (logs.marks && logs.marks->any()) logs.rest = without_marked(log, *logs.marks);
  return logs;
}

/// The analysis of the other log is for its thresholds alone, so it takes few replicates.
LateReport report_on_late(const study::LogContents& log, const Analysis& analysis, const LogsBeside& logs,
                          const AnalysisOptions& options) {
  LateReport late{.rule = logs.marks->rule, .rows = late_rows(log, analysis, *logs.marks)};
  if (!logs.rest) return late;
  if (analysis.adaptive) {
    late.not_compared = "The next level was placed by every answer, so there are no thresholds without them.";
    return late;
  }
  constexpr int few_replicates = 1000;
  ResamplingRequest resampling = analysis.resampling;
  resampling.replicates = std::min(resampling.replicates, few_replicates);
  try {
    const Analysis other =
        analyze(logs.leaves_out() ? log : *logs.rest, analysis.include_pilot, resampling, options);
    late.thresholds =
        logs.leaves_out() ? thresholds_beside(other, analysis) : thresholds_beside(analysis, other);
  } catch (const InputError&) {
    late.not_compared = "No answers are left without them.";
  }
  return late;
}

AnalysisSummary analyze_one(study::LogContents log, const AnalysisRequest& request);

/// A report for each task, and a page over them.
AnalysisSummary analyze_by_task(const study::LogContents& log, const AnalysisRequest& request) {
  for (const auto& [option, is_given] : {std::pair(request_name("published"), !request.published.empty()),
                                         std::pair(request_name("frozen"), !request.frozen.empty())})
    if (is_given)
      throw input_error({.file = request.log.string(),
                         .field = option,
                         .wanted = "a study that asks one question",
                         .found = "one whose conditions have tasks of their own"});
  prepare_output_folder(request.report_folder);
  AnalysisSummary whole;
  std::vector<TaskReport> reports;
  for (LogOfTask& part : logs_of_tasks(log)) {
    AnalysisRequest asked = request;
    asked.report_folder = request.report_folder / part.name;
    const AnalysisSummary summary = analyze_one(std::move(part.log), asked);
    const std::string heading = part.name + ": " + part.question + "\n";
    whole.table += heading + summary.table + "\n";
    whole.checks += summary.checks.empty() ? "" : heading + summary.checks + "\n";
    whole.sections += summary.sections.empty() ? "" : heading + summary.sections + "\n";
    for (const std::string& note : summary.notes) whole.notes.push_back(part.name + ": " + note);
    reports.push_back({.folder = part.name,
                       .question = part.question,
                       .conditions = part.conditions,
                       .table = summary.table});
  }
  if (reports.empty())
    throw input_error({.file = request.log.string(), .wanted = "answers", .found = "none"});
  whole.report_html = write_tasks_page(request.report_folder, log.study_name, reports);
  return whole;
}

AnalysisSummary analyze_one(study::LogContents log, const AnalysisRequest& request) {
  AnalysisOptions options;
  options.field_of_view_deg = request.field_of_view_deg;
  options.exclude_screened = request.exclude_screened;
  options.exclude_inattentive = request.exclude_inattentive;
  options.exclude_uncorrected = request.exclude_uncorrected;
  options.compare = request.compare;
  options.own = request.own;
  std::optional<Archive> archive;
  std::optional<PublishedThresholds> published;
  if (!request.published.empty()) published = read_published(request.published);
  if (!request.frozen.empty()) archive = read_archive(request.frozen);
  if (facts_of(log.task.get()).adjusts()) return analyze_match_log(std::move(log), request);
  options.displays = study::read_displays(request.log);
  const LogsBeside logs = set_marked_aside(log);
  Analysis analysis =
      analyze(logs.leaves_out() ? *logs.rest : log, request.include_pilot,
              {.replicates = request.bootstrap_replicates, .seed = request.seed, .threads = request.threads},
              options);

  if (!request.own.empty() && !analysis.joint)
    throw input_error({.field = request_name("own"),
                       .wanted = "a study whose [analysis] says model = \"joint\"",
                       .found = "model = \"paper\""});
  if (published) lay_beside_published(analysis, std::move(*published), request);
  if (archive) compare_with_archive(analysis, *archive);
  for (std::string& note : notes_on_depth(analysis.log)) analysis.notes.push_back(std::move(note));
  for (std::string& note : thresholds_as_depth_errors(analysis)) analysis.notes.push_back(std::move(note));
  std::optional<LateReport> late;
  if (logs.marks) {
    late = report_on_late(log, analysis, logs, options);
    analysis.notes.push_back(late_sentence(*late));
  }
  const std::vector<ClipAgainstStill> against_stills = clips_against_stills(analysis);
  for (std::string& note : sentences_of(analysis, against_stills)) analysis.notes.push_back(std::move(note));
  if (request.no_seam_at)
    for (std::string& note : no_seam_sentences(analysis, *request.no_seam_at, *request.no_seam_margin))
      analysis.notes.push_back(std::move(note));

  const ReportNumbers numbers = report_numbers(analysis);
  const std::filesystem::path& folder = request.report_folder;
  const std::filesystem::path figures_folder = folder / "figures";
  prepare_output_folder(folder);
  prepare_output_folder(figures_folder);
  const std::vector<Figure> figures = draw_figures(analysis, numbers, figures_folder);
  const StimulusSamples samples = sample_stimuli(analysis, TemporaryFolder().path());
  const std::vector<LookingRow> looking =
      looking_rows(analysis, study::measured_looks(analysis.log, study::read_looks(analysis.log)));
  std::vector<CsvTable> tables = all_tables(analysis, numbers);
  if (!looking.empty()) tables.push_back(looking_table(analysis, looking));
  if (!against_stills.empty()) tables.push_back(still_table(analysis, against_stills));
  if (late)
    for (CsvTable& table : late_tables(analysis, *late)) tables.push_back(std::move(table));
  const auto write = [&](const std::string& name, const std::string& text) {
    write_file_atomically(folder / name, text, Readers::owner);  // it is what people answered
  };
  for (const CsvTable& table : tables) write(table.name + ".csv", csv_text(table));
  write("data_dictionary.csv", csv_text(report_dictionary(tables, numbers.axis, numbers.conditions)));
  write("thresholds.json", thresholds_json(analysis, numbers.over_scenes));
  const MethodsText methods = methods_text(analysis, numbers, late ? late_method(*late) : "");
  write("report.json", report_json(analysis, methods, tables));
  write("methods.txt", plain_text(methods));
  write("report.html", report_html(analysis, numbers, figures, samples, looking, late));
  std::vector<std::string> notes = analysis.notes;
  for (const std::string& note : notes_on(samples)) notes.push_back(note);
  return {.frozen = frozen_text(analysis),
          .table = table_text(analysis),
          .checks = checks_text(analysis),
          .sections = scenes_text(numbers) + numbers_text(analysis, numbers),
          .notes = std::move(notes),
          .report_html = folder / "report.html"};
}

}  // namespace

AnalysisSummary analyze_log(const AnalysisRequest& request) {
  require_gnuplot();
  if (request.no_seam_at.has_value() != request.no_seam_margin.has_value())
    throw input_error({.field = request.no_seam_at ? request_name("no_seam_at") : request_name("margin"),
                       .wanted = request.no_seam_at
                                     ? request_name("margin") + " beside it: how much counts as none"
                                     : request_name("no_seam_at") + " LEVEL beside it",
                       .found = "it alone"});
  require_shared_blocks(request.own);
  require_report_folder(request.report_folder);
  study::LogContents log = study::read_log(request.log);
  const TemporaryFolder made;
  AnalysisRequest asked = request;
  asked.report_folder = made / "report";
  AnalysisSummary summary =
      log.own_tasks.empty() ? analyze_one(std::move(log), asked) : analyze_by_task(log, asked);
  renew_report(request.report_folder, asked.report_folder);
  summary.report_html = request.report_folder / "report.html";
  return summary;
}

}  // namespace seamline::analysis
