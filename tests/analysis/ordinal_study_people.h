#pragma once
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "study/log/log.h"
#include "tests/analysis/ordinal_people.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::test {
using namespace study;

/// Participants of the paper's study who score by a cumulative link model: 4 artifacts x 3 objects x 7
/// widths.
struct StudyPopulation {
  Link link = Link::logit;
  std::vector<double> cuts = {-1.5, -0.3, 0.7, 1.8};
  std::map<Artifact, double> level = {};  ///< at 512 px, default 0
  std::map<Artifact, double> slope = {};  ///< per octave, default -0.8
  std::map<int, double> object = {};      ///< by place, in every artifact
  double sd = 0.7;
  double slope_sd = 0;     ///< participants differ in how noticeability falls with width
  double artifact_sd = 0;  ///< and in how much each artifact disturbs them
  double group = 0;        ///< the first third of the participants
};

inline std::vector<Answer> simulate_answers(const StudyPopulation& population, int people,
                                            std::uint64_t seed) {
  const auto of = [](const auto& map, auto key, double otherwise) {
    const auto found = map.find(key);
    return found == map.end() ? otherwise : found->second;
  };
  std::vector<Answer> answers;
  for (int p = 0; p < people; ++p) {
    Random random(seed, static_cast<std::uint64_t>(p));
    const double level = population.sd * random.normal() + (3 * p < people ? population.group : 0);
    const double own_slope = population.slope_sd * random.normal();
    for (const Artifact artifact : paper_artifacts) {
      const double own = population.artifact_sd * random.normal();
      for (int object = 1; object <= 3; ++object)
        for (const int width_px : paper_widths_px) {
          const double octaves = std::log2(width_px / 512.0);
          const double eta = level + own + of(population.level, artifact, 0) +
                             of(population.object, object, 0) +
                             (of(population.slope, artifact, -0.8) + own_slope) * octaves;
          const int score = draw_score(population.link, population.cuts, eta, random);
          answers.push_back(answer("p" + std::to_string(p), width_px, object,
                                   score > 0 ? object : object % 3 + 1, score > 0 ? score : 1));
          answers.back().artifact = artifact;
          answers.back().scene = "scene-" + std::string(word(artifact));
        }
    }
  }
  return answers;
}

/// The first third "other", the rest "technical".
inline std::map<std::string, std::string> simulated_groups(int people) {
  std::map<std::string, std::string> groups;
  for (int p = 0; p < people; ++p) groups["p" + std::to_string(p)] = 3 * p < people ? "other" : "technical";
  return groups;
}

}  // namespace seamline::test
