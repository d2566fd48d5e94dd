#include "analysis/joint/joint_contrasts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/joint/joint_thresholds.h"
#include "analysis/statistics/jackknife_degrees.h"

namespace seamline::analysis {

namespace {

/// The curves of a fit that have numbers.
std::vector<int> curves_with_numbers(const JointFit& fit) {
  std::vector<int> curves;
  for (int c = 0; c < fit.model.curves; ++c)
    if (fit.estimated(c)) curves.push_back(c);
  return curves;
}

std::string text_of_label(const CurveLabel& label) {
  std::string text = label.artifact;
  if (!label.condition.empty()) text += " (" + label.condition + ")";
  if (!label.group.empty()) text += ", " + label.group;
  return text;
}

using SamePair = std::function<bool(const CurveLabel& a, const CurveLabel& b)>;

Contrast shift_contrast(const JointModel& model, const std::vector<CurveLabel>& labels, int from, int to,
                        const LevelAxis& axis) {
  const std::string a = text_of_label(labels[from]), b = text_of_label(labels[to]);
  Contrast contrast{
      .name = b + " - " + a,
      .weights = Eigen::VectorXd::Zero(model.parameters()),
      .more = fmt::format("the threshold of {} lies at a larger {} than that of {}", b, level_word(axis), a),
      .less = fmt::format("the threshold of {} lies at a smaller {} than that of {}", b, level_word(axis), a),
      .undecided = fmt::format("no difference of the thresholds of {} and {} was shown", b, a)};
  const double unit = difference_at(axis, 1.0);
  contrast.weights[model.threshold(to)] = unit;
  contrast.weights[model.threshold(from)] = -unit;
  return contrast;
}

Contrast slope_contrast(const JointModel& model, const std::vector<CurveLabel>& labels, int from, int to) {
  const std::string a = text_of_label(labels[from]), b = text_of_label(labels[to]);
  Contrast contrast{.name = b + " - " + a,
                    .weights = Eigen::VectorXd::Zero(model.parameters()),
                    .more = fmt::format("noticeability of {} falls more steeply than that of {}", b, a),
                    .less = fmt::format("noticeability of {} falls less steeply than that of {}", b, a),
                    .undecided = fmt::format("no difference of the slopes of {} and {} was shown", b, a)};
  contrast.weights[model.log_scale(to)] = -1;
  contrast.weights[model.log_scale(from)] = 1;
  return contrast;
}

/// One question about all pairs of curves that belong together.
void add_table(const std::string& question, const JointFit& fit, const JointJackknife& left_out,
               const std::vector<CurveLabel>& labels, const SamePair& together,
               const std::function<Contrast(int from, int to)>& contrast, JointContrasts& into) {
  ContrastFamily family{.question = question, .contrasts = {}, .degrees_of_freedom = fit.people - 1.0};
  family.differences = true;
  const std::vector<int> curves = curves_with_numbers(fit);
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (std::size_t j = i + 1; j < curves.size(); ++j)
      if (together(labels[curves[i]], labels[curves[j]]))
        family.contrasts.push_back(contrast(curves[i], curves[j]));
  if (family.contrasts.empty()) return;
  for (const Contrast& one : family.contrasts)
    family.degrees_of_freedom =
        std::min(family.degrees_of_freedom, jackknife_degrees(left_out.theta * one.weights));
  constexpr std::size_t most_single_step = 1000;
  const Correction correction =
      family.contrasts.size() > most_single_step ? Correction::holm : Correction::single_step;
  into.tables.push_back(test_contrasts(family, fit.theta, left_out.covariance, correction));
}

void add_shifts(const JointFit& fit, const JointJackknife& left_out, const std::vector<CurveLabel>& labels,
                const LevelAxis& axis, JointContrasts& into) {
  for (int c = 0; c < fit.model.curves; ++c)
    if (!fit.estimated(c))
      into.notes.push_back(fmt::format("{} is left out of the comparisons: {}.", text_of_label(labels[c]),
                                       verdict_text(fit.curves[c])));
  if (!fit.estimated()) {
    into.notes.push_back("Thresholds are not compared: " + fit.explanation);
    return;
  }
  const auto contrast = [&](int from, int to) { return shift_contrast(fit.model, labels, from, to, axis); };
  add_table(
      "Do thresholds of artifacts differ?", fit, left_out, labels,
      [](const CurveLabel& a, const CurveLabel& b) {
        return a.artifact != b.artifact && a.condition == b.condition && a.group == b.group;
      },
      contrast, into);
  add_table(
      "Do thresholds differ between conditions?", fit, left_out, labels,
      [](const CurveLabel& a, const CurveLabel& b) {
        return a.artifact == b.artifact && a.condition != b.condition && a.group == b.group;
      },
      contrast, into);
  add_table(
      "Do thresholds differ between groups of people?", fit, left_out, labels,
      [](const CurveLabel& a, const CurveLabel& b) {
        return a.artifact == b.artifact && a.condition == b.condition && a.group != b.group;
      },
      contrast, into);
}

void add_slopes_of(const JointFit& fit, const JointJackknife& left_out, const std::vector<CurveLabel>& labels,
                   JointContrasts& into) {
  add_table(
      "Do slopes differ?", fit, left_out, labels, [](const CurveLabel&, const CurveLabel&) { return true; },
      [&](int from, int to) { return slope_contrast(fit.model, labels, from, to); }, into);
}

void add_slopes(const JointFit& shared, const JointJackknife& shared_left_out, const JointData& data,
                const std::vector<CurveLabel>& labels, JointContrasts& into) {
  JointSharing sharing = shared.model.sharing;
  if (shared.estimated() && !sharing.scale) return add_slopes_of(shared, shared_left_out, labels, into);
  sharing.scale = false;
  const JointFit fit = fit_joint(data, sharing);
  if (!fit.estimated()) {
    into.notes.push_back("Slopes are not compared: " + fit.explanation);
    return;
  }
  add_slopes_of(fit, leave_people_out(fit, data), labels, into);
}

}  // namespace

JointContrasts joint_contrasts(const JointFit& fit, const JointJackknife& left_out, const JointData& data,
                               const std::vector<CurveLabel>& labels, const LevelAxis& axis) {
  JointContrasts contrasts;
  if (data.curves.size() < 2) return contrasts;
  add_shifts(fit, left_out, labels, axis, contrasts);
  add_slopes(fit, left_out, data, labels, contrasts);
  return contrasts;
}

JointContrasts joint_contrasts(const JointData& data, const std::vector<CurveLabel>& labels,
                               const JointSharing& sharing, const LevelAxis& axis) {
  const JointFit fit = fit_joint(data, sharing);
  return joint_contrasts(fit, fit.estimated() ? leave_people_out(fit, data) : JointJackknife{}, data, labels,
                         axis);
}

JointData split_by_part(const JointData& data, const std::vector<Eigen::MatrixXd>& parts) {
  JointData split = data;
  split.curves.clear();
  split.cells.clear();
  const auto count = static_cast<int>(parts.size()), curves = static_cast<int>(data.curves.size());
  const Eigen::Index width = data.answers.cols();
  split.answers = Eigen::MatrixXd::Zero(data.answers.rows(), count * width);
  for (int k = 0; k < count; ++k) {
    split.curves.insert(split.curves.end(), data.curves.begin(), data.curves.end());
    for (JointCell cell : data.cells) {
      cell.curve += k * curves;
      split.cells.push_back(cell);
    }
    split.answers.middleCols(k * width, width) = parts[k];
  }
  return split;
}

JointData split_by_group(const JointData& data, const std::vector<int>& group_of, int groups) {
  std::vector<Eigen::Index> rows;
  for (std::size_t p = 0; p < group_of.size(); ++p)
    if (group_of[p] >= 0) rows.push_back(static_cast<Eigen::Index>(p));
  const JointData kept = of_people(data, rows);
  std::vector<Eigen::MatrixXd> parts(groups, Eigen::MatrixXd::Zero(kept.answers.rows(), kept.answers.cols()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto row = static_cast<Eigen::Index>(r);
    parts[static_cast<std::size_t>(group_of[rows[r]])].row(row) = kept.answers.row(row);
  }
  return split_by_part(kept, parts);
}

}  // namespace seamline::analysis
