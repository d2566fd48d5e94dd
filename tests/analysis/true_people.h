#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "stimuli/definition/artifact.h"
#include "support/arithmetic/random.h"

namespace seamline::test {

/// P(seen) of a distance of d scales between threshold and level, rising in d; 1/2 at d = 0 but for weibull.
enum class SeeingForm { logistic, normal, weibull };

/// How those who saw it rate.
enum class RatingForm {
  binomial,  ///< 1 + Binomial(3, P of a second curve), as the `threshold` observer of a study
  /// One strength for both, z = d + Normal(0, 1): seen where z > 0, rated by how many criteria it exceeds.
  strength
};

/// People of whom the true thresholds are known. They are made to differ from what is fitted to their
/// answers: other forms, and differences between people, objects and trials that no fitted model has. The
/// curves of a population are one curve moved along the axis, so no slope of one truly differs from that of
/// another.
struct TruePeople {
  std::string name = "default";
  std::array<double, 4> midpoint_px = {300, 180, 620, 900};  ///< in the order of `paper_artifacts`
  SeeingForm seeing = SeeingForm::logistic;
  RatingForm rating = RatingForm::binomial;
  double scale_octaves = 0.5;
  double people_sd = 0.5;       ///< octaves, of all of a person's thresholds
  double artifact_sd = 0;       ///< octaves, of a person's threshold under one artifact
  double rating_sd = 0;         ///< octaves, of where a person begins to rate high
  double slope_sd = 0;          ///< of the logarithm of a person's scale
  double late_share = 0;        ///< of people, a class of its own
  double late_octaves = 0;      ///< by which their thresholds lie lower
  double lapse = 0;             ///< mean of a person's lapses, Beta(1, 1 / lapse - 1)
  double object_octaves = 0;    ///< threshold of the left object lower by this, of the right one higher
  double learning_octaves = 0;  ///< by which thresholds rise from the first trial to the last
  std::array<double, 4> guess_rating = {1, 0, 0, 0};  ///< how those who saw nothing rate
};

inline constexpr int true_curves = 4, true_objects = 3;

/// One trial of a simulated person. Indices from 0.
struct TrueTrial {
  int curve = 0, level = 0, object = 0, chosen = 0;
  int rating = 0;  ///< 1 to 4
  [[nodiscard]] int score() const { return chosen == object ? rating : 0; }
};

namespace detail {

inline double seen_share(SeeingForm form, double d) {
  switch (form) {
    case SeeingForm::logistic:
      return 1 / (1 + std::exp(-d));
    case SeeingForm::normal:
      return std::erfc(-d / std::sqrt(2.0)) / 2;
    case SeeingForm::weibull:
      return -std::expm1(-std::exp(d));
  }
  return 0;
}

inline constexpr std::array<double, 3> strength_criteria = {0.7, 1.4, 2.1};

/// P(seen and rated k + 1 or more), k from 0, without lapses. `d` is the distance of seeing, `d_rating` that
/// of the person's rating curve.
inline double seen_and_rated(const TruePeople& people, double d, double d_rating, int k) {
  const double seen = seen_share(people.seeing, d);
  if (k == 0) return seen;
  if (people.rating == RatingForm::strength)
    return std::min(seen,
                    seen_share(people.seeing, d_rating - strength_criteria[static_cast<std::size_t>(k - 1)]));
  const double p = seen_share(people.seeing, d_rating), q = 1 - p;
  const std::array<double, 3> at_least = {1 - q * q * q, p * p * (3 - 2 * p), p * p * p};
  return seen * at_least[static_cast<std::size_t>(k - 1)];
}

struct TrueNode {
  double value = 0, weight = 1;
};

/// Normal(0, sd), by the rule of equal steps, which is exact beyond double precision for smooth integrands.
inline std::vector<TrueNode> normal_nodes(double sd, double step) {
  if (sd == 0) return {{}};
  std::vector<TrueNode> nodes;
  double sum = 0;
  const int steps = static_cast<int>(6 / step);
  for (int i = -steps; i <= steps; ++i) {
    const double z = i * step;
    nodes.push_back({.value = sd * z, .weight = std::exp(-z * z / 2)});
    sum += nodes.back().weight;
  }
  for (TrueNode& node : nodes) node.weight /= sum;
  return nodes;
}

/// All sums of a value of `a` and one of `b`.
inline std::vector<TrueNode> sums(const std::vector<TrueNode>& a, const std::vector<TrueNode>& b) {
  std::vector<TrueNode> all;
  for (const TrueNode& i : a)
    for (const TrueNode& j : b) all.push_back({.value = i.value + j.value, .weight = i.weight * j.weight});
  return all;
}

/// Everything that moves seeing and rating alike: people, their artifacts, classes, objects, trials.
inline std::vector<TrueNode> shift_nodes(const TruePeople& people) {
  std::vector<TrueNode> nodes = normal_nodes(std::hypot(people.people_sd, people.artifact_sd), 0.25);
  if (people.late_share > 0)
    nodes = sums(nodes, {{.value = 0, .weight = 1 - people.late_share},
                         {.value = -people.late_octaves, .weight = people.late_share}});
  if (people.object_octaves != 0)
    nodes = sums(nodes, {{.value = -people.object_octaves, .weight = 1.0 / 3},
                         {.value = 0, .weight = 1.0 / 3},
                         {.value = people.object_octaves, .weight = 1.0 / 3}});
  if (people.learning_octaves != 0) {
    constexpr int moments = 16;
    std::vector<TrueNode> trials;
    for (int i = 0; i < moments; ++i)
      trials.push_back(
          {.value = people.learning_octaves * ((i + 0.5) / moments - 0.5), .weight = 1.0 / moments});
    nodes = sums(nodes, trials);
  }
  return nodes;
}

}  // namespace detail

inline double mean_guess_rating(const TruePeople& people) {
  double mean = 0;
  for (std::size_t k = 0; k < people.guess_rating.size(); ++k)
    mean += static_cast<double>(k + 1) * people.guess_rating[k];
  return mean;
}

/// Mean noticeability of the population `octaves` above the midpoint of a curve, by integration over people,
/// objects and trials; without what guesses add where `corrected`.
inline double true_mean(const TruePeople& people, double octaves, bool corrected) {
  double mean = 0;
  const std::vector<detail::TrueNode> shifts = detail::shift_nodes(people);
  for (const detail::TrueNode& slope : detail::normal_nodes(people.slope_sd, 0.5))
    for (const detail::TrueNode& rating : detail::normal_nodes(people.rating_sd, 0.5)) {
      const double scale = people.scale_octaves * std::exp(slope.value);
      double of_these = 0;
      for (const detail::TrueNode& shift : shifts) {
        const double d = (shift.value - octaves) / scale;
        double rated = 0;
        for (int k = 0; k < 4; ++k) rated += detail::seen_and_rated(people, d, d + rating.value / scale, k);
        const double seen = (1 - people.lapse) * detail::seen_share(people.seeing, d);
        of_these += shift.weight * ((1 - people.lapse) * rated +
                                    (corrected ? 0 : (1 - seen) / 3 * mean_guess_rating(people)));
      }
      mean += slope.weight * rating.weight * of_these;
    }
  return mean;
}

/// How many octaves above its midpoint the mean noticeability of a curve truly equals `level`: by bisection,
/// within 1e-9. Infinite where the floor from guessing is not below the level.
inline double true_crossing_octaves(const TruePeople& people, double level, bool corrected) {
  if (!corrected && mean_guess_rating(people) / 3 >= level) return INFINITY;
  double low = -20, high = 20;
  while (high - low > 1e-9) {
    const double middle = (low + high) / 2;
    (true_mean(people, middle, corrected) > level ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// log2 of the width where each of PT, SN and both corrected for guessing truly lies, in this order.
inline std::array<double, 4> true_crossings_x(const TruePeople& people, int curve) {
  std::array<double, 4> x{};
  for (std::size_t q = 0; q < x.size(); ++q)
    x[q] = std::log2(people.midpoint_px[static_cast<std::size_t>(curve)]) +
           true_crossing_octaves(people, q % 2 == 0 ? 0.5 : 1, q >= 2);
  return x;
}

/// All answers of one person: every curve at every level with every object, in a random order.
inline std::vector<TrueTrial> answer_as_person(const TruePeople& people, std::span<const double> level_x,
                                               Random& random) {
  double shift = people.people_sd * random.normal();
  if (random.uniform() < people.late_share) shift -= people.late_octaves;
  const double rating_shift = people.rating_sd * random.normal();
  const double scale = people.scale_octaves * std::exp(people.slope_sd * random.normal());
  const double lapse = people.lapse > 0 ? 1 - std::pow(1 - random.uniform(), 1 / (1 / people.lapse - 1)) : 0;
  std::vector<TrueTrial> trials;
  std::array<double, true_curves> threshold_x{};
  for (int curve = 0; curve < true_curves; ++curve) {
    const auto c = static_cast<std::size_t>(curve);
    threshold_x[c] = std::log2(people.midpoint_px[c]) + shift + people.artifact_sd * random.normal();
    for (int level = 0; level < static_cast<int>(level_x.size()); ++level)
      for (int object = 0; object < true_objects; ++object)
        trials.push_back({.curve = curve, .level = level, .object = object});
  }
  if (people.learning_octaves != 0) shuffle(std::span(trials), random);
  for (std::size_t t = 0; t < trials.size(); ++t) {
    TrueTrial& trial = trials[t];
    const double moment = (static_cast<double>(t) + 0.5) / static_cast<double>(trials.size());
    const double x = threshold_x[static_cast<std::size_t>(trial.curve)] +
                     people.object_octaves * (trial.object - 1) + people.learning_octaves * (moment - 0.5);
    const double d = (x - level_x[static_cast<std::size_t>(trial.level)]) / scale;
    // One uniform number decides on seeing and rating: the shares of "rated k + 1 or more" lie in each other.
    const double u = random.uniform(), missed = random.uniform();
    if (missed >= lapse && u < detail::seen_share(people.seeing, d)) {
      trial.chosen = trial.object;
      trial.rating = 1;
      for (int k = 1; k < 4; ++k)
        trial.rating += u < detail::seen_and_rated(people, d, d + rating_shift / scale, k) ? 1 : 0;
      continue;
    }
    trial.chosen = static_cast<int>(random.below(true_objects));
    trial.rating = 1;
    double v = random.uniform();
    for (std::size_t k = 0; k < 3 && v >= people.guess_rating[k]; ++k) {
      v -= people.guess_rating[k];
      ++trial.rating;
    }
  }
  return trials;
}

/// The answers of `count` people; the first of them are the same for any count.
inline std::vector<std::vector<TrueTrial>> answer_as_people(const TruePeople& people, int count,
                                                            std::span<const double> level_x,
                                                            std::uint64_t seed) {
  std::vector<std::vector<TrueTrial>> all;
  for (int person = 0; person < count; ++person) {
    Random random(mix_bits(seed ^ 0x74727565), static_cast<std::uint64_t>(person));
    all.push_back(answer_as_person(people, level_x, random));
  }
  return all;
}

/// The populations of documentation/evidence/coverage.md.
inline std::vector<TruePeople> true_populations() {
  return {
      {.name = "default"},
      {.name = "unlike", .people_sd = 0.8, .rating_sd = 0.5},
      {.name = "steep", .seeing = SeeingForm::normal, .scale_octaves = 0.3, .people_sd = 0.3},
      {.name = "lapses",
       .people_sd = 0.7,
       .artifact_sd = 0.5,
       .rating_sd = 0.5,
       .slope_sd = 0.4,
       .lapse = 0.04,
       .object_octaves = 0.4,
       .guess_rating = {0.75, 0.25, 0, 0}},
      {.name = "guesses", .people_sd = 0.6, .rating_sd = 0.3, .guess_rating = {0.7, 0.2, 0.1, 0}},
      {.name = "edge", .midpoint_px = {900, 75, 1800, 2600}, .seeing = SeeingForm::weibull},
      {.name = "strength",
       .seeing = SeeingForm::normal,
       .rating = RatingForm::strength,
       .scale_octaves = 0.9,
       .people_sd = 0.6,
       .rating_sd = 0.4,
       .guess_rating = {0.9, 0.1, 0, 0}},
      {.name = "learning",
       .seeing = SeeingForm::normal,
       .scale_octaves = 0.8,
       .people_sd = 0.4,
       .late_share = 0.2,
       .late_octaves = 1.5,
       .learning_octaves = 0.8},
  };
}

/// The same people whose curves all lie at one midpoint: no threshold of one truly differs from another's.
inline TruePeople with_equal_midpoints(TruePeople people) {
  double sum = 0;
  for (const double px : people.midpoint_px) sum += std::log2(px) / true_curves;
  people.midpoint_px.fill(std::exp2(sum));
  return people;
}

}  // namespace seamline::test
