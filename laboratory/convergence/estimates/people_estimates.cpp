#include <array>
#include <cmath>

#include "analysis/foresight/plan_study.h"
#include "analysis/joint/joint_fit.h"
#include "laboratory/convergence/estimates/estimates.h"
#include "support/arithmetic/random.h"
#include "support/running/progress.h"

namespace seamline::renderer {
namespace {

using analysis::JointCurve;
using analysis::JointData;

constexpr std::array<double, 4> true_thresholds = {8.2, 7.5, 9.2, 9.8};  // of the artifacts, log2 of pixels
constexpr int objects_a_level = 3;
const JointCurve true_curve{
    .m = 0, .s = 1.1, .lapse = 0.02, .t = {0.2, 0.9, 1.7}, .rho = 0.9, .g = {0.7, 0.2, 0.06, 0.04}};

/// What people answer to four artifacts at the paper's seven widths, who all have the same curves.
JointData simulated_ratings(int people, Random& random) {
  JointData data;
  for (std::size_t curve = 0; curve < true_thresholds.size(); ++curve) {
    data.curves.push_back("artifact " + std::to_string(curve + 1));
    for (int octave = 6; octave <= 12; ++octave)
      data.cells.push_back({.curve = static_cast<int>(curve), .x = static_cast<double>(octave)});
  }
  for (int person = 0; person < people; ++person) data.people.push_back("p" + std::to_string(person + 1));
  data.answers =
      Eigen::MatrixXd::Zero(people, static_cast<Eigen::Index>(data.cells.size()) * data.cell_counts());
  data.references = Eigen::MatrixXd::Zero(people, data.ratings);
  for (std::size_t cell = 0; cell < data.cells.size(); ++cell) {
    JointCurve curve = true_curve;
    curve.m = true_thresholds[data.cells[cell].curve];
    const Eigen::VectorXd shares =
        analysis::outcome_probabilities(curve, data.cells[cell].x, data.cells[cell].chance);
    for (Eigen::Index person = 0; person < people; ++person)
      for (int object = 0; object < objects_a_level; ++object) {
        double left = random.uniform();
        Eigen::Index outcome = 0;
        while (outcome + 1 < shares.size() && left >= shares[outcome]) left -= shares[outcome++];
        data.answers(person, static_cast<Eigen::Index>(cell) * data.cell_counts() + outcome) += 1;
      }
  }
  return data;
}

double likelihood_seconds(const analysis::JointFit& fit, const JointData& data) {
  constexpr int evaluations = 2000;
  const analysis::JointCounts counts = analysis::all_counts(data);
  const double before = processor_seconds();
  double sum = 0;
  for (int i = 0; i < evaluations; ++i) sum += analysis::joint_log_likelihood(fit.model, counts, fit.theta);
  return (processor_seconds() - before + (std::isnan(sum) ? 1 : 0)) / evaluations;
}

/// The share of simulated studies whose intervals are all short enough, of the study's own levels.
double assurance_of(const std::filesystem::path& study_file, int studies, std::uint64_t seed) {
  constexpr int people = 12;
  const analysis::StudyPlan plan = analysis::plan_study({.study_file = study_file,
                                                         .wanted_length = 2,
                                                         .participants = {people},
                                                         .studies = studies,
                                                         .seed = seed,
                                                         .threads = 1});
  return plan.designs.front().assurance;
}

}  // namespace

EstimateResult measure_joint(std::uint64_t seed) {
  constexpr int fits = 20;
  EstimateResult result{.part = "joint",
                        .amount = "people",
                        .unit = "octaves",
                        .truth = "the four thresholds of the joint model that gave the answers and ratings",
                        .rows = {},
                        .limit = {.what = "one evaluation of the likelihood", .seconds_each = 0},
                        .expected = -0.5,
                        .why = "independent answers"};
  Progress progress("joint", 5);
  for (int people = 4; people <= 1024; people *= 4) {
    Random random(seed, people);
    double squares = 0, seconds = 0, found = 0;
    for (int i = 0; i < fits; ++i) {
      const JointData data = simulated_ratings(people, random);
      const double before = processor_seconds();
      const analysis::JointFit fit = analysis::fit_joint(data);
      seconds += processor_seconds() - before;
      if (!fit.estimated()) continue;
      for (std::size_t curve = 0; curve < true_thresholds.size(); ++curve) {
        const double off =
            analysis::curve_at(fit.model, fit.theta, static_cast<int>(curve)).m - true_thresholds[curve];
        squares += off * off;
        ++found;
      }
      if (i == 0) result.limit.seconds_each = likelihood_seconds(fit, data);
    }
    if (found > 0)
      result.rows.push_back(
          {"maximum likelihood", static_cast<double>(people), seconds / fits, std::sqrt(squares / found)});
    progress.advance(1, "people");
  }
  return result;
}

EstimateResult measure_plan(const std::filesystem::path& study_file, std::uint64_t seed) {
  constexpr int repeats = 4, many_studies = 320;
  EstimateResult result{
      .part = "plan",
      .amount = "studies",
      .unit = "of 1",
      .truth =
          "the share of 320 other simulated studies of 12 people whose intervals are all at most two octaves "
          "long",
      .rows = {},
      .limit = {.what = "one simulated study", .seconds_each = 0},
      .expected = -0.5,
      .why = "a share of independent studies"};
  const double truth = assurance_of(study_file, many_studies, seed + 1000);
  for (int studies = 5; studies <= 80; studies *= 4) {
    double squares = 0;
    const double before = processor_seconds();
    for (std::uint64_t i = 0; i < repeats; ++i) {
      const double off = assurance_of(study_file, studies, seed + i) - truth;
      squares += off * off;
    }
    const double seconds = (processor_seconds() - before) / repeats;
    result.limit.seconds_each = seconds / studies;
    result.rows.push_back(
        {"joint model", static_cast<double>(studies), seconds, std::sqrt(squares / repeats)});
  }
  return result;
}

}  // namespace seamline::renderer
