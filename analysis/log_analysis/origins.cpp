#include "analysis/log_analysis/origins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "analysis/ordinal/contrasts/contrasts.h"
#include "analysis/scores/cells.h"
#include "analysis/statistics/isotonic.h"
#include "support/arithmetic/random.h"

namespace seamline::analysis {

namespace {

constexpr int permutations_of_a_test = 9999;
constexpr std::uint64_t origin_salt = 0x6f726967696e;  // "origin"

bool is_web(const ParticipantUse& person) {
  return person.record.origin != study::Origin::window;
}

/// The people with those of the other group left out.
std::vector<ParticipantUse> one_group(std::vector<ParticipantUse> people, bool web) {
  for (ParticipantUse& person : people)
    if (person.use == Use::used && is_web(person) != web) person.use = Use::screened;
  return people;
}

OriginGroup group_of(const study::LogContents& log, const std::vector<ParticipantUse>& people, bool web,
                     const ResamplingRequest& request, const std::vector<std::string>& order) {
  const std::vector<ParticipantUse> own = one_group(people, web);
  OriginGroup group{
      .name = web ? "web" : "lab", .participants = count_participants(own).used, .thresholds = {}};
  for (const ArtifactScores& scores : average_answers(log, own, order).artifacts)
    group.thresholds.push_back(estimate_thresholds(scores, request));
  return group;
}

/// x at which mean noticeability is at a level; ends of what was tested where it is beyond.
double crossing(double level, const std::vector<double>& level_x, const std::vector<double>& isotonic) {
  const double x = largest_x_at(level, level_x, isotonic);
  if (std::isfinite(x)) return std::clamp(x, level_x.front(), level_x.back());
  return x == above_every_level ? level_x.back() : level_x.front();
}

constexpr std::array<double, 2> tested_heights = {perceptual_level, slight_level};

/// How far apart the thresholds of two groups of rows are.
class Distances {
 public:
  explicit Distances(const ArtifactScores& scores) : level_x_(levels_on_axis(scores)) {
    scores_ = scores.noticeability.leftCols(static_cast<Eigen::Index>(level_x_.size()));
  }
  [[nodiscard]] bool known() const { return !level_x_.empty(); }
  [[nodiscard]] std::array<double, 2> between(const std::vector<int>& in_web) const {
    const auto levels = static_cast<Eigen::Index>(level_x_.size());
    Eigen::VectorXd sums[2] = {Eigen::VectorXd::Zero(levels), Eigen::VectorXd::Zero(levels)};
    Eigen::VectorXd count[2] = {Eigen::VectorXd::Zero(levels), Eigen::VectorXd::Zero(levels)};
    for (Eigen::Index row = 0; row < scores_.rows(); ++row) {
      const int group = in_web[row];
      for (Eigen::Index level = 0; level < levels; ++level)
        if (!std::isnan(scores_(row, level)))
          sums[group][level] += scores_(row, level), count[group][level] += 1;
    }
    std::array<std::vector<double>, 2> isotonic;
    for (std::size_t group = 0; group < 2; ++group) {
      Eigen::VectorXd mean(levels);  // of both groups where nobody of this one answered
      for (Eigen::Index level = 0; level < levels; ++level)
        mean[level] = count[group][level] > 0
                          ? sums[group][level] / count[group][level]
                          : (sums[0][level] + sums[1][level]) / (count[0][level] + count[1][level]);
      isotonic[group] = fit_non_increasing({mean.data(), level_x_.size()}).value;
    }
    std::array<double, 2> distances = {};
    for (std::size_t q = 0; q < distances.size(); ++q)
      distances[q] = crossing(tested_heights[q], level_x_, isotonic[1]) -
                     crossing(tested_heights[q], level_x_, isotonic[0]);
    return distances;
  }

 private:
  std::vector<double> level_x_;
  Eigen::MatrixXd scores_;
};

/// p of the distances of PT and SN.
std::array<double, 2> permutation_p(const Distances& distances, std::vector<int> in_web, std::uint64_t seed,
                                    std::size_t curve) {
  constexpr double rounding = 1e-9;  // permutations that make the same groups are as far apart
  const std::array<double, 2> observed = distances.between(in_web);
  std::array<int, 2> as_far = {1, 1};
  for (int permutation = 0; permutation < permutations_of_a_test; ++permutation) {
    Random random(mix_bits(seed ^ origin_salt) + curve, permutation);
    shuffle(std::span<int>(in_web), random);
    const std::array<double, 2> found = distances.between(in_web);
    for (std::size_t q = 0; q < found.size(); ++q)
      as_far[q] += std::abs(found[q]) >= std::abs(observed[q]) - rounding ? 1 : 0;
  }
  return {as_far[0] / (permutations_of_a_test + 1.0), as_far[1] / (permutations_of_a_test + 1.0)};
}

const ArtifactThresholds* find_curve(const OriginGroup& group, const ArtifactScores& scores) {
  for (const ArtifactThresholds& one : group.thresholds)
    if (one.artifact == scores.artifact && one.condition == scores.condition) return &one;
  return nullptr;
}

void add_curve(const ArtifactScores& scores, std::size_t curve, const std::set<std::string>& web,
               std::uint64_t seed, OriginComparison& comparison) {
  const Distances distances(scores);
  if (!distances.known()) return;
  std::vector<int> in_web;
  for (const std::string& code : scores.people) in_web.push_back(web.contains(code) ? 1 : 0);
  const int of_web = static_cast<int>(std::count(in_web.begin(), in_web.end(), 1));
  const int of_lab = static_cast<int>(in_web.size()) - of_web;
  std::optional<std::array<double, 2>> p;
  if (of_web >= 2 && of_lab >= 2) p = permutation_p(distances, in_web, seed, curve);
  const ArtifactThresholds *lab_curve = find_curve(comparison.lab, scores),
                           *web_curve = find_curve(comparison.web, scores);
  for (std::size_t q = 0; q < tested_heights.size(); ++q) {
    OriginDifference found{.artifact = scores.artifact,
                           .condition = scores.condition,
                           .quantity = q == 0 ? "PT" : "SN",
                           .lab = of_lab,
                           .web = of_web,
                           .difference = {},
                           .p = {},
                           .p_holm = {}};
    if (p) found.p = (*p)[q];
    if (lab_curve != nullptr && web_curve != nullptr) {
      const auto x_of_group = [&](const ArtifactThresholds& thresholds) {
        return (q == 0 ? thresholds.estimates.perceptual : thresholds.estimates.slightly_noticeable).level_x;
      };
      const std::optional<double> lab_x = x_of_group(*lab_curve), web_x = x_of_group(*web_curve);
      if (lab_x && web_x) found.difference = difference_at(scores.axis, *web_x - *lab_x);
    }
    comparison.differences.push_back(found);
  }
}

void adjust(std::vector<OriginDifference>& differences) {
  std::vector<double> p;
  for (const OriginDifference& one : differences)
    p.push_back(one.p.value_or(std::numeric_limits<double>::quiet_NaN()));
  const std::vector<double> adjusted = holm_adjusted(p);
  for (std::size_t i = 0; i < p.size(); ++i)
    if (differences[i].p) differences[i].p_holm = adjusted[i];
}

}  // namespace

std::optional<OriginComparison> compare_origins(const study::LogContents& log,
                                                const std::vector<ParticipantUse>& people,
                                                const ResamplingRequest& request,
                                                const std::vector<std::string>& order) {
  std::set<std::string> web;
  bool any_lab = false;
  for (const ParticipantUse& person : people) {
    if (person.use != Use::used) continue;
    if (is_web(person))
      web.insert(person.record.code);
    else
      any_lab = true;
  }
  if (web.empty() || !any_lab) return std::nullopt;
  OriginComparison comparison{.lab = group_of(log, people, false, request, order),
                              .web = group_of(log, people, true, request, order),
                              .differences = {},
                              .permutations = permutations_of_a_test};
  const NoticeabilityData all = average_answers(log, people, order);
  for (std::size_t curve = 0; curve < all.artifacts.size(); ++curve)
    add_curve(all.artifacts[curve], curve, web, request.seed, comparison);
  adjust(comparison.differences);
  return comparison;
}

}  // namespace seamline::analysis
