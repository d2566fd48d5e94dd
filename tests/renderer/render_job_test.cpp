// A render cut into elements: everything once, neighbours together, and as even as it can be.
#include "sets/cluster/render_job.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "stimuli/study_file/study_file.h"
#include "support/arithmetic/random.h"
#include "support/files/assets.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

/// Costs between 0.1 and 10 s, drawn.
JobCosts drawn_costs(const StudyDefinition& study, std::uint64_t seed) {
  Random random(seed, 0);
  JobCosts costs;
  costs.start = 0.5;
  for (const SceneDefinition& truth : list_truths(study)) costs.truths[truth.truth] = 20;
  for (const Stimulus& stimulus : list_stimuli(study)) {
    costs.stimuli[stimulus_id(stimulus)] = std::pow(10.0, 2 * random.uniform() - 1);
    costs.meshes[stimulus_id(stimulus)] = random.uniform();
  }
  return costs;
}

using MeshOfTruth = std::tuple<std::string, int, DepthSettings>;

/// Seconds of every mesh with its stimuli, in the order of rendering.
std::vector<std::pair<MeshOfTruth, double>> mesh_seconds(const StudyDefinition& study,
                                                         const JobCosts& costs) {
  std::vector<std::pair<MeshOfTruth, double>> out;
  for (const SceneDefinition& truth : list_truths(study)) {
    std::map<MeshOfTruth, double> seconds;
    for (const Stimulus& stimulus : list_stimuli(study)) {
      if (truth_of(stimulus) != truth.truth) continue;
      const auto [at, added] =
          seconds.emplace(MeshOfTruth{truth.truth, stimulus.object_index, stimulus.depth}, 0.0);
      if (added) at->second += costs.meshes.at(stimulus_id(stimulus));
      at->second += costs.stimuli.at(stimulus_id(stimulus));
    }
    out.insert(out.end(), seconds.begin(), seconds.end());
  }
  return out;
}

/// The least that the longest of so many pieces can take, by trying every place for the last cut.
double shortest_longest(const std::vector<std::pair<MeshOfTruth, double>>& meshes, int pieces) {
  const std::size_t count = meshes.size();
  std::vector<std::vector<double>> best(static_cast<std::size_t>(pieces) + 1,
                                        std::vector<double>(count + 1, 1e30));
  best[0][0] = 0;
  for (int k = 1; k <= pieces; ++k)
    for (std::size_t end = 1; end <= count; ++end) {
      double last = 0;
      for (std::size_t begin = end; begin-- > 0;) {
        if (std::get<0>(meshes[begin].first) != std::get<0>(meshes[end - 1].first)) break;
        last += meshes[begin].second;
        double& here = best[static_cast<std::size_t>(k)][end];
        here = std::min(here, std::max(last, best[static_cast<std::size_t>(k) - 1][begin]));
      }
    }
  double out = 1e30;
  for (const auto& row : best) out = std::min(out, row[count]);
  return out;
}

TEST(RenderJob, HoldsEveryStimulusOnceAndIsAsEvenAsCutsBetweenMeshesAllow) {
  const StudyDefinition study = read_study(builtin_study("quick"));
  const RenderRequest request{.set_folder = "none", .threads = 1};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const JobCosts costs = drawn_costs(study, seed);
    for (const int elements : {3, 4, 7, 12}) {
      const RenderJob job = plan_job(study, request, costs, elements);
      EXPECT_LE(static_cast<int>(job.elements.size()), elements);
      std::multiset<std::string> ids;
      std::map<MeshOfTruth, std::set<const JobElement*>> users;
      for (const JobElement& element : job.elements) ids.insert(element.ids.begin(), element.ids.end());
      std::map<std::string, const JobElement*> of_id;
      for (const JobElement& element : job.elements)
        for (const std::string& id : element.ids) of_id[id] = &element;
      const std::vector<Stimulus> stimuli = list_stimuli(study);
      EXPECT_EQ(ids.size(), stimuli.size());
      for (const Stimulus& stimulus : stimuli) {
        EXPECT_EQ(ids.count(stimulus_id(stimulus)), 1U);
        const JobElement* element = of_id.at(stimulus_id(stimulus));
        EXPECT_EQ(element->truth, truth_of(stimulus));
        users[{truth_of(stimulus), stimulus.object_index, stimulus.depth}].insert(element);
      }
      for (const auto& [mesh, elements_of_mesh] : users) EXPECT_EQ(elements_of_mesh.size(), 1U);
      EXPECT_NEAR(job.longest_element_s() - costs.start,
                  shortest_longest(mesh_seconds(study, costs), elements), 1e-6)
          << seed << " " << elements;
    }
  }
}

TEST(RenderJob, FewerElementsThanTruthsAreRefused) {
  const StudyDefinition study = read_study(builtin_study("quick"));
  try {
    (void)plan_job(study, {.set_folder = "none", .threads = 1}, drawn_costs(study, 1), 2);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("elements: wanted at least 3"));
  }
}

}  // namespace
}  // namespace seamline::renderer
