#include "analysis/log_analysis/group_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>

#include "analysis/log_analysis/participant_facts.h"
#include "analysis/statistics/jackknife_degrees.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::analysis {

namespace {

constexpr std::size_t most_groups = 8;
constexpr std::size_t fewest_numbers_split = 5;  ///< fewer different numbers are groups themselves

std::optional<double> as_number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

struct AskedField {
  std::string name;
  std::vector<double> bounds;
};

AskedField asked_field(const std::string& text) {
  AskedField asked{.name = text.substr(0, text.find('=')), .bounds = {}};
  if (asked.name.size() == text.size()) return asked;
  std::istringstream bounds(text.substr(asked.name.size() + 1));
  for (std::string piece; std::getline(bounds, piece, ',');) {
    const std::optional<double> bound = as_number(piece);
    if (!bound || (!asked.bounds.empty() && *bound <= asked.bounds.back()))
      throw input_error({.field = request_name("compare") + " " + asked.name,
                         .wanted = "bounds of bands as rising numbers, 30,45",
                         .found = piece});
    asked.bounds.push_back(*bound);
  }
  return asked;
}

void require_field(const Analysis& analysis, const std::string& name) {
  const std::vector<std::string> questions = answered_questions(analysis.log);
  if (name == "origin" || name == "condition" ||
      std::find(questions.begin(), questions.end(), name) != questions.end())
    return;
  throw input_error({.field = request_name("compare"),
                     .wanted = fmt::format(
                         "a question of the form that somebody answered ({}), origin or condition",
                         questions.empty() ? "there is none" : fmt::format("{}", fmt::join(questions, ", "))),
                     .found = name});
}

/// "under 30", "30 to under 45", "45 and over".
std::vector<std::string> band_names(const std::vector<double>& bounds) {
  std::vector<std::string> names = {fmt::format("under {:g}", bounds.front())};
  for (std::size_t i = 1; i < bounds.size(); ++i)
    names.push_back(fmt::format("{:g} to under {:g}", bounds[i - 1], bounds[i]));
  names.push_back(fmt::format("{:g} and over", bounds.back()));
  return names;
}

/// The group of each person of the joint data; -1: none.
struct Grouping {
  std::vector<std::string> names;
  std::vector<int> group_of;
};

Grouping grouping_of(const Analysis& analysis, const AskedField& asked) {
  std::map<std::string, std::string> answer_of;
  for (const ParticipantUse& person : analysis.people)
    if (person.use == Use::used)
      answer_of[person.record.code] = asked.name == "origin"
                                          ? (person.record.origin == study::Origin::window ? "lab" : "web")
                                          : answer_to(person.record, asked.name);
  std::vector<double> numbers;
  std::map<std::string, int> values;
  bool all_numbers = true;
  for (const std::string& person : analysis.joint->data.people) {
    const std::string& answer = answer_of[person];
    if (answer.empty()) continue;
    values.try_emplace(answer, 0);
    const std::optional<double> number = as_number(answer);
    if (number)
      numbers.push_back(*number);
    else
      all_numbers = false;
  }
  Grouping grouping;
  std::vector<double> bounds = asked.bounds;
  if (bounds.empty() && all_numbers && values.size() >= fewest_numbers_split) {
    std::sort(numbers.begin(), numbers.end());
    bounds = {numbers[numbers.size() / 2]};
  }
  if (!bounds.empty()) {
    grouping.names = band_names(bounds);
  } else {
    for (auto& [value, place] : values) {
      place = static_cast<int>(grouping.names.size());
      grouping.names.push_back(value);
    }
  }
  for (const std::string& person : analysis.joint->data.people) {
    const std::string& answer = answer_of[person];
    const std::optional<double> number = as_number(answer);
    int group = -1;
    if (!bounds.empty() && number)
      group = static_cast<int>(std::upper_bound(bounds.begin(), bounds.end(), *number) - bounds.begin());
    else if (bounds.empty() && !answer.empty())
      group = values[answer];
    grouping.group_of.push_back(group);
  }
  return grouping;
}

/// Leaves out groups that are too small; the names that are left.
std::vector<std::string> keep_large(Grouping& grouping, const std::vector<int>& people) {
  std::vector<int> place(people.size(), -1);
  std::vector<std::string> kept;
  for (std::size_t g = 0; g < people.size(); ++g)
    if (people[g] >= fewest_in_group) {
      place[g] = static_cast<int>(kept.size());
      kept.push_back(grouping.names[g]);
    }
  for (int& group : grouping.group_of) group = group < 0 ? -1 : place[group];
  return kept;
}

/// With fewer people in a group the errors of several curves, each estimated from few, leave the joint t
/// distribution too many false differences: 6.8 % of studies of 8 + 8 people, 4.0 % by Holm
/// (documentation/evidence/coverage.md).
constexpr std::ptrdiff_t fewest_single_step = 20;

std::ptrdiff_t smallest_group(const std::vector<int>& group_of, int groups) {
  auto smallest = std::ssize(group_of);
  for (int g = 0; g < groups; ++g)
    smallest = std::min(smallest, std::count(group_of.begin(), group_of.end(), g));
  return smallest;
}

void add_group_shifts(const Analysis& analysis, const Grouping& grouping,
                      const std::vector<std::string>& names, GroupComparison& comparison) {
  const JointAnalysis& joint = *analysis.joint;
  const auto groups = static_cast<int>(names.size()), curves = static_cast<int>(joint.labels.size());
  const JointData data = split_by_group(joint.data, grouping.group_of, groups);
  const JointFit fit = fit_joint(data, joint.fit.model.sharing);
  if (!fit.estimated()) {
    comparison.verdict = "Groups are not compared: " + fit.explanation;
    return;
  }
  const JointJackknife left_out = leave_people_out(fit, data, analysis.resampling.threads);
  std::vector<int> group_of_row;
  for (const int group : grouping.group_of)
    if (group >= 0) group_of_row.push_back(group);
  const double unit = difference_at(analysis.data.axis, 1.0);
  const std::string level = level_word(analysis.data.axis);
  ContrastFamily family{.question = "Do thresholds differ by " + comparison.field + "?", .contrasts = {}};
  family.differences = true;
  double df = std::max(1.0, fit.people - 1.0);
  const auto add = [&](const std::string& of, int a, int b, const std::vector<int>& of_curves) {
    Contrast contrast{
        .name = fmt::format("{}: {} - {}", of, names[b], names[a]),
        .weights = Eigen::VectorXd::Zero(fit.model.parameters()),
        .more = fmt::format("the threshold of {} of '{}' lies at a larger {} than that of '{}'", of, names[b],
                            level, names[a]),
        .less = fmt::format("the threshold of {} of '{}' lies at a smaller {} than that of '{}'", of,
                            names[b], level, names[a]),
        .undecided = fmt::format("no difference of the thresholds of {} between '{}' and '{}' was shown", of,
                                 names[b], names[a])};
    for (const int curve : of_curves) {
      contrast.weights[fit.model.threshold(b * curves + curve)] = unit / of_curves.size();
      contrast.weights[fit.model.threshold(a * curves + curve)] = -unit / of_curves.size();
    }
    df = std::min(df, jackknife_degrees(left_out.theta * contrast.weights, group_of_row));
    family.contrasts.push_back(std::move(contrast));
  };
  const auto known = [&](int group, int curve) { return fit.estimated(group * curves + curve); };
  for (int a = 0; a < groups; ++a)
    for (int b = a + 1; b < groups; ++b) {
      std::vector<int> both;
      for (int curve = 0; curve < curves; ++curve)
        if (known(a, curve) && known(b, curve)) both.push_back(curve);
      if (both.size() > 1) add("all curves together", a, b, both);
      for (const int curve : both) add(joint.data.curves[curve], a, b, {curve});
      if (both.size() < static_cast<std::size_t>(curves))
        comparison.notes.push_back(
            fmt::format("{} of {} curves of '{}' and '{}' have no threshold in both groups and are left out.",
                        curves - static_cast<int>(both.size()), curves, names[a], names[b]));
    }
  if (family.contrasts.empty()) {
    comparison.verdict = "Groups are not compared: no curve has a threshold in two of them.";
    return;
  }
  family.degrees_of_freedom = df;
  const Correction correction =
      smallest_group(group_of_row, groups) < fewest_single_step ? Correction::holm : Correction::single_step;
  comparison.shifts = test_contrasts(family, fit.theta, left_out.covariance, correction);
}

GroupComparison compare_by(const Analysis& analysis, const std::string& field) {
  GroupComparison comparison;
  comparison.field = field;
  const AskedField asked = asked_field(field);
  require_field(analysis, asked.name);
  if (asked.name == "condition") {
    comparison.verdict =
        has_conditions(analysis.data)
            ? "Conditions are compared within people, under “Do thresholds differ between conditions?”."
            : "Conditions are not compared: the study has one.";
    return comparison;
  }
  if (analysis.adaptive) {
    comparison.verdict =
        "Groups are not compared: levels were placed by the answers. Compare the thresholds of the tracks.";
    return comparison;
  }
  if (!analysis.joint || !analysis.joint->fit.estimated()) {
    comparison.verdict = "Groups are not compared: the joint model has no numbers.";
    return comparison;
  }
  Grouping grouping = grouping_of(analysis, asked);
  comparison.groups = grouping.names;
  comparison.people.assign(grouping.names.size(), 0);
  for (const int group : grouping.group_of) group < 0 ? ++comparison.silent : ++comparison.people[group];
  if (grouping.names.size() > most_groups) {
    comparison.verdict =
        fmt::format("Groups are not compared: {} answers differ, and at most {} groups are compared.",
                    grouping.names.size(), most_groups);
    return comparison;
  }
  std::string small;
  for (std::size_t g = 0; g < comparison.people.size(); ++g)
    if (comparison.people[g] < fewest_in_group)
      small +=
          fmt::format("{}'{}' ({})", small.empty() ? "" : ", ", comparison.groups[g], comparison.people[g]);
  const std::vector<std::string> kept = keep_large(grouping, comparison.people);
  if (kept.size() < 2) {
    comparison.verdict = fmt::format("Groups are not compared: it takes two of at least {} people{}{}.",
                                     fewest_in_group, small.empty() ? "" : ", and too few are ", small);
    return comparison;
  }
  if (!small.empty())
    comparison.notes.push_back(
        fmt::format("Left out, because fewer than {} people are in it: {}.", fewest_in_group, small));
  add_group_shifts(analysis, grouping, kept, comparison);
  return comparison;
}

}  // namespace

std::vector<GroupComparison> compare_groups(const Analysis& analysis,
                                            const std::vector<std::string>& fields) {
  std::vector<GroupComparison> comparisons;
  for (const std::string& field : fields) comparisons.push_back(compare_by(analysis, field));
  return comparisons;
}

}  // namespace seamline::analysis
