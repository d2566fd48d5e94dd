#include "laboratory/stability/statistics/ordinal_people.h"

#include <array>
#include <cmath>

#include "support/arithmetic/random.h"

namespace seamline::stability {

OrdinalData simulated_ordinal_scores(int people, std::uint64_t seed) {
  constexpr std::array<double, 4> cuts = {-2, -0.5, 0.7, 2};
  OrdinalData data;
  data.predictors.resize(people * 21, 3);
  data.predictor_names = {"octaves", "object2", "object3"};
  int row = 0;
  for (int p = 0; p < people; ++p) {
    Random random(seed, static_cast<std::uint64_t>(p));
    const double level = 0.8 * random.normal();
    for (int object = 1; object <= 3; ++object)
      for (int octaves = -3; octaves <= 3; ++octaves, ++row) {
        data.predictors.row(row) << octaves, object == 2, object == 3;
        const double eta = level - 1.1 * octaves + (object == 2 ? 0.3 : object == 3 ? -0.3 : 0);
        const double share = random.uniform();
        int score = 0;
        for (const double cut : cuts) score += share >= 1 / (1 + std::exp(eta - cut)) ? 1 : 0;
        data.score.push_back(score);
        data.participant.push_back(p);
      }
  }
  return data;
}

}  // namespace seamline::stability
