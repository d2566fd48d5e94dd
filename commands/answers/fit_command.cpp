#include "commands/answers/answer_commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/psychometric/report/fit_json.h"
#include "analysis/psychometric/report/fit_quantities.h"
#include "analysis/psychometric/report/fit_table.h"
#include "analysis/psychometric/report/fit_text.h"
#include "analysis/psychometric/report/grouped_fit.h"
#include "analysis/psychometric/report/sigmoid_comparison.h"
#include "support/running/progress.h"
#include "support/text/error.h"
#include "support/text/number_option.h"
#include "support/text/printable.h"

namespace seamline::analysis {

namespace {

constexpr double largest_free_guess = 0.5, largest_free_lapse = 0.1;
constexpr const char* all_sigmoids_word = "all";   ///< sigmoids
constexpr const char* equal_rates_word = "equal";  ///< guess and lapse rate
constexpr std::size_t rows_of_seconds = 20'000;    ///< more may take seconds, and say how far they are

/// The words of the command line, before they are understood.
struct FitArguments {
  std::string file;
  int alternatives = 0;
  std::string sigmoid = std::string(word(FitOptions{}.sigmoid)), axis = "log2", direction = "auto",
              lapse = "free:0.1", guess;
  std::string threshold_prior, width_prior, lapse_prior;
  bool overdispersed = false, json = false;
  FitColumns columns;
  FitRequest request;
};

double number_of(const std::string& option, const std::string& text, const std::string& wanted,
                 const std::string& whole) {
  if (const std::optional<double> value = decimal_number(text)) return *value;
  throw input_error({.field = option, .wanted = wanted, .found = "'" + whole + "'"});
}

/// "0.02" is fixed, "free:0.1" is free to 0.1, "free" is free to the largest.
Rate rate_of(const std::string& option, const std::string& text, double largest) {
  const std::string wanted = "a rate from 0 to 1, or free:MAX";
  if (text == "free") return free_rate(largest);
  const bool is_free = text.starts_with("free:");
  const double value = number_of(option, is_free ? text.substr(5) : text, wanted, text);
  if (value < 0 || value >= 1 || (is_free && value == 0))
    throw input_error({.field = option, .wanted = wanted, .found = "'" + text + "'"});
  return is_free ? free_rate(value) : fixed_rate(value);
}

/// "A,B".
std::pair<double, double> pair_of(const std::string& option, const std::string& text) {
  const std::string wanted = "two numbers A,B";
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos)
    throw input_error({.field = option, .wanted = wanted, .found = "'" + text + "'"});
  return std::pair{number_of(option, text.substr(0, comma), wanted, text),
                   number_of(option, text.substr(comma + 1), wanted, text)};
}

Priors priors_of(const FitArguments& arguments) {
  Priors priors;
  if (!arguments.threshold_prior.empty()) {
    const auto [mean, sd] = pair_of("--threshold-prior", arguments.threshold_prior);
    priors.threshold = NormalPrior{.mean = mean, .sd = sd};
  }
  if (!arguments.width_prior.empty()) {
    const auto [median, sd] = pair_of("--width-prior", arguments.width_prior);
    if (median <= 0)
      throw input_error({.field = "--width-prior",
                         .wanted = "a positive median",
                         .found = "'" + arguments.width_prior + "'"});
    priors.log2_width = NormalPrior{.mean = std::log2(median), .sd = sd};
  }
  if (!arguments.lapse_prior.empty()) {
    const auto [a, b] = pair_of("--lapse-prior", arguments.lapse_prior);
    priors.lapse = BetaPrior{.a = a, .b = b};
  }
  return priors;
}

void require_lapse(const std::string& text) {
  (void)rate_of("--lapse", text, largest_free_lapse);
}
void require_guess(const std::string& text) {
  if (text == equal_rates_word) return;
  (void)rate_of("--guess", text, largest_free_guess);
}
void require_pair(const std::string& option, const std::string& text) {
  (void)pair_of(option, text);
}

/// The default first.
std::vector<std::string> sigmoid_words() {
  std::vector<std::string> words;
  for (const Sigmoid sigmoid : every_sigmoid) words.emplace_back(word(sigmoid));
  std::stable_partition(words.begin(), words.end(),
                        [](const std::string& one) { return one == word(FitOptions{}.sigmoid); });
  return words;
}

study::Axis axis_of(const FitArguments& arguments) {
  return arguments.axis == word(study::Axis::linear) ? study::Axis::linear : study::Axis::log2;
}

FitOptions options_of(const FitArguments& arguments) {
  FitOptions options = options_for_alternatives(arguments.alternatives);
  if (arguments.sigmoid != all_sigmoids_word) options.sigmoid = sigmoid_from_word(arguments.sigmoid).value();
  options.axis = axis_of(arguments);
  for (const auto direction : {study::Direction::increasing, study::Direction::decreasing})
    if (arguments.direction == word(direction)) options.direction = direction;
  options.lapse = rate_of("--lapse", arguments.lapse, largest_free_lapse);
  if (arguments.guess == equal_rates_word && arguments.alternatives > 1)
    throw input_error({.field = "--guess",
                       .wanted = "a rate for a choice of several; equal rates at both ends are for yes/no "
                                 "(--alternatives 1)",
                       .found = "'equal'"});
  if (arguments.guess == equal_rates_word)
    options.equal_rates = true;
  else if (!arguments.guess.empty())
    options.guess = rate_of("--guess", arguments.guess, largest_free_guess);
  else if (arguments.alternatives == 1)
    options.guess = free_rate(std::min(largest_free_guess, 0.99 - options.lapse.high));
  options.priors = priors_of(arguments);
  options.overdispersed = arguments.overdispersed;
  return options;
}

/// What was ignored and understood of the file, behind the report.
std::string with_remarks(const std::string& report, const FitTable& table, bool as_json) {
  if (table.ignored.empty() && table.remarks.empty()) return report;
  if (as_json) {
    auto json = nlohmann::ordered_json::parse(report);
    json["ignored_columns"] = table.ignored;
    json["remarks"] = table.remarks;
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  }
  std::string text = report;
  if (!table.ignored.empty())
    text += fmt::format("Ignored column{}: {}.\n", table.ignored.size() == 1 ? "" : "s",
                        fmt::join(table.ignored, ", "));
  for (const std::string& remark : table.remarks) text += "Note: " + remark + ".\n";
  return text;
}

/// Of yes/no answers whose rates nobody asked for: what the model would say whose ends mirror each other.
std::string remark_on_rates(const JudgedFit* fit, const FitTable& table) {
  std::string remark =
      "yes/no: guess and lapse rate are fitted apart; --guess equal makes them one, as for a point of "
      "subjective "
      "equality";
  if (fit == nullptr || !fit->threshold) return remark;
  FitOptions options = fit->fit.options;
  options.equal_rates = true;
  const PsychometricFit equal = fit_psychometric(counts_of(table), options);
  return remark + fmt::format(": its threshold is then {:.4g}, its AIC {:.2f}", equal.function.threshold,
                              2 * equal.free_parameters - 2 * equal.log_likelihood);
}

std::string report_of(FitTable& table, const FitArguments& arguments, FitRequest request) {
  request.answers_are_yes = arguments.alternatives == 1;
  const FitOptions options = options_of(arguments);
  const bool unasked_rates = arguments.alternatives == 1 && arguments.guess.empty();
  const bool several = !table.groups.empty() || !table.participants.empty();
  if (several && arguments.sigmoid == all_sigmoids_word)
    throw input_error({.field = "--sigmoid",
                       .wanted = "one sigmoid where there are groups or participants",
                       .found = "'all'"});
  if (several) {
    if (unasked_rates) table.remarks.push_back(remark_on_rates(nullptr, table));
    const GroupedFit fits = fit_groups(table, options, request);
    return arguments.json ? grouped_json(fits) : grouped_text(fits);
  }
  if (arguments.sigmoid == all_sigmoids_word) {
    const SigmoidComparison comparison = compare_sigmoids(counts_of(table), options, request);
    if (unasked_rates) table.remarks.push_back(remark_on_rates(&comparison.fits.front(), table));
    return arguments.json ? comparison_json(comparison) : comparison_text(comparison);
  }
  const JudgedFit report = judge_fit(counts_of(table), options, request);
  if (unasked_rates) table.remarks.push_back(remark_on_rates(&report, table));
  return arguments.json ? fit_json(report) : fit_text(report);
}

void run_fit(const FitArguments& arguments) {
  FitTable table = read_fit_table(arguments.file, arguments.columns, axis_of(arguments));
  FitRequest request = arguments.request;
  std::optional<Progress> progress;
  if (table.rows.size() > rows_of_seconds && table.groups.empty() && arguments.sigmoid != all_sigmoids_word)
    progress.emplace("fit", 1);
  double told = 0;
  request.progress = [&](double share, const std::string& now_doing) {
    if (progress) progress->advance(share - told, now_doing);
    told = share;
  };
  const std::string report = report_of(table, arguments, request);
  progress.reset();
  std::fputs(with_remarks(report, table, arguments.json).c_str(), stdout);
}

void add_column_options(CLI::App& command, FitColumns& columns) {
  const auto add = [&](const char* name, std::string& target, const char* description) {
    command.add_option(name, target, description)->type_name("COLUMN");
  };
  add("--level", columns.level, "column of the levels; by default level, x, intensity or stimulus");
  add("--correct", columns.correct,
      "column of right (or yes) answers; by default correct, k, right, yes, ...");
  add("--trials", columns.trials,
      "column of trials; by default trials, n, n_trials or total; without one a row is one answer");
  add("--times", columns.times,
      "column of how often the answer of a row (0 or 1) was given; instead of --trials");
  add("--participant", columns.participant, "column of participants: a model of people who differ");
  add("--group", columns.group, "column of groups or conditions: a fit to each, and their differences");
}

}  // namespace

void add_fit_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("fit", "a psychometric function from counts at levels, with intervals");
  const auto arguments = std::make_shared<FitArguments>();
  command->add_option("data", arguments->file, "CSV with the columns level,correct,trials")->required();
  add_column_options(*command, arguments->columns);
  add_number(*command, "--alternatives", arguments->alternatives, {1, 1000},
             "of the forced choice; 1 is yes/no")
      ->required();
  const std::vector<std::string> sigmoids = sigmoid_words();
  std::vector<std::string> allowed = sigmoids;
  allowed.emplace_back(all_sigmoids_word);
  command
      ->add_option("--sigmoid", arguments->sigmoid,
                   fmt::format("{}, or all: compared by AIC", fmt::join(sigmoids, ", ")))
      ->check(CLI::IsMember(allowed))
      ->capture_default_str();
  command->add_option("--axis", arguments->axis, "log2 or linear")
      ->check(CLI::IsMember(std::vector<std::string>{word(study::Axis::log2), word(study::Axis::linear)}))
      ->capture_default_str();
  command->add_option("--direction", arguments->direction, "increasing, decreasing or auto: the likelier")
      ->check(CLI::IsMember(std::vector<std::string>{word(study::Direction::increasing),
                                                     word(study::Direction::decreasing), "auto"}))
      ->capture_default_str();
  add_formed_text(*command, "--lapse", arguments->lapse, "RATE", "a fixed rate, or free:MAX", require_lapse)
      ->capture_default_str();
  add_formed_text(
      *command, "--guess", arguments->guess, "RATE",
      "a fixed rate, free (to 0.5), free:MAX or, for yes/no, equal to --lapse; default 1/N, free for yes/no",
      require_guess);
  add_number(*command, "--percent", arguments->request.percents, {0, 100},
             "also the level of this percentage correct, between 0 and 100; repeat for more");
  command->add_flag("--overdispersed", arguments->overdispersed,
                    "beta-binomial rows: intervals allow for extra scatter");
  add_number(*command, "--bootstrap", arguments->request.bootstrap_replicates, {0, 1000000},
             "BCa intervals from this many replicates");
  add_number(*command, "--seed", arguments->request.seed, any_seed, "of bootstrap and deviance p")
      ->capture_default_str();
  const auto add_prior = [&](const std::string& name, std::string& target, const char* form,
                             const char* description) {
    add_formed_text(*command, name, target, form, description,
                    [name](const std::string& text) { require_pair(name, text); });
  };
  add_prior("--threshold-prior", arguments->threshold_prior, "MEAN,SD",
            "normal on the axis, MEAN a level (MAP)");
  add_prior("--width-prior", arguments->width_prior, "MEDIAN,SD", "normal in log2 of the width (MAP)");
  add_prior("--lapse-prior", arguments->lapse_prior, "A,B", "beta distribution, e.g. 1,10 (MAP)");
  command->add_option("--unit", arguments->request.unit, "unit of the levels, for texts");
  command->add_flag("--json", arguments->json, "as JSON");
  command->callback([arguments] { run_fit(*arguments); });
}

}  // namespace seamline::analysis
