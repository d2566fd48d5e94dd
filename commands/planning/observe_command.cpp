#include "commands/planning/planning_commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/detection/detection_comparison.h"
#include "analysis/detection/pair_fit.h"
#include "analysis/detection/standard_observer.h"
#include "support/files/held/prepared_folder.h"
#include "support/files/image.h"
#include "support/files/markdown_table.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::analysis {
namespace {

/// A source's patterns and what several observers say of them.
struct DetectionTable {
  const DetectionThresholds* thresholds = nullptr;
  std::vector<MeasureFit> fits;         ///< the image observer first, then the other measures
  std::vector<double> standard_db;      ///< of Watson and Ahumada's standard observer; empty: not asked
  bool criterion_from_outside = false;  ///< the first fit's criterion was fitted to another source
};

std::string decibels(double value) {
  return fmt::format("{:.1f}", value);
}

CsvTable pattern_table(const DetectionTable& table) {
  CsvTable out{.name = "patterns",
               .columns = {{"", "", ""},
                           {"pattern", "", ""},
                           {"luminance", "cd/m2", ""},
                           {"people", "dB", ""},
                           {"sd", "dB", ""}},
               .rows = {}};
  if (!table.standard_db.empty()) out.columns.push_back({"standard observer", "dB", ""});
  out.columns.push_back({"image observer", "dB", ""});
  out.columns.push_back({"less people", "dB", ""});
  for (std::size_t i = 0; i < table.thresholds->patterns.size(); ++i) {
    const DetectionPattern& pattern = table.thresholds->patterns[i];
    const double predicted = table.fits.front().predicted_db[i];
    std::string name(pattern.name);
    if (name == "Gabor")
      name = fmt::format("Gabor {:g} c/deg, sd {:g} deg", pattern.frequency_cpd, pattern.sigma_x_deg);
    if (name == "disc") name = fmt::format("disc, radius {:.2g} deg", pattern.sigma_x_deg);
    std::vector<CsvValue> row{
        std::int64_t{pattern.number}, name, pattern.mean_luminance_cdm2, decibels(pattern.threshold_db),
        pattern.people_sd_db > 0 ? CsvValue(decibels(pattern.people_sd_db)) : CsvValue()};
    if (!table.standard_db.empty()) row.emplace_back(decibels(table.standard_db[i]));
    row.emplace_back(decibels(predicted));
    row.emplace_back(fmt::format("{:+.1f}", predicted - pattern.threshold_db));
    out.rows.push_back(std::move(row));
  }
  return out;
}

double standard_rms_db(const DetectionTable& table) {
  double sum = 0;
  for (std::size_t i = 0; i < table.standard_db.size(); ++i)
    sum += std::pow(table.standard_db[i] - table.thresholds->patterns[i].threshold_db, 2);
  return std::sqrt(sum / table.standard_db.size());
}

CsvTable error_table(const DetectionTable& table) {
  CsvTable out{.name = "errors",
               .columns = {{"measure", "", ""},
                           {"at threshold", "", ""},
                           {"rms error", "dB", ""},
                           {"on the half not fitted", "dB", ""}},
               .rows = {}};
  if (!table.standard_db.empty())
    out.rows.push_back({std::string("standard observer (Watson and Ahumada 2005)"), CsvValue(),
                        decibels(standard_rms_db(table)), CsvValue()});
  for (const MeasureFit& fit : table.fits) {
    const bool fitted = fit.rms_error_other_half_db > 0;
    out.rows.push_back({title(fit.measure) + (fitted ? "" : ", as ModelFest has it"), fit.criterion,
                        decibels(fit.rms_error_db),
                        fitted ? CsvValue(decibels(fit.rms_error_other_half_db)) : CsvValue()});
  }
  return out;
}

/// The patterns that the image observer misjudges most, at most five, beyond 4 dB (a factor of 1.6).
std::string worst_patterns(const DetectionTable& table) {
  const MeasureFit& fit = table.fits.front();
  std::vector<std::pair<double, std::size_t>> errors;
  for (std::size_t i = 0; i < fit.predicted_db.size(); ++i)
    errors.emplace_back(-std::abs(fit.predicted_db[i] - table.thresholds->patterns[i].threshold_db), i);
  std::sort(errors.begin(), errors.end());
  std::string text;
  for (std::size_t rank = 0; rank < errors.size() && rank < 5 && errors[rank].first < -4; ++rank)
    text +=
        (text.empty() ? "" : ", ") + std::to_string(table.thresholds->patterns[errors[rank].second].number);
  return text;
}

CsvTable judged_table(const PairJudgement& judgement) {
  CsvTable out{.name = "judged",
               .columns = {{"measure", "", ""},
                           {"gain", "", ""},
                           {"scale", "octaves", ""},
                           {"log2 likelihood of a look", "bits", ""},
                           {"ROC area", "", ""}},
               .rows = {}};
  std::vector<JudgedModel> models = {judgement.observer};
  models.insert(models.end(), judgement.others.begin(), judgement.others.end());
  for (std::size_t i = 0; i < models.size(); ++i)
    out.rows.push_back({title(models[i].model.measure) + (i == 0 ? " (fits best)" : ""), models[i].model.gain,
                        models[i].model.scale_octaves, models[i].judged_bits, models[i].roc_area});
  return out;
}

CsvTable calibration_table(const JudgedModel& model) {
  CsvTable out{.name = "calibration",
               .columns = {{"predicted", "share", ""}, {"seen", "share", ""}, {"looks", "", ""}},
               .rows = {}};
  for (const CalibrationGroup& group : model.calibration)
    out.rows.push_back({group.predicted, group.seen, std::int64_t{group.looks}});
  return out;
}

/// For a terminal: thresholds of people and observers pattern after pattern, root mean square errors, and
/// where the image observer fails.
std::string detection_text(const DetectionTable& table) {
  const DetectionThresholds& thresholds = *table.thresholds;
  std::string text = fmt::format(
      "# {}\n\n{}. {}.\nThresholds are -20 log10 of the contrast: 6 dB more is "
      "half the contrast. The mean luminance is half of display white.\n\n",
      thresholds.name, thresholds.source, thresholds.people);
  text += markdown_table(pattern_table(table)) + "\n" + markdown_table(error_table(table)) + "\n";
  if (const std::string worst = worst_patterns(table); !worst.empty())
    text += "The image observer fails most at patterns " + worst + ".\n";
  if (table.criterion_from_outside)
    text += "Nothing was fitted to these people: the image observer's line has ModelFest's value.\n";
  return text + "\n";
}

/// For a terminal: what was fitted, and how it does on the other half beside simpler measures.
std::string pairs_text(const PairJudgement& judgement) {
  std::string text = fmt::format(
      "Fitted to {} pairs, judged on {} others ({}).\n\n", judgement.fitted_pairs, judgement.judged_pairs,
      judgement.split_by_reference
          ? fmt::format("no one of the {} references is in both halves", judgement.references)
          : "every second pair; references are in both halves, because there are fewer than four");
  text += "On the half not fitted:\n\n" + markdown_table(judged_table(judgement)) + "\n";
  text += fmt::format("Who predicts the share seen in the first half everywhere has {:.3f} bits.\n\n",
                      judgement.constant_bits);
  text +=
      fmt::format("Calibration of {}, on the half not fitted:\n\n", title(judgement.observer.model.measure));
  text += markdown_table(calibration_table(judgement.observer)) + "\n";
  const SeenModel& at_3 = judgement.others.front().model;
  text += fmt::format(
      "For predictions with these eyes: --gain {:.4g}, and scale_octaves = {:.3g} in [observer].\n",
      at_3.gain, at_3.scale_octaves);
  return text;
}

struct ObserveOptions {
  std::string pairs, pictures_folder;
  int threads = 0;
};

std::vector<double> standard_thresholds_db(const DetectionThresholds& thresholds) {
  std::vector<double> predicted_db;
  for (const DetectionPattern& pattern : thresholds.patterns)
    predicted_db.push_back(
        standard_observer_threshold_db(pattern_contrast(pattern), pattern.pixels_per_degree));
  return predicted_db;
}

DetectionTable modelfest_table(int threads) {
  DetectionTable table{.thresholds = &modelfest_thresholds(), .fits = {}, .standard_db = {}};
  const std::vector<PatternResponse> responses = pattern_responses(*table.thresholds, threads);
  table.fits.push_back(fit_measure(*table.thresholds, responses, DifferenceMeasure::pooled_3));
  for (std::size_t place = 0; place < difference_measure_count; ++place)
    if (difference_measure(place) != DifferenceMeasure::pooled_3)
      table.fits.push_back(fit_measure(*table.thresholds, responses, difference_measure(place)));
  table.standard_db = standard_thresholds_db(*table.thresholds);
  return table;
}

/// Of people to whom nothing was fitted: the image observer's value is ModelFest's.
DetectionTable other_table(const DetectionThresholds& thresholds, int threads) {
  DetectionTable table{
      .thresholds = &thresholds, .fits = {}, .standard_db = {}, .criterion_from_outside = true};
  const std::vector<PatternResponse> responses = pattern_responses(*table.thresholds, threads);
  table.fits = {
      judge_measure(*table.thresholds, responses, DifferenceMeasure::pooled_3, detection_visible_difference),
      fit_measure(*table.thresholds, responses, DifferenceMeasure::pooled_3),
      fit_measure(*table.thresholds, responses, DifferenceMeasure::mean_flip),
      fit_measure(*table.thresholds, responses, DifferenceMeasure::largest_flip),
      fit_measure(*table.thresholds, responses, DifferenceMeasure::root_mean_square)};
  return table;
}

std::filesystem::path pattern_file(const std::filesystem::path& folder, const DetectionPattern& pattern) {
  return folder / fmt::format("{:02}.png", pattern.number);
}

/// Pictures of the folder may be somebody's stimuli: a file that is there already is nobody's to replace.
void require_free_names(const std::filesystem::path& folder) {
  for (const DetectionPattern& pattern : modelfest_thresholds().patterns) {
    const std::filesystem::path file = pattern_file(folder, pattern);
    if (std::filesystem::exists(std::filesystem::symlink_status(file)))
      throw input_error({.file = file.string(),
                         .field = "--pictures",
                         .wanted = "a folder without files of the patterns' names, which would be lost",
                         .found = "one with " + file.filename().string()});
  }
}

void write_patterns(const std::filesystem::path& folder) {
  for (const DetectionPattern& pattern : modelfest_thresholds().patterns)
    write_png(pattern_file(folder, pattern), display_image(pattern_picture(pattern_contrast(pattern), 1)));
}

void observe(const ObserveOptions& options) {
  std::optional<PreparedFolder> prepared;
  if (!options.pictures_folder.empty()) {
    require_free_names(options.pictures_folder);
    prepared.emplace(options.pictures_folder);
  }
  std::optional<PairJudgement> judgement;
  if (!options.pairs.empty()) {
    const std::vector<SeenPair> pairs = read_seen_pairs(options.pairs);
    judgement = judge_pairs(pairs, measure_pairs(pairs, options.threads));
  }
  if (prepared) write_patterns(options.pictures_folder);
  if (judgement) {
    std::printf("%s", pairs_text(*judgement).c_str());
    return;
  }
  const ObserverDefinition observer;
  std::printf("%s", detection_text(modelfest_table(options.threads)).c_str());
  std::printf("%s", detection_text(other_table(hdr_vdp_thresholds(), options.threads)).c_str());
  DetectionTable discs = other_table(disc_thresholds(), options.threads);
  discs.standard_db = standard_thresholds_db(disc_thresholds());
  std::printf("%s", detection_text(discs).c_str());
  std::printf(
      "`predict` rests on ModelFest's people: gain %.4g at scale_octaves %g. They knew where to look, "
      "looked at a uniform field, and had nothing else to do.\n",
      detection_gain(observer), observer.scale_octaves);
}

}  // namespace

void add_observe_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("observe", "the predicting observer beside published thresholds, or your pairs");
  const auto options = std::make_shared<ObserveOptions>();
  command->add_option("pairs", options->pairs,
                      "CSV with the columns reference, picture, seen, n, pixels_per_degree (none: published "
                      "thresholds)");
  command->add_option("--pictures", options->pictures_folder,
                      "also write the published patterns at full contrast into this folder, as PNG");
  add_number(*command, "--threads", options->threads, {0, 1024}, "0: as many as the machine has")
      ->capture_default_str();
  command->callback([options] { observe(*options); });
}

}  // namespace seamline::analysis
