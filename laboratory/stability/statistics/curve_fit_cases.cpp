#include "laboratory/stability/statistics/curve_fit_cases.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/worst.h"
#include "support/text/numbers.h"

namespace seamline::stability {
namespace {

bool has_warning(const JudgedFit& report, const std::string& part) {
  return std::any_of(report.warnings.begin(), report.warnings.end(),
                     [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
}

}  // namespace

std::vector<LevelCounts> counts_at(const std::vector<double>& levels, std::int64_t trials,
                                   const std::function<double(double level)>& share) {
  std::vector<LevelCounts> counts;
  for (const double level : levels)
    counts.push_back({.level = level,
                      .correct = std::llround(static_cast<double>(trials) * share(level)),
                      .trials = trials});
  return counts;
}

std::vector<LevelCounts> counts_at_widths(std::int64_t trials,
                                          const std::function<double(double width_px)>& share) {
  return counts_at({64, 128, 256, 512, 1024, 2048, 4096}, trials, share);
}

FitOptions falling_choice_of_three() {
  FitOptions options = options_for_alternatives(3);
  options.direction = Direction::decreasing;
  return options;
}

PsychometricFunction planted_function(double lapse) {
  return {.sigmoid = Sigmoid::normal,
          .axis = Axis::log2,
          .direction = Direction::decreasing,
          .threshold = 500,
          .scale = 0.8,
          .guess = 1.0 / 3,
          .lapse = lapse};
}

Finding try_verdict(const WantedVerdict& wanted, const FitRule& fit) {
  const JudgedFit report = fit(wanted.counts, wanted.options, {.deviance_replicates = 0, .unit = "px"});
  int wrong = report.verdict.text.rfind(wanted.text, 0) == 0 ? 0 : 1;
  const Interval& ci = report.threshold_ci95;
  wrong += std::isfinite(wanted.must_hold.low) && !(ci.low <= wanted.must_hold.low) ? 1 : 0;
  wrong += std::isfinite(wanted.must_hold.high) && !(ci.high >= wanted.must_hold.high) ? 1 : 0;
  wrong += wanted.open_high && std::isfinite(ci.high) ? 1 : 0;
  wrong += std::isfinite(ci.low) && std::isfinite(ci.high) ? (report.threshold ? 0 : 1) : 0;
  wrong += report.threshold && !(ci.low <= *report.threshold && *report.threshold <= ci.high) ? 1 : 0;
  const Interval& range = report.verdict.range;
  wrong += range.low == ci.low && range.high == ci.high ? 0 : 1;
  wrong += std::isnan(ci.low) || std::isnan(ci.high) || std::isnan(report.fit.log_likelihood) ? 1 : 0;
  return {static_cast<double>(wrong),
          fmt::format("\"{}\", interval {:.4g} to {:.4g} px", report.verdict.text, ci.low, ci.high)};
}

Finding try_million_trials() {
  const auto counts =
      counts_at_widths(1'000'000, [](double px) { return response_probability(planted_function(0.02), px); });
  const JudgedFit report = judge_fit(counts, falling_choice_of_three(), {.deviance_replicates = 0});
  const double error = worse(
      relative_error(report.fit.function.threshold, 500),
      worse(relative_error(report.fit.function.scale, 0.8), std::abs(report.fit.function.lapse - 0.02)));
  return {report.verdict.kind == Verdict::Kind::identified ? error : nan,
          fmt::format("threshold {:.6g}, scale {:.6g}, lapse {:.6g}", report.fit.function.threshold,
                      report.fit.function.scale, report.fit.function.lapse)};
}

Finding try_wide_levels() {
  double error = 0;
  for (const Sigmoid sigmoid : {Sigmoid::normal, Sigmoid::logistic, Sigmoid::gumbel}) {
    const PsychometricFunction function{.sigmoid = sigmoid,
                                        .axis = Axis::log2,
                                        .direction = Direction::increasing,
                                        .threshold = 0.02,
                                        .scale = 5,
                                        .guess = 0.5,
                                        .lapse = 0.03};
    std::vector<LevelCounts> counts;
    for (int power = -6; power <= 6; ++power) {
      const double level = std::pow(10.0, power);
      counts.push_back({.level = level,
                        .correct = std::llround(100'000 * response_probability(function, level)),
                        .trials = 100'000});
    }
    FitOptions options = options_for_alternatives(2);
    options.sigmoid = sigmoid;
    const JudgedFit report = judge_fit(counts, options, {.deviance_replicates = 0});
    if (report.verdict.kind != Verdict::Kind::identified) return {nan, report.verdict.text};
    error = worse(error, worse(relative_error(report.fit.function.threshold, 0.02),
                               relative_error(report.fit.function.scale, 5)));
  }
  return {error, fmt::format("three sigmoids, largest error {:.2g}", error)};
}

Finding try_large_lapse() {
  const auto counts =
      counts_at_widths(2000, [](double px) { return response_probability(planted_function(0.2), px); });
  const JudgedFit capped = judge_fit(counts, falling_choice_of_three(), {.deviance_replicates = 0});
  FitOptions wide = falling_choice_of_three();
  wide.lapse = free_rate(0.5);
  const JudgedFit free = judge_fit(counts, wide, {.deviance_replicates = 0});
  const bool said = capped.fit.function.lapse == 0.1 && has_warning(capped, "lapse rate is at its bound");
  return {said ? std::abs(free.fit.function.lapse - 0.2) : nan,
          fmt::format("lapse {:.4g} with a cap of 0.1{}, {:.4g} with one of 0.5", capped.fit.function.lapse,
                      said ? ", with a warning" : "", free.fit.function.lapse)};
}

Finding try_not_monotone() {
  const std::vector<LevelCounts> counts = {{64, 58, 60},   {128, 30, 60},  {256, 57, 60}, {512, 25, 60},
                                           {1024, 48, 60}, {2048, 20, 60}, {4096, 22, 60}};
  const JudgedFit report = judge_fit(counts, falling_choice_of_three(), {.deviance_replicates = 999});
  const bool said = has_warning(report, "misfit") && has_warning(report, "not monotone");
  return {said ? report.deviance_p : nan,
          fmt::format("p {:.3g}{}", report.deviance_p, said ? ", with warnings" : ", no warning")};
}

StabilityCases curve_fit_cases() {
  const auto verdict = [](const std::string& name, const std::string& tried, WantedVerdict wanted) {
    const std::string expected = "\"" + wanted.text + "\"";
    return StabilityCase{
        .group = "statistics",
        .name = name,
        .tried = tried,
        .expected = expected + (wanted.open_high ? " and an open interval" : ""),
        .unit = "contradictions",
        .tolerance = 0,
        .reason = "a verdict is a word, not a number",
        .run = [wanted = std::move(wanted)](const StabilityOptions&) { return try_verdict(wanted); }};
  };
  const auto all = [](double share) { return counts_at_widths(60, [share](double) { return share; }); };
  std::vector<LevelCounts> through_last = all(1);
  through_last.back().correct = 30;
  FitOptions no_lapse = falling_choice_of_three();
  no_lapse.lapse = fixed_rate(0);
  return {
      verdict("all-right", "420 answers, all right",
              {.counts = all(1), .text = "above 4096 px", .open_high = true}),
      verdict("all-chance", "420 answers, a third right at every level",
              {.counts = all(1.0 / 3), .text = "not identified: every level at chance"}),
      verdict("all-wrong", "420 answers, a tenth right: worse than guessing",
              {.counts = all(0.1), .text = "not identified"}),
      verdict("step", "all right up to 256 px, chance from 512 px",
              {.counts = counts_at_widths(60, [](double px) { return px < 300 ? 1.0 : 1.0 / 3; }),
               .text = "between 256 and 512 px"}),
      verdict("step-through-last-level", "all right up to 2048 px, half right at 4096 px",
              {.counts = through_last, .text = "identified", .must_hold = {.low = 3200, .high = 4095.9}}),
      verdict("steep-ridge",
              "12 answers a level: 12, 12, 11, 10, 5, 2, 6 right; steep functions through 1024 px",
              {.counts = {{64, 12, 12},
                          {128, 12, 12},
                          {256, 11, 12},
                          {512, 10, 12},
                          {1024, 5, 12},
                          {2048, 2, 12},
                          {4096, 6, 12}},
               .text = "identified",
               .must_hold = {.low = 402, .high = 1023}}),
      verdict("one-level", "30 answers at one level",
              {.counts = {{.level = 64, .correct = 20, .trials = 30}},
               .text = "not identified: one level tested"}),
      verdict("two-levels", "two levels in the middle of the rise, no lapses",
              {.counts = {{.level = 256, .correct = 180, .trials = 200},
                          {.level = 1024, .correct = 100, .trials = 200}},
               .options = no_lapse,
               .text = "identified",
               .must_hold = {.low = 500, .high = 500}}),
      verdict("one-trial-a-level", "one answer at each of seven levels, a step by its looks",
              {.counts = counts_at_widths(1, [](double px) { return px < 300 ? 1.0 : 0.0; }),
               .text = "between",
               .must_hold = {.low = 150, .high = 800}}),
      verdict("zero-trials", "two levels without an answer",
              {.counts = {{.level = 64}, {.level = 128}}, .text = "not identified: no trials"}),
      {.group = "statistics",
       .name = "not-monotone",
       .tried = "answers that go up and down with level, 60 a level",
       .expected = "a misfit, said in two warnings",
       .unit = "p of the deviance",
       .tolerance = 0.01,
       .reason = "the least that 999 replicates can say is 0.001; ten times that",
       .run = [](const StabilityOptions&) { return try_not_monotone(); }},
      {.group = "statistics",
       .name = "million-trials",
       .tried = "1e6 answers a level, exactly as expected of a threshold of 500 px",
       .expected = "500 px, scale 0.8 octaves, lapse 0.02",
       .unit = "relative",
       .tolerance = 2e-5,
       .reason = "counts are rounded to 1 in 1e6; the slope there is 0.3 an octave",
       .run = [](const StabilityOptions&) { return try_million_trials(); }},
      {.group = "statistics",
       .name = "levels-1e-6-to-1e6",
       .tried = "13 levels from 1e-6 to 1e6, three sigmoids, a threshold of 0.02",
       .expected = "threshold 0.02 and scale 5 octaves",
       .unit = "relative",
       .tolerance = 2e-3,
       .reason = "counts are rounded to 1 in 1e5 at levels 3.3 octaves apart",
       .run = [](const StabilityOptions&) { return try_wide_levels(); }},
      {.group = "statistics",
       .name = "lapse-0.2",
       .tried = "a lapse rate of 0.2, capped at 0.1 and at 0.5",
       .expected = "the cap and a warning; then 0.2",
       .unit = "lapse rate",
       .tolerance = 1e-3,
       .reason = "counts are rounded to 1 in 2,000: 5e-4, twice that",
       .run = [](const StabilityOptions&) { return try_large_lapse(); }},
  };
}

}  // namespace seamline::stability
