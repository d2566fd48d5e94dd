#include "analysis/thresholds/guess_correction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/statistics/distributions.h"
#include "analysis/statistics/interval.h"
#include "analysis/thresholds/closed_estimates.h"
#include "analysis/thresholds/curve_replicates.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr double replicate_tolerance = 1e-6;  ///< far under what a replicate differs by from the next
constexpr double few_guesses = 30;            ///< under this many, g and b are rough

/// The cells of one artifact: which columns of the counts are its own.
struct CellRange {
  std::size_t first = 0, count = 0;
  std::vector<double> level_x;  ///< of the first of them: one that stands apart is the last
};

std::vector<CellRange> ranges_of(const NoticeabilityData& data) {
  std::vector<CellRange> ranges;
  std::size_t first = 0;
  for (const ArtifactScores& scores : data.artifacts) {
    ranges.push_back({.first = first, .count = scores.level.size(), .level_x = levels_on_axis(scores)});
    first += scores.level.size();
  }
  return ranges;
}

const double* counts_at(const Eigen::VectorXd& counts, std::size_t cell, const TaskFacts& task) {
  return counts.data() + cell * static_cast<std::size_t>(cell_shape(task).of_cell());
}

/// The probability that a guess is right: b(o), averaged over the right positions of all answers.
double chance(const Eigen::VectorXd& counts, const Guessers& guessers) {
  const CellShape shape = cell_shape(guessers.task);
  double right = 0;
  for (Eigen::Index i = 0; i < counts.size(); ++i)
    right += counts[i] * guessers.position[static_cast<std::size_t>(i % shape.of_cell() / shape.of_trial())];
  return right / counts.sum();
}

/// A person's formula scores in the cells of a range: the rating when right; when wrong, minus what a guesser
/// gains by chance for each wrong guess, so that a guesser's expected score is 0.
Eigen::MatrixXd formula_scores(const GuessTrials& trials, const CellRange& range, const Guessers& guessers) {
  const CellShape shape = trials.shape();
  Eigen::VectorXd value(shape.of_cell());
  for (int place = 0; place < shape.of_cell(); ++place) {
    const int right = place / shape.of_trial(), chosen = place % shape.of_trial() / study::highest_rating;
    const double b = guessers.position[right];
    value[place] = right == chosen ? place % study::highest_rating + 1
                                   : -guessers.mean_rating() * b / std::max(1 - b, 1e-3);
  }
  std::vector<Eigen::RowVectorXd> rows;
  for (Eigen::Index p = 0; p < trials.answers.rows(); ++p) {
    Eigen::RowVectorXd row(static_cast<Eigen::Index>(range.level_x.size()));
    for (std::size_t w = 0; w < range.level_x.size(); ++w) {
      const auto counts = trials.answers.row(p).segment(
          static_cast<Eigen::Index>(range.first + w) * shape.of_cell(), shape.of_cell());
      const double answers = counts.sum();
      row[static_cast<Eigen::Index>(w)] = answers > 0 ? counts.dot(value) / answers : nan;
    }
    if ((row.array() == row.array()).any()) rows.push_back(row);  // others are not on this artifact's curve
  }
  Eigen::MatrixXd scores(static_cast<Eigen::Index>(rows.size()),
                         static_cast<Eigen::Index>(range.level_x.size()));
  for (std::size_t p = 0; p < rows.size(); ++p) scores.row(static_cast<Eigen::Index>(p)) = rows[p];
  return scores;
}

/// One-sided t test at 1 %: do people choose right more often than b says of guessers? Sets all that the
/// curve says of it.
void test_chance(const GuessTrials& trials, const CellRange& range, const Guessers& guessers,
                 CorrectedCurve& curve) {
  const CellShape shape = trials.shape();
  std::vector<double> beyond, shares;
  for (Eigen::Index p = 0; p < trials.answers.rows(); ++p) {
    double right_answers = 0, by_chance = 0, answers = 0;
    for (std::size_t w = 0; w < range.count; ++w)
      for (int place = 0; place < shape.of_cell(); ++place) {
        const double n =
            trials.answers(p, static_cast<Eigen::Index>(range.first + w) * shape.of_cell() + place);
        const int right = place / shape.of_trial(), chosen = place % shape.of_trial() / study::highest_rating;
        right_answers += right == chosen ? n : 0;
        by_chance += n * guessers.position[right];
        answers += n;
      }
    if (answers <= 0) continue;
    beyond.push_back((right_answers - by_chance) / answers);
    shares.push_back(right_answers / answers);
  }
  if (beyond.empty()) return;
  const CellMean mean = mean_over_participants(beyond);
  curve.people = mean.n;
  curve.right_share = mean_over_participants(shares).mean;
  curve.right_by_chance = curve.right_share - mean.mean;
  curve.above_chance = mean.n < 2 ? mean.mean > 0 : mean.mean > mean.sem * student_quantile(mean.n - 1, 0.99);
}

CorrectedCurve corrected_curve(const GuessTrials& trials, const ArtifactScores& scores,
                               const CellRange& range, const Guessers& guessers) {
  CorrectedCurve curve;
  curve.artifact = scores.artifact;
  curve.condition = scores.condition;
  curve.level = scores.level;
  if (scores.people.empty()) return curve;
  const Eigen::VectorXd counts = trials.answers.colwise().sum().transpose();
  std::vector<double> means;
  for (std::size_t w = 0; w < range.count; ++w) {
    curve.cells.push_back(fit_seeing(counts_at(counts, range.first + w, trials.task), guessers));
    if (w < range.level_x.size()) means.push_back(curve.cells.back().noticeability);
  }
  test_chance(trials, range, guessers, curve);
  if (means.empty()) {
    for (ThresholdEstimate* estimate :
         {&curve.estimates.perceptual, &curve.estimates.slightly_noticeable, &curve.estimates.inflection})
      estimate->reason = NoThreshold::no_level_shown;
    return curve;
  }
  curve.estimates = thresholds_of_means(range.level_x, means, scores.axis);
  const Eigen::MatrixXd formula = formula_scores(trials, range, guessers);
  if (formula.rows() < 2) return curve;
  const MeanVector formula_means = mean_and_covariance(formula);
  const int people = formula_means.fewest;
  if (people < 2) return curve;
  ThresholdEstimate& pt = curve.estimates.perceptual;
  ThresholdEstimate& sn = curve.estimates.slightly_noticeable;
  pt.ci95 = level_interval(perceptual_level, range.level_x, formula_means, people);
  sn.ci95 = level_interval(slight_level, range.level_x, formula_means, people);
  return curve;
}

void add_bootstrap(const GuessTrials& trials, const std::vector<CellRange>& ranges,
                   const ResamplingRequest& request, std::vector<CorrectedCurve>& curves) {
  Eigen::MatrixXd everything(trials.answers.rows(), trials.answers.cols() + trials.references.cols());
  everything << trials.answers, trials.references;
  std::vector<CurveReplicates> replicates;
  for (const CellRange& range : ranges)
    replicates.emplace_back(range.level_x, range.level_x.empty() ? 0 : request.replicates);
  for_each_replicate(everything, request, [&](int replicate, const Eigen::VectorXd& mean) {
    const Eigen::VectorXd answers = mean.head(trials.answers.cols());
    const Guessers guessers = estimate_guessers(answers, mean.tail(trials.references.cols()), trials.task);
    std::vector<double> means;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      means.clear();
      if (ranges[i].level_x.empty()) continue;
      for (std::size_t w = 0; w < ranges[i].level_x.size(); ++w)
        means.push_back(
            fit_seeing(counts_at(answers, ranges[i].first + w, trials.task), guessers, replicate_tolerance)
                .noticeability);
      const bool answered =
          std::all_of(means.begin(), means.end(), [](double m) { return std::isfinite(m); });
      if (answered) replicates[i].set(replicate, means);  // else it leaves every width open
    }
  });
  const TailLevels levels = expanded_levels(static_cast<int>(trials.people.size()));
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].cells.empty() || ranges[i].level_x.empty()) continue;
    const CurveIntervals intervals = replicates[i].intervals(levels);
    curves[i].perceptual_bootstrap = intervals.perceptual;
    curves[i].slightly_noticeable_bootstrap = intervals.slightly_noticeable;
    curves[i].estimates.inflection.ci95 = intervals.inflection;
    curves[i].estimates.perceptual_logistic.ci95 = intervals.perceptual_logistic;
    curves[i].estimates.slightly_noticeable_logistic.ci95 = intervals.slightly_noticeable_logistic;
  }
}

/// A test that does not reject says that chance is not excluded, never that people guessed: few people are
/// seldom enough.
std::string chance_note(const CorrectedCurve& curve) {
  const std::string under = fmt::format("Under '{}'{}", word(curve.artifact), in_condition(curve.condition));
  const std::string share =
      fmt::format("the right object was chosen in {:.0f} % of the answers (by guessing {:.0f} %)",
                  100 * curve.right_share, 100 * curve.right_by_chance);
  if (curve.people < 2)
    return fmt::format(
        "{} {}; one participant is not tested for chance, so whether the corrected curve says more "
        "than chance is open.",
        under, share);
  return fmt::format(
      "{} {}; that is not shown to be more than by guessing (one-sided t test over {} participants, 1 %), so "
      "whether the corrected curve says more than chance is open.",
      under, share, curve.people);
}

std::vector<std::string> notes_on_guessing(const GuessCorrection& correction) {
  std::vector<std::string> notes;
  const Guessers& guessers = correction.guessers;
  if (!guessers.known()) {
    notes.emplace_back(
        "Nobody chose wrong and there are no reference trials: nothing says how guessers rate, and nobody "
        "need have guessed, so the curves corrected for guessing are the uncorrected ones.");
    return notes;
  }
  if (correction.floor >= perceptual_level)
    notes.push_back(fmt::format(
        "Guessers rate {:.2f} on average, so uncorrected noticeability is not expected below {:.2f}: "
        "where an uncorrected curve falls to {} (PT) it does so by chance. Read the corrected PT.",
        guessers.mean_rating(), correction.floor, perceptual_level));
  if (guessers.wrong_answers + guessers.reference_answers < few_guesses)
    notes.push_back(
        fmt::format("How guessers answer rests on {:.0f} wrong choices and {:.0f} reference trials only.",
                    guessers.wrong_answers, guessers.reference_answers));
  if (!guessers.position_estimated)
    notes.emplace_back(
        "Wrong choices do not say how often guesses fall on each position, so equal positions are assumed.");
  for (const CorrectedCurve& curve : correction.curves)
    if (!curve.cells.empty() && !curve.above_chance) notes.push_back(chance_note(curve));
  return notes;
}

}  // namespace

GuessCorrection correct_for_guessing(const GuessTrials& trials, const NoticeabilityData& data,
                                     const ResamplingRequest& request) {
  GuessCorrection correction;
  const Eigen::VectorXd counts = trials.answers.colwise().sum().transpose();
  correction.guessers = estimate_guessers(counts, trials.references.colwise().sum().transpose(), trials.task);
  correction.floor = chance(counts, correction.guessers) * correction.guessers.mean_rating();
  const std::vector<CellRange> ranges = ranges_of(data);
  for (std::size_t i = 0; i < ranges.size(); ++i)
    correction.curves.push_back(corrected_curve(trials, data.artifacts[i], ranges[i], correction.guessers));
  if (request.replicates > 0 && trials.people.size() >= 2)
    add_bootstrap(trials, ranges, request, correction.curves);
  for (std::size_t i = 0; i < ranges.size(); ++i)
    if (!correction.curves[i].cells.empty() && !ranges[i].level_x.empty())
      keep_closed(correction.curves[i].estimates, ranges[i].level_x, data.artifacts[i].axis);
  correction.notes = notes_on_guessing(correction);
  return correction;
}

}  // namespace seamline::analysis
