#pragma once
#include <cmath>
#include <vector>

#include "analysis/ordinal/likelihood/link.h"
#include "analysis/ordinal/likelihood/ordinal_data.h"
#include "support/arithmetic/random.h"

namespace seamline::test {
using namespace analysis;

/// A population that scores by a cumulative link model: cuts, slopes over octaves of width and for two of
/// three objects, and participants who differ in level and, if wanted, in slope.
struct OrdinalPopulation {
  Link link = Link::logit;
  std::vector<double> cuts = {-2, -0.5, 0.7, 2};
  double slope = -1.1;
  double object2 = 0.3, object3 = -0.3;
  double sd = 0.8;
  double slope_sd = 0;
};

inline int draw_score(Link link, const std::vector<double>& cuts, double eta, Random& random) {
  const double level = random.uniform();
  int score = 0;
  for (const double cut : cuts) score += level >= cumulative(link, cut - eta) ? 1 : 0;
  return score;
}

/// Seven widths x three objects a participant; columns "octaves" (-3 to 3), "object2", "object3".
inline OrdinalData simulate_scores(const OrdinalPopulation& population, int people, std::uint64_t seed,
                                   int objects = 3) {
  OrdinalData data;
  const int rows = people * 7 * objects;
  data.predictors.resize(rows, 3);
  data.predictor_names = {"octaves", "object2", "object3"};
  int row = 0;
  for (int p = 0; p < people; ++p) {
    Random random(seed, static_cast<std::uint64_t>(p));
    const double level = population.sd * random.normal();
    const double slope = population.slope + population.slope_sd * random.normal();
    for (int object = 1; object <= objects; ++object)
      for (int width = -3; width <= 3; ++width, ++row) {
        data.predictors.row(row) << width, object == 2, object == 3;
        const double eta = slope * width + (object == 2 ? population.object2 : 0) +
                           (object == 3 ? population.object3 : 0) + level;
        data.score.push_back(draw_score(population.link, population.cuts, eta, random));
        data.participant.push_back(p);
      }
  }
  if (objects < 3) {
    data.predictors.conservativeResize(rows, objects == 2 ? 2 : 1);
    data.predictor_names.resize(objects == 2 ? 2 : 1);
  }
  return data;
}

}  // namespace seamline::test
