#include "analysis/foresight/plan_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "analysis/foresight/plan_scenes.h"
#include "support/files/markdown_table.h"
#include "support/text/counted.h"

namespace seamline::analysis {
namespace {

std::size_t level_count(const StudyPlan& plan, const DesignRow& design) {
  return plan.level_sets[design.level_set].levels.size();
}

std::string unit_of(const StudyPlan& plan, double length) {
  return is_linear(plan.axis) ? length_unit(plan.axis) : length == 1 ? "octave" : "octaves";
}

double in_units(const StudyPlan& plan, double length_x) {
  return is_linear(plan.axis) ? length_x * plan.axis.unit : length_x;
}

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
}

std::string truth_text(const StudyPlan& plan, const PlanTarget& target) {
  return target.against ? fmt::format("{:+.2f}", difference_at(plan.axis, target.truth_x))
                        : estimated_text(plan.axis, level_at(plan.axis, target.truth_x));
}

/// "0.81, 93 %": median length, and how often the truth is held.
std::string cell_text(const PlannedInterval& interval) {
  const std::string holds = percent(interval.holds_share);
  if (!interval.median_length) return "open, " + holds;
  return fmt::format(
      "{:.2f}, {}{}", *interval.median_length, holds,
      interval.open_share > 0.05 ? fmt::format(", {} open", percent(interval.open_share)) : "");
}

CsvTable table_with_people(const StudyPlan& plan, const std::string& name, std::vector<CsvColumn> columns) {
  CsvTable table{.name = name, .columns = std::move(columns), .rows = {}};
  for (const int participants : plan.request.participants)
    table.columns.push_back({fmt::format("{} people", participants), "", ""});
  return table;
}

CsvTable interval_table(const StudyPlan& plan) {
  CsvTable table =
      table_with_people(plan, "plan",
                        {{"threshold", "", ""},
                         {level_word(plan.axis) + "s", "", ""},
                         {"true", "", ""},
                         {"bias", is_linear(plan.axis) ? length_unit(plan.axis) : "octaves", ""}});
  const std::size_t people = plan.request.participants.size();
  for (std::size_t first = 0; first < plan.rows.size(); first += people) {
    const PlanRow& row = plan.rows[first];
    const PlanTarget& target = plan.targets[row.target];
    const std::optional<double>& bias_x = plan.bias_x[row.target][row.level_set];
    std::vector<CsvValue> cells = {
        name_of(target, plan.curves), plan.level_sets[row.level_set].name, truth_text(plan, target),
        bias_x ? fmt::format("{:+.2f}", difference_at(plan.axis, *bias_x)) : std::string("–")};
    for (std::size_t n = 0; n < people; ++n)
      cells.emplace_back(row.interval.within ? cell_text(plan.rows[first + n].interval)
                                             : fmt::format("beyond the {}s", level_word(plan.axis)));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

CsvTable power_table(const StudyPlan& plan) {
  CsvTable table = table_with_people(
      plan, "power", {{"difference", "", ""}, {level_word(plan.axis) + "s", "", ""}, {"true", "", ""}});
  const std::size_t people = plan.request.participants.size();
  for (std::size_t first = 0; first < plan.rows.size(); first += people) {
    const PlanRow& row = plan.rows[first];
    const PlanTarget& target = plan.targets[row.target];
    if (!target.against) continue;
    std::vector<CsvValue> cells = {name_of(target, plan.curves), plan.level_sets[row.level_set].name,
                                   truth_text(plan, target)};
    for (std::size_t n = 0; n < people; ++n) {
      const PlannedInterval& interval = plan.rows[first + n].interval;
      cells.emplace_back(percent(interval.power) +
                         (plan.request.equal_within ? ", " + percent(interval.equal_share) : ""));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

CsvTable assurance_table(const StudyPlan& plan) {
  CsvTable table = table_with_people(plan, "assurance", {{level_word(plan.axis) + "s", "", ""}});
  const std::size_t people = plan.request.participants.size();
  for (std::size_t set = 0; set < plan.level_sets.size(); ++set) {
    std::vector<CsvValue> cells = {plan.level_sets[set].name};
    for (std::size_t n = 0; n < people; ++n) {
      const DesignRow& design = plan.designs[set * people + n];
      cells.emplace_back(percent(design.assurance) + ", " + percent(design.all_hold));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

CsvTable no_seam_table(const StudyPlan& plan) {
  CsvTable table = table_with_people(
      plan, "no seam", {{"artifact", "", ""}, {level_word(plan.axis) + "s", "", ""}, {"true", "", ""}});
  const std::size_t people = plan.request.participants.size();
  for (std::size_t curve = 0; curve < plan.curves.size(); ++curve)
    for (std::size_t set = 0; set < plan.level_sets.size(); ++set) {
      if (plan.designs[set * people].no_seam.empty()) continue;
      std::vector<CsvValue> cells = {name_of(plan.curves[curve]), plan.level_sets[set].name,
                                     fmt::format("{:.2f}", plan.seam_truth[curve])};
      for (std::size_t n = 0; n < people; ++n)
        cells.emplace_back(percent(plan.designs[set * people + n].no_seam[curve]));
      table.rows.push_back(std::move(cells));
    }
  return table;
}

CsvTable sequential_table(const StudyPlan& plan) {
  CsvTable table{.name = "sequential",
                 .columns = {{level_word(plan.axis) + "s", "", ""},
                             {"short enough at a look", "", ""},
                             {"participants, mean", "", ""},
                             {"intervals that hold", "", ""},
                             {"the same numbers fixed beforehand", "", ""},
                             {"price", "", ""}},
                 .rows = {}};
  for (const SequentialRow& row : plan.sequential)
    table.rows.push_back({plan.level_sets[row.level_set].name, percent(row.stopped_share),
                          fmt::format("{:.1f}", row.mean_participants),
                          fmt::format("{:.1f} %", 100 * row.holds),
                          fmt::format("{:.1f} %", 100 * row.fixed_holds),
                          fmt::format("{:.1f} %", 100 * (row.fixed_holds - row.holds))});
  return table;
}

/// What no number of people can measure with the study's levels, and what therefore is in no wish.
std::string beyond_text(const StudyPlan& plan) {
  std::vector<std::string> beyond;
  for (const PlanRow& row : plan.rows)
    if (row.level_set == 0 && row.participants == plan.request.participants.front() && !row.interval.within)
      beyond.push_back(name_of(plan.targets[row.target], plan.curves));
  if (beyond.empty()) return "";
  const std::string word = level_word(plan.axis);
  return fmt::format(
      "Beyond the study's {0}s: {1} ({2} of {3} thresholds). No number of participants measures them: choose "
      "{0}s around them.\n",
      word, fmt::join(beyond, ", "), beyond.size(), plan.targets.size());
}

std::string bias_text(const StudyPlan& plan) {
  std::string text;
  for (std::size_t set = 0; set < plan.level_sets.size(); ++set) {
    std::vector<std::string> biased;
    for (const std::size_t target : biased_targets(plan, set))
      biased.push_back(fmt::format("{} ({:+.2f})", name_of(plan.targets[target], plan.curves),
                                   difference_at(plan.axis, *plan.bias_x[target][set])));
    if (!biased.empty())
      text += fmt::format(
          "Warning: with the {}s \"{}\" the estimates approach other values than the truth, by more than "
          "half "
          "the wanted length: {}. More participants only make the intervals miss the truth more often; this "
          "design is recommended for nothing.\n",
          level_word(plan.axis), plan.level_sets[set].name, fmt::join(biased, ", "));
  }
  return text;
}

std::string design_text(const StudyPlan& plan, const DesignRow& design) {
  const int trials = static_cast<int>(level_count(plan, design)) * plan.trials_a_level + plan.references;
  return fmt::format("{}, {}s \"{}\" ({} each, {}; chance {})", counted(design.participants, "participant"),
                     level_word(plan.axis), plan.level_sets[design.level_set].name, counted(trials, "trial"),
                     counted(trials * design.participants, "answer"), percent(design.assurance));
}

std::vector<DesignRow> designs_that_meet(const StudyPlan& plan) {
  std::vector<DesignRow> designs;
  for (const DesignRow& design : plan.designs)
    if (meets_wish(plan, design)) designs.push_back(design);
  return designs;
}

std::string quantities_text(const StudyPlan& plan) {
  std::vector<std::string> names;
  for (const PlannedQuantity& quantity : every_planned_quantity)
    for (const bool difference : {false, true}) {
      const bool wanted =
          std::any_of(plan.targets.begin(), plan.targets.end(), [&](const PlanTarget& target) {
            return target.quantity.word == quantity.word && target.against.has_value() == difference;
          });
      if (wanted) names.push_back((difference ? "differences of " : "") + std::string(quantity.name));
    }
  return names.size() == 2 ? names[0] + " and " + names[1] : fmt::format("{}", fmt::join(names, ", "));
}

bool compares(const StudyPlan& plan) {
  return std::any_of(plan.targets.begin(), plan.targets.end(),
                     [](const PlanTarget& target) { return target.against.has_value(); });
}

bool detects(const StudyPlan& plan) {
  return std::any_of(plan.targets.begin(), plan.targets.end(), [](const PlanTarget& target) {
    return target.quantity.joint == JointQuantity::detection;
  });
}

/// The tables of what was asked for besides.
std::string further_tables(const StudyPlan& plan) {
  std::string text;
  const PlanRequest& request = plan.request;
  if (compares(plan)) {
    text +=
        "\nPower: share of studies whose interval of the difference lies on the true side of 0 (where the "
        "truth is "
        "0: on either side)";
    text += request.equal_within
                ? fmt::format(
                      "; then, share that lies within {:g} {} of 0, so that two one-sided tests at 2.5 "
                      "% each call both the same.\n",
                      *request.equal_within, unit_of(plan, *request.equal_within))
                : ".\n";
    text += markdown_table(power_table(plan));
  }
  if (request.no_seam)
    text +=
        fmt::format(
            "\nNo seam at {}: share of studies in which two one-sided t tests over participants at 5 % each "
            "put mean noticeability, corrected for guessing by formula scores, within {:g} of 0.\n",
            tested_text(plan.axis, request.no_seam->level), request.no_seam->margin) +
        markdown_table(no_seam_table(plan));
  if (request.sequential)
    text +=
        fmt::format(
            "\nAsking until every interval is at most {:g} {} long, looking after {} participants. The price "
            "is how much less often intervals then hold the truth than after the same numbers fixed "
            "beforehand.\n",
            request.wanted_length, unit_of(plan, request.wanted_length),
            fmt::join(request.participants, ", ")) +
        markdown_table(sequential_table(plan));
  return text;
}

}  // namespace

std::vector<std::size_t> biased_targets(const StudyPlan& plan, std::size_t level_set) {
  std::vector<std::size_t> biased;
  for (std::size_t target = 0; target < plan.targets.size(); ++target) {
    const std::optional<double>& bias_x = plan.bias_x[target][level_set];
    if (bias_x && std::abs(in_units(plan, *bias_x)) > plan.request.wanted_length / 2)
      biased.push_back(target);
  }
  return biased;
}

bool meets_wish(const StudyPlan& plan, const DesignRow& design) {
  return design.assurance >= plan.request.assurance && biased_targets(plan, design.level_set).empty();
}

std::optional<DesignRow> fewest_participants(const StudyPlan& plan, std::optional<std::size_t> level_set) {
  std::vector<DesignRow> designs = designs_that_meet(plan);
  if (level_set)
    std::erase_if(designs, [&](const DesignRow& design) { return design.level_set != *level_set; });
  if (designs.empty()) return std::nullopt;
  return *std::min_element(designs.begin(), designs.end(), [&](const DesignRow& a, const DesignRow& b) {
    return std::pair(a.participants, level_count(plan, a)) < std::pair(b.participants, level_count(plan, b));
  });
}

std::optional<DesignRow> fewest_answers(const StudyPlan& plan) {
  const std::vector<DesignRow> designs = designs_that_meet(plan);
  if (designs.empty()) return std::nullopt;
  const auto answers = [&](const DesignRow& design) {
    return static_cast<std::size_t>(design.participants) * level_count(plan, design);
  };
  return *std::min_element(designs.begin(), designs.end(), [&](const DesignRow& a, const DesignRow& b) {
    return std::tuple(answers(a), a.participants) < std::tuple(answers(b), b.participants);
  });
}

std::string wish_text(const StudyPlan& plan) {
  return fmt::format(
      "with a chance of {} ({} simulated studies) all 95 % intervals of {} are at most {:g} {} long",
      percent(plan.request.assurance), plan.request.studies, quantities_text(plan),
      plan.request.wanted_length, unit_of(plan, plan.request.wanted_length));
}

std::string plan_text(const StudyPlan& plan) {
  std::string text =
      fmt::format("{}\n\n{} simulated studies for each set of {}s, analysed by {}:\n", plan.assumptions,
                  plan.request.studies, level_word(plan.axis), name_of(plan.request.estimator));
  for (const LevelSet& set : plan.level_sets) {
    std::vector<std::string> levels;
    for (const double level : set.levels) levels.push_back(tested_text(plan.axis, level));
    text += fmt::format("  {}: {} {}\n", set.name, fmt::join(levels, ", "), facts(plan.axis.quantity).unit);
  }
  text +=
      fmt::format(
          "\nTrue: where the assumed people's expected mean truly crosses{}. Bias: what the estimates approach "
          "with ever more participants, less that. Then the median length of the 95 % interval ({}), and "
          "the share of studies whose interval holds the truth.\n",
          detects(plan) ? " (detection: where they see half, without guesses)" : "",
          is_linear(plan.axis) ? length_unit(plan.axis) : "octaves") +
      markdown_table(interval_table(plan)) +
      fmt::format("\nChance that all of them are at most {:g} {} long; and that all hold the truth.\n",
                  plan.request.wanted_length, unit_of(plan, plan.request.wanted_length)) +
      markdown_table(assurance_table(plan)) + further_tables(plan) + scenes_plan_text(plan) + "\n" +
      beyond_text(plan) + bias_text(plan) +
      fmt::format("Wanted: {}{}.\n", wish_text(plan),
                  beyond_text(plan).empty() ? "" : ", of those within the " + level_word(plan.axis) + "s");
  const std::optional<DesignRow> people = fewest_participants(plan), answers = fewest_answers(plan);
  if (!people || !answers) return text + "There is no design in the table that gives this.\n";
  return text + "Fewest participants: " + design_text(plan, *people) +
         ".\nFewest answers: " + design_text(plan, *answers) + ".\n";
}

}  // namespace seamline::analysis
