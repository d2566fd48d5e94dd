#include "analysis/log_analysis/no_seam.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/scores/cells.h"
#include "analysis/statistics/distributions.h"
#include "support/text/counted.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::analysis {

namespace {

constexpr double one_sided = 0.05;

/// Mean rating of all wrong answers, which are guesses; 1 where there is none.
double rating_of_guesses(const JointData& data) {
  double sum = 0, answers = 0;
  const Eigen::Index width = data.cell_counts();
  for (std::size_t cell = 0; cell < data.cells.size(); ++cell)
    for (Eigen::Index rating = 0; rating < data.ratings; ++rating) {
      const double wrong =
          data.answers.col(static_cast<Eigen::Index>(cell) * width + data.ratings + rating).sum();
      sum += wrong * static_cast<double>(rating + 1);
      answers += wrong;
    }
  return answers > 0 ? sum / answers : 1;
}

/// The formula score of each person who answered in a cell.
std::vector<double> scores_without_guesses(const JointData& data, std::size_t cell, double guess_rating) {
  const double chance = data.cells[cell].chance, taken = chance / (1 - chance) * guess_rating;
  std::vector<double> scores;
  for (Eigen::Index person = 0; person < data.answers.rows(); ++person) {
    const auto counts = data.answers.row(person).segment(static_cast<Eigen::Index>(cell) * data.cell_counts(),
                                                         data.cell_counts());
    if (!(counts.sum() > 0)) continue;
    double score = -taken * counts.tail(data.ratings).sum();
    for (Eigen::Index rating = 0; rating < data.ratings; ++rating)
      score += static_cast<double>(rating + 1) * counts[rating];
    scores.push_back(score / counts.sum());
  }
  return scores;
}

}  // namespace

std::vector<std::string> no_seam_sentences(const Analysis& analysis, double level, double margin) {
  if (analysis.adaptive || !analysis.joint)
    throw input_error({.file = analysis.log.file.string(),
                       .field = request_name("no_seam_at"),
                       .wanted = "constant stimuli, analysed by the joint model",
                       .found = analysis.adaptive ? "levels placed by the answers" : "model = \"paper\""});
  const JointData& data = analysis.joint->data;
  const LevelAxis& axis = analysis.data.axis;
  const double guess_rating = rating_of_guesses(data);
  std::vector<std::string> sentences;
  std::size_t cell = 0;
  for (const ArtifactScores& scores : analysis.data.artifacts)
    for (const double tested : scores.level) {
      const std::size_t here = cell++;
      if (tested != level) continue;
      const std::vector<double> of_people = scores_without_guesses(data, here, guess_rating);
      const std::string place = fmt::format("'{}'{} at {}", word(scores.artifact),
                                            in_condition(scores.condition), tested_text(axis, level));
      if (of_people.size() < 2) {
        sentences.push_back(fmt::format("That no seam is seen in {} was not tested: {}.", place,
                                        counted(of_people.size(), "participant")));
        continue;
      }
      const CellMean mean = mean_over_participants(of_people);
      const double people = of_people.size();
      const double reach = mean.sem * student_with_above(people - 1, one_sided);
      const bool shown = std::abs(mean.mean) + reach <= margin;
      sentences.push_back(fmt::format(
          "{} in {}: mean noticeability, corrected for guessing, is {:.2f} (90 % interval {:.2f} to {:.2f}), {} "
          "{:g} of 0 (two one-sided t tests over {} participants, 5 % each).",
          shown ? "No seam is seen" : "That no seam is seen is not shown", place, mean.mean,
          mean.mean - reach, mean.mean + reach, shown ? "within" : "not shown to be within", margin,
          of_people.size()));
    }
  if (sentences.empty())
    throw input_error({.file = analysis.log.file.string(),
                       .field = request_name("no_seam_at"),
                       .wanted = "one of the levels that people were shown",
                       .found = tested_text(axis, level)});
  return sentences;
}

}  // namespace seamline::analysis
