#include "analysis/log_analysis/session_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "analysis/log_analysis/report_numbers.h"
#include "analysis/statistics/distributions.h"
#include "analysis/statistics/fixed_effects.h"
#include "analysis/statistics/jackknife_degrees.h"

namespace seamline::analysis {

namespace {

constexpr int fewest_people = 3;
constexpr double two_sided = 0.975;

Interval interval_at(double estimate, double variance, int people) {
  const double half = student_quantile(people - 1, two_sided) * std::sqrt(variance);
  return {.low = estimate - half, .high = estimate + half};
}

/// Mean over people of one value each.
MeanResidual mean_residual_of(std::string name, const std::vector<double>& values) {
  MeanResidual result;
  result.name = std::move(name);
  const CellMean mean = mean_over_participants(values);
  result.mean = mean.mean;
  result.ci95 = values.size() < 2
                    ? Interval{}
                    : interval_at(mean.mean, mean.sem * mean.sem, static_cast<int>(values.size()));
  return result;
}

using StimulusKey = std::tuple<Artifact, std::string, std::string, int, std::string, double>;

/// Answers with numbers for their people and stimuli, and their place in the person's session.
struct PlacedAnswers {
  std::vector<study::Answer> answers;
  TwoWayData table;  ///< y is the score, x the place from 0 to 1
  std::vector<std::string> people;
};

PlacedAnswers place_answers(const Analysis& analysis) {
  PlacedAnswers placed;
  placed.answers = used_answers(analysis.log, analysis.people);
  std::stable_sort(placed.answers.begin(), placed.answers.end(), [](const auto& a, const auto& b) {
    return std::tie(a.participant, a.trial_index) < std::tie(b.participant, b.trial_index);
  });
  std::map<std::string, int> answers_of, person_of;
  std::map<StimulusKey, int> stimulus_of;
  for (const study::Answer& answer : placed.answers) ++answers_of[answer.participant];
  TwoWayData& table = placed.table;
  table.y.resize(static_cast<Eigen::Index>(placed.answers.size()));
  table.x.resize(table.y.size(), 1);
  int place = 0;
  for (std::size_t i = 0; i < placed.answers.size(); ++i) {
    const study::Answer& answer = placed.answers[i];
    const bool first = i == 0 || placed.answers[i - 1].participant != answer.participant;
    place = first ? 0 : place + 1;
    const auto person = person_of.try_emplace(answer.participant, static_cast<int>(person_of.size()));
    if (person.second) placed.people.push_back(answer.participant);
    const StimulusKey key{answer.artifact,     answer.condition, answer.scene,
                          answer.object_index, answer.object,    answer.level};
    table.person.push_back(person.first->second);
    table.stimulus.push_back(
        stimulus_of.try_emplace(key, static_cast<int>(stimulus_of.size())).first->second);
    const auto at = static_cast<Eigen::Index>(i);
    table.y[at] = answer.noticeability();
    table.x(at, 0) = place / std::max(1.0, answers_of[answer.participant] - 1.0);
  }
  table.people = static_cast<int>(person_of.size());
  table.stimuli = static_cast<int>(stimulus_of.size());
  return placed;
}

/// Equal parts of the session as columns of 0 and 1, less their share of the answers, so that effects are
/// about the mean of all answers.
TwoWayData in_parts(const TwoWayData& table, int parts, Eigen::VectorXd& answers) {
  TwoWayData result = table;
  result.x = Eigen::MatrixXd::Zero(table.y.size(), parts);
  for (Eigen::Index i = 0; i < table.y.size(); ++i)
    result.x(i, std::min(parts - 1, static_cast<int>(table.x(i, 0) * parts))) = 1;
  answers = result.x.colwise().sum();
  return result;
}

std::vector<SessionPart> session_parts(const TwoWayData& table, int parts, TwoWayFit& fit) {
  Eigen::VectorXd answers;
  fit = fit_two_way(in_parts(table, parts, answers));
  std::vector<SessionPart> result;
  if (!fit.determined) return result;
  const double mean = table.y.mean();
  // Effects add up to 0 over answers.
  const Eigen::MatrixXd about_mean = Eigen::MatrixXd::Identity(parts, parts) -
                                     Eigen::VectorXd::Ones(parts) * answers.transpose() / answers.sum();
  const Eigen::VectorXd effect = about_mean * fit.b;
  const Eigen::MatrixXd covariance = about_mean * fit.covariance * about_mean.transpose();
  for (int part = 0; part < parts; ++part)
    result.push_back({.from = static_cast<double>(part) / parts,
                      .to = (part + 1.0) / parts,
                      .answers = static_cast<int>(answers[part]),
                      .mean = mean + effect[part],
                      .ci95 = interval_at(mean + effect[part], covariance(part, part), table.people)});
  return result;
}

/// What is left of each score when the mean of its stimulus is taken away.
std::vector<MeanResidual> residuals_of_people(const PlacedAnswers& placed) {
  const TwoWayData& table = placed.table;
  std::vector<double> sum(table.stimuli), count(sum.size());
  for (std::size_t i = 0; i < placed.answers.size(); ++i) {
    const std::size_t stimulus = table.stimulus[i];
    sum[stimulus] += placed.answers[i].noticeability();
    count[stimulus] += 1;
  }
  std::vector<std::vector<double>> left(placed.people.size());
  for (std::size_t i = 0; i < placed.answers.size(); ++i) {
    const std::size_t stimulus = table.stimulus[i];
    left[table.person[i]].push_back(placed.answers[i].noticeability() - sum[stimulus] / count[stimulus]);
  }
  std::vector<MeanResidual> result;
  for (std::size_t person = 0; person < left.size(); ++person) {
    result.push_back(mean_residual_of(placed.people[person], left[person]));
    result.back().answers = static_cast<int>(left[person].size());
  }
  return result;
}

/// Each person's mean at an object less their mean over the curve's objects at the same levels.
std::vector<MeanResidual> residuals_of_objects(const Analysis& analysis, const PlacedAnswers& placed) {
  using CellKey = std::tuple<int, Artifact, std::string, double>;
  std::map<CellKey, std::pair<double, int>> cells;
  for (std::size_t i = 0; i < placed.answers.size(); ++i) {
    const study::Answer& answer = placed.answers[i];
    auto& [sum, count] = cells[{placed.table.person[i], answer.artifact, answer.condition, answer.level}];
    sum += answer.noticeability();
    ++count;
  }
  using ObjectKey = std::tuple<Artifact, std::string, std::string, int, std::string>;
  std::map<ObjectKey, std::map<int, std::pair<double, int>>> objects;
  for (std::size_t i = 0; i < placed.answers.size(); ++i) {
    const study::Answer& answer = placed.answers[i];
    const auto& [cell_sum, cell_count] =
        cells[{placed.table.person[i], answer.artifact, answer.condition, answer.level}];
    auto& [sum, count] = objects[{answer.artifact, answer.condition, answer.scene, answer.object_index,
                                  answer.object}][placed.table.person[i]];
    sum += answer.noticeability() - cell_sum / cell_count;
    ++count;
  }
  std::vector<MeanResidual> result;
  for (const ObjectCurve& object : analysis.data.objects) {
    int answers = 0;
    const auto& people =
        objects[{object.artifact, object.condition, object.scene, object.object_index, object.object}];
    std::vector<double> means;
    for (const auto& [person, tally] : people) {
      means.push_back(tally.first / tally.second);
      answers += tally.second;
    }
    result.push_back(mean_residual_of(object.object, means));
    MeanResidual& residual = result.back();
    residual.artifact = object.artifact;
    residual.condition = object.condition;
    residual.scene = object.scene;
    residual.object_index = object.object_index;
    residual.answers = answers;
  }
  return result;
}

/// The log with only the first (half 0) or second (half 1) half of everybody's answers.
study::LogContents half_of_log(const Analysis& analysis, int half) {
  const PlacedAnswers placed = place_answers(analysis);
  study::LogContents log = analysis.log;
  log.answers.clear();
  for (std::size_t i = 0; i < placed.answers.size(); ++i)
    if ((placed.table.x(static_cast<Eigen::Index>(i), 0) < 0.5 ? 0 : 1) == half)
      log.answers.push_back(placed.answers[i]);
  return log;
}

/// Second half less first half of some curves, the mean of them.
Contrast half_contrast(const JointModel& model, const std::string& of, const std::vector<int>& of_curves,
                       const LevelAxis& axis) {
  const std::string level = level_word(axis);
  Contrast contrast{
      .name = of + ": second half - first half",
      .weights = Eigen::VectorXd::Zero(model.parameters()),
      .more =
          fmt::format("the threshold of {} lies at a larger {} in the second half of the session", of, level),
      .less = fmt::format("the threshold of {} lies at a smaller {} in the second half of the session", of,
                          level),
      .undecided =
          fmt::format("no difference of the threshold of {} between halves of the session was shown", of)};
  const double weight = difference_at(axis, 1.0) / static_cast<double>(of_curves.size());
  for (const int curve : of_curves) {
    contrast.weights[model.threshold(model.curves / 2 + curve)] = weight;
    contrast.weights[model.threshold(curve)] = -weight;
  }
  return contrast;
}

/// Curves that have a threshold in both halves.
std::vector<int> curves_of_both_halves(const JointFit& fit) {
  std::vector<int> both;
  const int curves = fit.model.curves / 2;
  for (int c = 0; c < curves; ++c)
    if (fit.estimated(c) && fit.estimated(curves + c)) both.push_back(c);
  return both;
}

}  // namespace

SessionHalves contrast_halves(const JointData& whole, const std::vector<Eigen::MatrixXd>& answers_of_half,
                              const JointSharing& sharing, const LevelAxis& axis, int threads) {
  SessionHalves halves;
  const JointData data = split_by_part(whole, answers_of_half);
  const JointFit fit = fit_joint(data, sharing);
  const std::vector<int> both = fit.estimated() ? curves_of_both_halves(fit) : std::vector<int>{};
  if (both.empty()) {
    halves.missing = "Thresholds by halves are not estimated: " +
                     (fit.estimated() ? "no curve has a threshold in both halves." : fit.explanation);
    return halves;
  }
  for (std::size_t c = 0; c < whole.curves.size(); ++c)
    if (std::find(both.begin(), both.end(), static_cast<int>(c)) == both.end())
      halves.notes.push_back(
          fmt::format("{} is left out of the halves: it has no threshold in one of them.", whole.curves[c]));
  const JointJackknife left_out = leave_people_out(fit, data, threads);
  ContrastFamily family{.question = "Do thresholds change during the session?",
                        .contrasts = {},
                        .degrees_of_freedom = std::max(1.0, fit.people - 1.0)};
  family.differences = true;
  if (both.size() > 1)
    family.contrasts.push_back(half_contrast(fit.model, "all curves together", both, axis));
  for (const int curve : both)
    family.contrasts.push_back(half_contrast(fit.model, whole.curves[curve], {curve}, axis));
  for (const Contrast& contrast : family.contrasts)
    family.degrees_of_freedom =
        std::min(family.degrees_of_freedom, jackknife_degrees(left_out.theta * contrast.weights));
  halves.shifts = test_contrasts(family, fit.theta, left_out.covariance, Correction::holm);
  return halves;
}

SessionHalves session_halves(const Analysis& analysis) {
  const bool known = analysis.joint && analysis.joint->fit.estimated();
  if (analysis.adaptive || !known) {
    SessionHalves none;
    none.missing = std::string("Thresholds by halves are not estimated: ") +
                   (analysis.adaptive ? "levels were placed by the answers, so halves have different levels."
                                      : "the joint model has no numbers.");
    return none;
  }
  const JointAnalysis& joint = *analysis.joint;
  std::vector<Eigen::MatrixXd> answers;
  for (int half = 0; half < 2; ++half)
    answers.push_back(joint_data(count_guess_trials(half_of_log(analysis, half), analysis.data, {}),
                                 joint.axis, analysis.guessing.guessers)
                          .answers);
  return contrast_halves(joint.data, answers, joint.fit.model.sharing, joint.axis,
                         analysis.resampling.threads);
}

SessionOrder session_order(const Analysis& analysis) {
  SessionOrder order;
  if (analysis.adaptive) {
    order.missing =
        "Order is not looked at: levels were placed by the answers, so what was shown changes with the "
        "trial.";
    return order;
  }
  const PlacedAnswers placed = place_answers(analysis);
  order.people = placed.table.people;
  order.answers = static_cast<int>(placed.answers.size());
  order.people_residuals = residuals_of_people(placed);
  order.object_residuals = residuals_of_objects(analysis, placed);
  if (order.people < fewest_people) {
    order.missing = fmt::format("Order is not looked at: it takes {} participants, and there are {}.",
                                fewest_people, order.people);
    return order;
  }
  const TwoWayFit line = fit_two_way(placed.table);
  if (!line.determined) {
    order.missing =
        "Order is not looked at: everybody was shown the stimuli in the same order, or too few answered.";
    return order;
  }
  order.trend = line.b[0];
  order.trend_ci95 = interval_at(order.trend, line.covariance(0, 0), order.people);
  TwoWayFit thirds, tenths;
  order.thirds = session_parts(placed.table, 3, thirds);
  order.tenths = session_parts(placed.table, 10, tenths);
  if (thirds.determined) {
    order.last_less_first = thirds.b[2] - thirds.b[0];
    const double variance = thirds.covariance(0, 0) + thirds.covariance(2, 2) - 2 * thirds.covariance(0, 2);
    order.last_less_first_ci95 = interval_at(order.last_less_first, variance, order.people);
  }
  return order;
}

std::string trend_sentence(const SessionOrder& order) {
  if (!order.missing.empty()) return order.missing;
  const Interval& ci = order.trend_ci95;
  const bool shown = ci.low > 0 || ci.high < 0;
  const auto number = [&](double value) {
    return fmt::format("{:.2f}", std::abs(value) < 0.005 ? 0.0 : value);
  };
  if (!shown)
    return fmt::format(
        "No trend over the session was shown: from the first trial to the last, noticeability changes by {} "
        "({} to {}), what was shown and who was asked being equal.",
        number(order.trend), number(ci.low), number(ci.high));
  const double low = std::min(std::abs(ci.low), std::abs(ci.high)),
               high = std::max(std::abs(ci.low), std::abs(ci.high));
  return fmt::format(
      "Scores {} during the session: from the first trial to the last, noticeability {} by {} ({} to {}), "
      "what was shown and who was asked being equal. Thresholds are of the session as a whole.",
      order.trend > 0 ? "rise" : "fall", order.trend > 0 ? "rises" : "falls", number(std::abs(order.trend)),
      number(low), number(high));
}

}  // namespace seamline::analysis
