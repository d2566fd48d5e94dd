#include "analysis/foresight/plan_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "support/files/markdown_table.h"

namespace seamline::analysis {
namespace {

bool meets(const PlannedInterval& interval, double wanted_octaves) {
  return !interval.planted || (interval.median_octaves && *interval.median_octaves <= wanted_octaves);
}

std::vector<PlannedDesign> designs_that_meet(const StudyPlan& plan) {
  std::vector<PlannedDesign> designs;
  for (const PlanRow& row : plan.rows) {
    if (row.artifact != plan.rows.front().artifact) continue;
    const PlannedDesign design{.width_set = row.width_set, .participants = row.participants};
    if (meets_wish(plan, design)) designs.push_back(design);
  }
  return designs;
}

int widths(const StudyPlan& plan, const PlannedDesign& design) {
  return static_cast<int>(plan.width_sets[design.width_set].width_px.size());
}

std::string octaves_text(const PlannedInterval& interval) {
  if (!interval.planted) return "beyond the widths";
  return interval.median_octaves ? fmt::format("{:.2f}", *interval.median_octaves) : "open";
}

std::string share_text(const PlannedInterval& interval) {
  return fmt::format("{:.0f} %", 100 * interval.open_share);
}

/// "PT of receiver, SN of receiver": which thresholds of a set of widths nobody can measure; and how many can
/// be.
struct Reach {
  std::vector<std::string> beyond;
  int within = 0;
};

Reach reach_of(const StudyPlan& plan, std::size_t width_set) {
  Reach reach;
  for (const PlanRow& row : plan.rows) {
    if (row.width_set != width_set || row.participants != plan.rows.front().participants) continue;
    for (const auto& [name, interval] :
         {std::pair{"PT", &row.perceptual}, std::pair{"SN", &row.slightly_noticeable}}) {
      if (interval->planted)
        ++reach.within;
      else
        reach.beyond.push_back(fmt::format("{} of {}", name, word(row.artifact)));
    }
  }
  return reach;
}

/// What no number of people can measure, and what therefore is in no wish.
std::string beyond_text(const StudyPlan& plan) {
  const Reach reach = reach_of(plan, 0);
  if (reach.beyond.empty()) return "";
  return fmt::format(
      "Beyond the study's widths: {} ({} of {} thresholds). No number of participants measures them: choose "
      "widths around them.\n",
      fmt::join(reach.beyond, ", "), reach.beyond.size(),
      reach.beyond.size() + static_cast<std::size_t>(reach.within));
}

std::string design_text(const StudyPlan& plan, const PlannedDesign& design) {
  const int trials = widths(plan, design) * plan.stimuli_a_width;
  return fmt::format("{} participants, widths \"{}\" ({} trials each, {} answers)", design.participants,
                     plan.width_sets[design.width_set].name, trials, trials * design.participants);
}

CsvTable table_of(const StudyPlan& plan) {
  CsvTable table{.name = "plan",
                 .columns = {{"artifact", "", ""},
                             {"widths", "", ""},
                             {"participants", "", ""},
                             {"PT interval, median", "octaves", ""},
                             {"PT open", "", ""},
                             {"SN interval, median", "octaves", ""},
                             {"SN open", "", ""}},
                 .rows = {}};
  for (const PlanRow& row : plan.rows)
    table.rows.push_back({std::string(word(row.artifact)), plan.width_sets[row.width_set].name,
                          std::int64_t{row.participants}, octaves_text(row.perceptual),
                          share_text(row.perceptual), octaves_text(row.slightly_noticeable),
                          share_text(row.slightly_noticeable)});
  return table;
}

}  // namespace

bool meets_wish(const StudyPlan& plan, const PlannedDesign& design) {
  bool some = false;
  for (const PlanRow& row : plan.rows) {
    if (row.width_set != design.width_set || row.participants != design.participants) continue;
    if (!meets(row.perceptual, plan.wanted_octaves) || !meets(row.slightly_noticeable, plan.wanted_octaves))
      return false;
    some = some || row.perceptual.planted || row.slightly_noticeable.planted;
  }
  return some;
}

std::optional<PlannedDesign> fewest_participants(const StudyPlan& plan) {
  const std::vector<PlannedDesign> designs = designs_that_meet(plan);
  if (designs.empty()) return std::nullopt;
  return *std::min_element(
      designs.begin(), designs.end(), [&](const PlannedDesign& a, const PlannedDesign& b) {
        return std::pair(a.participants, widths(plan, a)) < std::pair(b.participants, widths(plan, b));
      });
}

std::optional<PlannedDesign> fewest_answers(const StudyPlan& plan) {
  const std::vector<PlannedDesign> designs = designs_that_meet(plan);
  if (designs.empty()) return std::nullopt;
  return *std::min_element(designs.begin(), designs.end(),
                           [&](const PlannedDesign& a, const PlannedDesign& b) {
                             return std::tuple(a.participants * widths(plan, a), a.participants) <
                                    std::tuple(b.participants * widths(plan, b), b.participants);
                           });
}

std::string plan_text(const StudyPlan& plan) {
  std::string text = fmt::format("{} simulated studies for each set of widths:\n", plan.studies);
  for (const WidthSet& set : plan.width_sets)
    text += fmt::format("  {}: {} px\n", set.name, fmt::join(set.width_px, ", "));
  text += "\n" + markdown_table(table_of(plan)) + "\n";
  const std::string beyond = beyond_text(plan);
  const std::string wish =
      beyond +
      fmt::format(
          "Wanted: 95 % intervals of PT and SN of at most {:g} octave{} (median over studies) for {}.\n",
          plan.wanted_octaves, plan.wanted_octaves == 1 ? "" : "s",
          beyond.empty() ? "every artifact" : "every threshold within the widths");
  const std::optional<PlannedDesign> people = fewest_participants(plan), answers = fewest_answers(plan);
  if (!people || !answers) return text + wish + "There is no design in the table that gives them.\n";
  return text + wish + "Fewest participants: " + design_text(plan, *people) +
         ".\nFewest answers: " + design_text(plan, *answers) + ".\n";
}

}  // namespace seamline::analysis
