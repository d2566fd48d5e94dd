// Eight people of Adler and Ma (2018): the joint model, the means of the same answers joined by straight
// lines, and the ordinal model, fitted to one part of each person's answers and judged on the rest
// (documentation/evidence/coverage.md).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "analysis/joint/joint_fit.h"
#include "analysis/ordinal/likelihood/ordinal_fit.h"
#include "support/arithmetic/random.h"

namespace seamline::analysis {
namespace {

constexpr int scores = 5;  // 0 wrong, 1 to 4 the rating of a right choice
constexpr double chance_of_two = 0.5;
constexpr std::uint64_t splits = 5;  // 20 for the table

/// Answers at a level: right rated 1 to 4, then wrong rated 1 to 4.
using LevelAnswers = std::array<double, 8>;
using AnswersByLevel =
    std::map<double, LevelAnswers>;  // by x = -log2 contrast: falling, as on every axis of curves
using ScoreShares = std::array<double, scores>;

std::map<std::string, AnswersByLevel> read_people() {
  std::ifstream file(std::string(SEAMLINE_SOURCE_DIR) + "/tests/data/adler2018_task_a_ratings.csv");
  std::map<std::string, AnswersByLevel> people;
  std::string line;
  for (std::getline(file, line); std::getline(file, line);) {
    std::stringstream row(line);
    std::array<std::string, 5> cell;
    for (std::string& text : cell) std::getline(row, text, ',');
    const std::size_t place = (cell[2] == "1" ? 0 : 4) + std::stoul(cell[3]) - 1;
    people[cell[0]][-std::log2(std::stod(cell[1]))][place] += std::stod(cell[4]);
  }
  return people;
}

double sum(const LevelAnswers& answers) {
  double all = 0;
  for (const double n : answers) all += n;
  return all;
}

/// Score of an answer by its place.
std::size_t score_of(std::size_t place) {
  return place < 4 ? place + 1 : 0;
}

/// Puts each answer into the first part with probability `share`.
std::pair<AnswersByLevel, AnswersByLevel> split(const AnswersByLevel& answers, double share, Random& random) {
  std::pair<AnswersByLevel, AnswersByLevel> parts;
  for (const auto& [x, counts] : answers)
    for (std::size_t place = 0; place < counts.size(); ++place)
      for (int i = 0; i < static_cast<int>(counts[place]); ++i)
        (random.uniform() < share ? parts.first : parts.second)[x][place] += 1;
  return parts;
}

ScoreShares by_joint_model(const AnswersByLevel& fitted, double x) {
  JointData data;
  data.curves = {"contrast"};
  data.people = {"one"};
  for (const auto& [level, counts] : fitted) data.cells.push_back({.x = level, .chance = chance_of_two});
  data.answers = Eigen::MatrixXd::Zero(1, static_cast<Eigen::Index>(fitted.size()) * 8);
  Eigen::Index at = 0;
  for (const auto& [level, counts] : fitted)
    for (const double n : counts) data.answers(0, at++) = n;
  data.references = Eigen::MatrixXd::Zero(1, 4);
  const JointModel model = joint_model(data);
  const auto theta = maximise_joint(model, all_counts(data));
  EXPECT_TRUE(theta);
  if (!theta) return {};
  const Eigen::VectorXd p = outcome_probabilities(curve_at(model, *theta, 0), x, chance_of_two);
  ScoreShares shares{};
  for (std::size_t place = 0; place < 8; ++place)
    shares[score_of(place)] += p[static_cast<Eigen::Index>(place)];
  return shares;
}

ScoreShares by_ordinal_model(const AnswersByLevel& fitted, double x) {
  OrdinalData data;
  data.predictor_names = {"level"};
  std::vector<double> levels;
  for (const auto& [level, counts] : fitted)
    for (std::size_t place = 0; place < 8; ++place)
      for (int i = 0; i < static_cast<int>(counts[place]); ++i) {
        data.score.push_back(static_cast<int>(score_of(place)));
        levels.push_back(level);
      }
  data.predictors = Eigen::Map<Eigen::VectorXd>(levels.data(), static_cast<Eigen::Index>(levels.size()));
  const OrdinalFit fit = fit_cumulative_link(data, {});
  EXPECT_TRUE(has_estimates(fit.verdict));
  if (!has_estimates(fit.verdict)) return {};
  ScoreShares shares{};
  double below = 0;
  for (std::size_t k = 0; k < fit.used_scores.size(); ++k) {
    const bool last = k + 1 == fit.used_scores.size();
    const double to =
        last ? 1 : cumulative(Link::logit, fit.cuts[static_cast<Eigen::Index>(k)] - fit.coefficients[0] * x);
    shares[static_cast<std::size_t>(fit.used_scores[k])] = to - below;
    below = to;
  }
  return shares;
}

/// Shares of each score at the levels fitted, joined by straight lines.
ScoreShares by_lines(const AnswersByLevel& fitted, double x) {
  const auto at = [](const LevelAnswers& counts) {
    ScoreShares shares{};
    for (std::size_t place = 0; place < 8; ++place) shares[score_of(place)] += counts[place] / sum(counts);
    return shares;
  };
  const auto after = fitted.lower_bound(x);
  if (after == fitted.end()) return at(fitted.rbegin()->second);
  if (after == fitted.begin() || after->first == x) return at(after->second);
  const auto before = std::prev(after);
  const double t = (x - before->first) / (after->first - before->first);
  ScoreShares shares = at(before->second), far = at(after->second);
  for (std::size_t k = 0; k < scores; ++k) shares[k] += t * (far[k] - shares[k]);
  return shares;
}

/// How far from the answers judged a prediction lies: the log score an answer (nats; half an answer is added
/// to each hundred of a prediction, so that none is 0), and the mean noticeability's and right answers'
/// errors.
struct Judgement {
  double log_score = 0, answers = 0, noticeability = 0, right = 0, cells = 0;

  void add(ScoreShares p, const LevelAnswers& judged) {
    const double n = sum(judged);
    ScoreShares observed{};
    for (std::size_t place = 0; place < 8; ++place) observed[score_of(place)] += judged[place];
    double mean = 0, seen_mean = 0;
    for (std::size_t k = 0; k < scores; ++k) {
      log_score += observed[k] * std::log((p[k] + 0.001) / 1.005);
      mean += static_cast<double>(k) * p[k];
      seen_mean += static_cast<double>(k) * observed[k] / n;
    }
    answers += n;
    noticeability += (mean - seen_mean) * (mean - seen_mean);
    right += (observed[0] / n - p[0]) * (observed[0] / n - p[0]);
    cells += 1;
  }
  void print(const char* what, const char* way) const {
    std::printf("| %s | %s | %.4f | %.3f | %.3f |\n", what, way, log_score / answers,
                std::sqrt(noticeability / cells), std::sqrt(right / cells));
  }
};

struct Judgements {
  Judgement joint, lines, ordinal;

  void add(const AnswersByLevel& fitted, double x, const LevelAnswers& judged) {
    joint.add(by_joint_model(fitted, x), judged);
    lines.add(by_lines(fitted, x), judged);
    ordinal.add(by_ordinal_model(fitted, x), judged);
  }
  void print(const char* what) const {
    joint.print(what, "joint model");
    lines.print(what, "straight lines");
    ordinal.print(what, "ordinal model");
  }
};

TEST(RealPeople, AnswerAsTheJointModelSaysOnAnswersItDidNotSee) {
  Judgements half, tenth, level;
  for (const auto& [code, answers] : read_people()) {
    for (std::uint64_t seed = 1; seed <= splits; ++seed) {
      for (const auto& [share, judged] : {std::pair{0.5, &half}, std::pair{0.1, &tenth}}) {
        Random random(seed, static_cast<std::uint64_t>(code.back()));
        const auto [fitted, rest] = split(answers, share, random);
        for (const auto& [x, counts] : rest) judged->add(fitted, x, counts);
      }
    }
    for (const auto& [x, counts] : answers) {
      if (x == answers.begin()->first || x == answers.rbegin()->first) continue;
      AnswersByLevel others = answers;
      others.erase(x);
      level.add(others, x, counts);
    }
  }
  std::printf("| fitted to | by | log score | error of noticeability | error of right answers |\n");
  half.print("a half");
  tenth.print("a tenth");
  level.print("the other contrasts");
  for (const Judgements* judged : {&half, &tenth}) {
    EXPECT_GT(judged->joint.log_score, judged->lines.log_score);
    EXPECT_GT(judged->joint.log_score, judged->ordinal.log_score);
  }
  EXPECT_GT(level.joint.log_score, level.ordinal.log_score);
}

}  // namespace
}  // namespace seamline::analysis
