#include "analysis/joint/joint_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "support/text/error.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

[[noreturn]] void refuse_joint(const std::string& field, const std::string& wanted,
                               const std::string& found) {
  throw input_error({.field = "joint model: " + field, .wanted = wanted, .found = found});
}

void check_table(const Eigen::MatrixXd& table, const std::string& name, Eigen::Index columns,
                 std::size_t people) {
  if (table.cols() != columns || table.rows() != static_cast<Eigen::Index>(people))
    refuse_joint(name, fmt::format("{} people x {} counts", people, columns),
                 fmt::format("{} x {}", table.rows(), table.cols()));
  for (Eigen::Index row = 0; row < table.rows(); ++row)
    for (Eigen::Index column = 0; column < columns; ++column)
      if (!std::isfinite(table(row, column)) || table(row, column) < 0)
        refuse_joint(fmt::format("{}, row {}, column {}", name, row + 1, column + 1), "a count of at least 0",
                     fmt::format("{}", table(row, column)));
}

/// Counts of one cell of all people: right x chosen x rating becomes right or wrong x rating.
void fold_cell(const Eigen::MatrixXd& trials, Eigen::Index first, const CellShape& shape,
               Eigen::Ref<Eigen::MatrixXd> into) {
  const Eigen::Index ratings = into.cols() / 2;  // K
  for (int right = 1; right <= shape.positions; ++right)
    for (int chosen = 1; chosen <= shape.positions; ++chosen)
      for (int rating = 1; rating <= study::highest_rating; ++rating)
        into.col((chosen == right ? 0 : ratings) + std::min<Eigen::Index>(rating, ratings) - 1) +=
            trials.col(first + shape.place(right, chosen, rating));
}

/// b averaged over where the right answers were; of a cell that nobody answered over all places alike.
double chance_of_cell(const Eigen::VectorXd& counts, const CellShape& shape, const Guessers& guessers) {
  if (!(counts.sum() > 0)) return 1.0 / shape.positions;
  double sum = 0;
  for (int right = 0; right < shape.positions; ++right)
    sum += counts.segment(right * shape.of_trial(), shape.of_trial()).sum() * guessers.position[right];
  return sum / counts.sum();
}

}  // namespace

void check_joint_data(const JointData& data) {
  if (data.ratings < 1 || data.ratings > most_joint_ratings)
    refuse_joint("ratings", fmt::format("1 to {}", most_joint_ratings), fmt::format("{}", data.ratings));
  check_table(data.answers, "answers", static_cast<Eigen::Index>(data.cells.size()) * data.cell_counts(),
              data.people.size());
  check_table(data.references, "references", data.ratings, data.people.size());
  std::vector<int> cells(data.curves.size());
  for (std::size_t c = 0; c < data.cells.size(); ++c) {
    const JointCell& cell = data.cells[c];
    const std::string name = fmt::format("cell {}", c + 1);
    if (cell.curve < 0 || cell.curve >= std::ssize(cells))
      refuse_joint(name, fmt::format("a curve of {}", cells.size()), fmt::format("{}", cell.curve));
    if (std::isnan(cell.x) || cell.x == -infinity)
      refuse_joint(name, "a finite level, or one with nothing to see", fmt::format("{}", cell.x));
    if (!(cell.chance > 0 && cell.chance < 1))
      refuse_joint(name, "a chance between 0 and 1", fmt::format("{}", cell.chance));
    ++cells[cell.curve];
  }
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (cells[c] == 0) refuse_joint("curve " + data.curves[c], "at least one level", "none");
}

JointData joint_data(const GuessTrials& trials, const LevelAxis& axis, const Guessers& guessers) {
  JointData data{.curves = {},
                 .people = trials.people,
                 .cells = {},
                 .ratings = trials.task.rates ? most_joint_ratings : 1,
                 .answers = {},
                 .references = {}};
  const Eigen::Index width = data.cell_counts();
  const CellShape shape = trials.shape();
  const auto people = static_cast<Eigen::Index>(trials.people.size());
  const auto cells = static_cast<Eigen::Index>(trials.cells.size());
  data.answers = Eigen::MatrixXd::Zero(people, cells * width);
  data.references = Eigen::MatrixXd::Zero(people, width / 2);
  for (Eigen::Index c = 0; c < cells; ++c) {
    const GuessCell& cell = trials.cells[c];
    const GuessCell& before = trials.cells[static_cast<std::size_t>(c > 0 ? c - 1 : 0)];
    if (c == 0 || cell.artifact != before.artifact || cell.condition != before.condition)
      data.curves.push_back(std::string(word(cell.artifact)) + in_condition(cell.condition));
    fold_cell(trials.answers, c * shape.of_cell(), shape, data.answers.middleCols(c * width, width));
    const Eigen::VectorXd counts =
        trials.answers.middleCols(c * shape.of_cell(), shape.of_cell()).colwise().sum().transpose();
    data.cells.push_back({.curve = static_cast<int>(data.curves.size()) - 1,
                          .x = stands_apart(axis, cell.level) ? infinity : x_of(axis, cell.level),
                          .chance = chance_of_cell(counts, shape, guessers)});
  }
  // Without ratings references say nothing of how guessers rate, but of yes or no what chance is.
  const bool says_something = trials.task.rates || trials.task.right_is_yes;
  for (int place = 0; says_something && place < shape.of_trial(); ++place)
    data.references.col(std::min<Eigen::Index>(place % study::highest_rating, data.ratings - 1)) +=
        trials.references.col(place);
  return data;
}

JointData of_people(const JointData& data, const std::vector<Eigen::Index>& rows) {
  JointData some = data;
  some.people.clear();
  some.answers.resize(static_cast<Eigen::Index>(rows.size()), data.answers.cols());
  some.references.resize(static_cast<Eigen::Index>(rows.size()), data.references.cols());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    some.people.push_back(data.people[rows[r]]);
    some.answers.row(static_cast<Eigen::Index>(r)) = data.answers.row(rows[r]);
    some.references.row(static_cast<Eigen::Index>(r)) = data.references.row(rows[r]);
  }
  return some;
}

std::vector<double> levels_of_curve(const JointData& data, int curve) {
  std::set<double> levels;
  for (const JointCell& cell : data.cells)
    if (cell.curve == curve && std::isfinite(cell.x)) levels.insert(cell.x);
  return {levels.begin(), levels.end()};
}

}  // namespace seamline::analysis
