#include "analysis/foresight/simulated_answers.h"

#include "study/placement/trial.h"

namespace seamline::analysis {

SimulatedAnswers simulate_answers(const PlannedPopulation& population,
                                  const std::vector<PlannedCurve>& curves, const std::vector<double>& levels,
                                  int people, std::uint64_t seed, std::uint64_t first_stream) {
  SimulatedAnswers answers{.level_x = x_of_levels(population.axis, levels), .counts = {}};
  answers.counts.setZero(people,
                         static_cast<Eigen::Index>(curves.size() * levels.size()) * counts_of_planned_cell);
  for (int p = 0; p < people; ++p) {
    Random random(seed, first_stream + static_cast<std::uint64_t>(p));
    const PlannedPerson person = draw_person(population, curves.size(), random);
    for (std::size_t curve = 0; curve < curves.size(); ++curve)
      for (std::size_t level = 0; level < levels.size(); ++level)
        for (int object = 0; object < curves[curve].objects; ++object) {
          const PlannedAnswer answer =
              answer_of(population, person, curves, curve, levels[level],
                        static_cast<std::uint64_t>(object % study::objects_per_stimulus), random);
          const int place = (answer.right ? 0 : study::highest_rating) + answer.rating - 1;
          answers.counts(p, answers.first_count(curve, level) + place) += 1;
        }
  }
  return answers;
}

Eigen::MatrixXd scores_of(const SimulatedAnswers& answers, std::size_t curve, int people,
                          std::optional<double> guess_rating) {
  const auto levels = static_cast<Eigen::Index>(answers.level_x.size());
  Eigen::VectorXd worth = Eigen::VectorXd::Zero(counts_of_planned_cell);
  worth.head(study::highest_rating).setLinSpaced(1, study::highest_rating);
  if (guess_rating)
    worth.tail(study::highest_rating).setConstant(-*guess_rating / (study::objects_per_stimulus - 1));
  Eigen::MatrixXd scores(people, levels);
  for (Eigen::Index level = 0; level < levels; ++level) {
    const auto counts = answers.counts.block(0, answers.first_count(curve, static_cast<std::size_t>(level)),
                                             people, counts_of_planned_cell);
    scores.col(level) = ((counts * worth).array() / counts.rowwise().sum().array()).matrix();
  }
  return scores;
}

double mean_guess_rating(const SimulatedAnswers& answers, int people) {
  double wrong = 0, ratings = 0;
  for (Eigen::Index cell = 0; cell < answers.counts.cols(); cell += counts_of_planned_cell)
    for (int rating = 1; rating <= study::highest_rating; ++rating) {
      const double count = answers.counts.col(cell + study::highest_rating + rating - 1).head(people).sum();
      wrong += count;
      ratings += rating * count;
    }
  return wrong > 0 ? ratings / wrong : 1;
}

}  // namespace seamline::analysis
