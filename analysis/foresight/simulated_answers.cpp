#include "analysis/foresight/simulated_answers.h"

namespace seamline::analysis {

SimulatedAnswers simulate_answers(const PlannedPopulation& population,
                                  const std::vector<PlannedCurve>& curves, const std::vector<double>& levels,
                                  int people, std::uint64_t seed, std::uint64_t first_stream) {
  const PlannedTask& task = population.task;
  SimulatedAnswers answers{
      .level_x = x_of_levels(population.axis, levels), .task = task, .counts = {}, .references = {}};
  answers.counts.setZero(people,
                         static_cast<Eigen::Index>(curves.size() * levels.size()) * answers.cell_counts());
  answers.references.setZero(people, task.ratings());
  if (task.references > 0) answers.false_alarms.setZero(people);
  for (int p = 0; p < people; ++p) {
    Random random(seed, first_stream + p);
    const PlannedPerson person = draw_person(population, curves.size(), random);
    for (std::size_t curve = 0; curve < curves.size(); ++curve)
      for (std::size_t level = 0; level < levels.size(); ++level)
        for (int shown = 0; shown < curves[curve].objects * task.repetitions; ++shown) {
          const PlannedAnswer answer =
              answer_of(population, person, curves, curve, levels[level],
                        static_cast<std::uint64_t>(shown % task.facts.alternatives), random);
          const int place = (answer.right ? 0 : task.ratings()) + answer.rating - 1;
          answers.counts(p, answers.first_count(curve, level) + place) += 1;
        }
    for (int reference = 0; reference < task.references; ++reference) {
      const PlannedAnswer answer = guess_of(population, 0, random);
      answers.references(p, answer.rating - 1) += 1;
      answers.false_alarms[p] += answer.right ? 1 : 0;
    }
  }
  return answers;
}

double chance_of(const SimulatedAnswers& answers, int people) {
  if (!answers.task.facts.right_is_yes) return answers.task.chance();
  return (answers.false_alarms.head(people).sum() + 0.5) / (people * answers.task.references + 1.0);
}

Eigen::MatrixXd scores_of(const SimulatedAnswers& answers, std::size_t curve, int people,
                          std::optional<double> guess_rating) {
  const auto levels = static_cast<Eigen::Index>(answers.level_x.size());
  const Eigen::Index ratings = answers.task.ratings();
  const double chance = chance_of(answers, people);
  Eigen::VectorXd worth = Eigen::VectorXd::Zero(answers.cell_counts());
  for (Eigen::Index rating = 0; rating < ratings; ++rating) worth[rating] = static_cast<double>(rating + 1);
  if (guess_rating) worth.tail(ratings).setConstant(-*guess_rating * chance / (1 - chance));
  Eigen::MatrixXd scores(people, levels);
  for (Eigen::Index level = 0; level < levels; ++level) {
    const auto counts = answers.counts.block(0, answers.first_count(curve, static_cast<std::size_t>(level)),
                                             people, answers.cell_counts());
    scores.col(level) = ((counts * worth).array() / counts.rowwise().sum().array()).matrix();
  }
  return scores;
}

double mean_guess_rating(const SimulatedAnswers& answers, int people) {
  double wrong = 0, ratings = 0;
  for (Eigen::Index cell = 0; cell < answers.counts.cols(); cell += answers.cell_counts())
    for (int rating = 1; rating <= answers.task.ratings(); ++rating) {
      const double count = answers.counts.col(cell + answers.task.ratings() + rating - 1).head(people).sum();
      wrong += count;
      ratings += rating * count;
    }
  return wrong > 0 ? ratings / wrong : 1;
}

}  // namespace seamline::analysis
