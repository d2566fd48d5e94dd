#include "commands/planning/observe_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "analysis/detection/standard_observer.h"
#include "commands/planning/observe_text.h"
#include "support/text/number_option.h"

namespace seamline::analysis {
namespace {

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

void write_patterns(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const DetectionPattern& pattern : modelfest_thresholds().patterns)
    write_png(folder / fmt::format("{:02}.png", pattern.number),
              display_image(pattern_picture(pattern_contrast(pattern), 1)));
}

void observe(const ObserveOptions& options) {
  if (!options.pictures_folder.empty()) write_patterns(options.pictures_folder);
  if (!options.pairs.empty()) {
    const std::vector<SeenPair> pairs = read_seen_pairs(options.pairs);
    std::printf("%s", pairs_text(judge_pairs(pairs, measure_pairs(pairs, options.threads))).c_str());
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
