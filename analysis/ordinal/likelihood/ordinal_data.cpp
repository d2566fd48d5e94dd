#include "analysis/ordinal/likelihood/ordinal_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/text/error.h"

namespace seamline::analysis {

namespace {

/// A column whose spread is below this share of its size is constant.
constexpr double constant_share = 1e-12;

[[noreturn]] void complain(const std::string& field, const std::string& wanted, const std::string& found) {
  throw input_error({.field = field, .wanted = wanted, .found = found});
}

}  // namespace

void check_ordinal_data(const OrdinalData& data) {
  const auto rows = static_cast<Eigen::Index>(data.score.size());
  if (rows == 0) complain("scores", "at least one observation", "none");
  if (data.lowest >= data.highest)
    complain("scale", "a lowest score below the highest", fmt::format("{} to {}", data.lowest, data.highest));
  if (data.predictors.cols() > 0 && data.predictors.rows() != rows)
    complain("predictors", fmt::format("{} rows, one a score", rows), std::to_string(data.predictors.rows()));
  if (static_cast<Eigen::Index>(data.predictor_names.size()) != data.predictors.cols())
    complain("predictor names", fmt::format("{}, one a column", data.predictors.cols()),
             std::to_string(data.predictor_names.size()));
  if (!data.participant.empty() && data.participant.size() != data.score.size())
    complain("participants", fmt::format("{} numbers, one a score", rows),
             std::to_string(data.participant.size()));
  for (std::size_t i = 0; i < data.score.size(); ++i)
    if (data.score[i] < data.lowest || data.score[i] > data.highest)
      complain(fmt::format("score of observation {}", i + 1),
               fmt::format("{} to {}", data.lowest, data.highest), std::to_string(data.score[i]));
  for (std::size_t i = 0; i < data.participant.size(); ++i)
    if (data.participant[i] < 0)
      complain(fmt::format("participant of observation {}", i + 1), "a number from 0",
               std::to_string(data.participant[i]));
  for (Eigen::Index j = 0; j < data.predictors.cols(); ++j)
    for (Eigen::Index i = 0; i < rows; ++i)
      if (!std::isfinite(data.predictors(i, j)))
        complain(fmt::format("predictor '{}' of observation {}", data.predictor_names[j], i + 1),
                 "a finite number", fmt::format("{}", data.predictors(i, j)));
}

OrdinalProblem prepare(const OrdinalData& data, bool with_participants) {
  OrdinalProblem problem;
  const auto rows = static_cast<Eigen::Index>(data.score.size());
  std::vector<int> category_of(static_cast<std::size_t>(data.highest - data.lowest + 1), -1);
  for (const int score : data.score) category_of[score - data.lowest] = 0;
  for (std::size_t s = 0; s < category_of.size(); ++s) {
    const int score = data.lowest + static_cast<int>(s);
    if (category_of[s] < 0) {
      problem.empty_scores.push_back(score);
    } else {
      category_of[s] = static_cast<int>(problem.used_scores.size());
      problem.used_scores.push_back(score);
    }
  }

  std::vector<std::size_t> order(data.score.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (with_participants)
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return data.participant[a] < data.participant[b]; });
  problem.x.resize(rows, data.predictors.cols());
  for (Eigen::Index row = 0; row < rows; ++row) {
    const std::size_t from = order[row];
    problem.category.push_back(category_of[static_cast<std::size_t>(data.score[from] - data.lowest)]);
    if (data.predictors.cols() > 0) problem.x.row(row) = data.predictors.row(static_cast<Eigen::Index>(from));
    if (!with_participants) continue;
    if (problem.participant_number.empty() || problem.participant_number.back() != data.participant[from]) {
      problem.participant_number.push_back(data.participant[from]);
      problem.first_row.push_back(row);
    }
  }
  if (!with_participants) problem.first_row.push_back(0);
  problem.first_row.push_back(rows);

  problem.column_mean = problem.x.colwise().mean().transpose();
  problem.column_scale.resize(problem.x.cols());
  for (Eigen::Index j = 0; j < problem.x.cols(); ++j) {
    auto column = problem.x.col(j);
    const double largest = column.cwiseAbs().maxCoeff();
    column.array() -= problem.column_mean[j];
    double scale = std::sqrt(column.squaredNorm() / static_cast<double>(rows));
    if (!(scale > constant_share * largest)) scale = 0;
    problem.column_scale[j] = scale;
    if (scale > 0) column /= scale;
  }
  return problem;
}

Eigen::MatrixXd to_given_units(const OrdinalProblem& problem, bool with_sd) {
  const Eigen::Index cuts = problem.cuts();
  const Eigen::Index columns = problem.x.cols();
  Eigen::MatrixXd map =
      Eigen::MatrixXd::Identity(cuts + columns + (with_sd ? 1 : 0), cuts + columns + (with_sd ? 1 : 0));
  for (Eigen::Index j = 0; j < columns; ++j) {
    map(cuts + j, cuts + j) = 1 / problem.column_scale[j];
    map.col(cuts + j).head(cuts).setConstant(problem.column_mean[j] / problem.column_scale[j]);
  }
  return map;
}

std::vector<std::string> cut_names(const OrdinalProblem& problem) {
  std::vector<std::string> names;
  for (std::size_t c = 0; c + 1 < problem.used_scores.size(); ++c)
    names.push_back(fmt::format("{}|{}", problem.used_scores[c], problem.used_scores[c + 1]));
  return names;
}

}  // namespace seamline::analysis
