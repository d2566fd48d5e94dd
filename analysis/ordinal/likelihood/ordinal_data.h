#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

namespace seamline::analysis {

/// Scores on an ordered scale with what may explain them, an observation a row. No column of ones: the cuts
/// between the scores take its place.
struct OrdinalData {
  std::vector<int> score;                    ///< lowest..highest
  Eigen::MatrixXd predictors;                ///< observations x predictors, any units
  std::vector<std::string> predictor_names;  ///< one a column, for verdicts and tables
  std::vector<int> participant;  ///< 0-based number of the person of each row; may be empty for fits without
                                 ///< participants
  int lowest = 0;
  int highest = 4;
};

/// Throws InputError, naming row and column, when sizes differ, a score is off the scale, a predictor is not
/// finite or a participant's number is negative.
void check_ordinal_data(const OrdinalData& data);

/// The data as fits use them: empty scores taken out of the scale, columns centred and scaled, rows sorted by
/// participant.
struct OrdinalProblem {
  std::vector<int> used_scores;   ///< rising; category c stands for used_scores[c]
  std::vector<int> empty_scores;  ///< of the scale, which nobody gave
  std::vector<int> category;      ///< 0..categories-1, a row
  Eigen::MatrixXd x;              ///< rows x predictors, each column with mean 0 and root mean square 1
  Eigen::VectorXd column_mean, column_scale;  ///< scale 0: the column is constant
  std::vector<Eigen::Index> first_row;  ///< participants + 1 entries; {0, rows} when participants are ignored
  std::vector<int> participant_number;  ///< the input's number of each participant, rising

  [[nodiscard]] int categories() const { return static_cast<int>(used_scores.size()); }
  [[nodiscard]] int cuts() const { return categories() - 1; }
  [[nodiscard]] Eigen::Index rows() const { return x.rows(); }
  [[nodiscard]] int participants() const { return static_cast<int>(first_row.size()) - 1; }
};

/// `with_participants` false ignores `data.participant`.
[[nodiscard]] OrdinalProblem prepare(const OrdinalData& data, bool with_participants);

/// The matrix that takes parameters of the centred and scaled columns to those of the columns as given:
/// beta = beta' / scale, cut = cut' + sum mean beta. `with_sd` adds the participants' standard deviation, the
/// same in both.
[[nodiscard]] Eigen::MatrixXd to_given_units(const OrdinalProblem& problem, bool with_sd);

/// "0|1", "1|2", ... between the used scores.
[[nodiscard]] std::vector<std::string> cut_names(const OrdinalProblem& problem);

}  // namespace seamline::analysis
