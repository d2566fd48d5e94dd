#pragma once
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/replication/replication.h"
#include "analysis/statistics/distributions.h"
#include "analysis/thresholds/paper_values.h"
#include "support/running/parallel.h"
#include "tests/analysis/true_joint.h"

namespace seamline::test {

/// The same people with their thresholds where the paper's Table 1 has them: PT of receiver and shadow, SN of
/// occlusion and overlap.
inline TruePeople people_of_the_paper(TruePeople people) {
  for (std::size_t c = 0; c < paper_artifacts.size(); ++c) {
    const PaperThresholds paper = *paper_thresholds(paper_artifacts[c]);
    const int published_px = paper.perceptual_px ? *paper.perceptual_px : *paper.slightly_noticeable_px;
    const double above = true_crossing_octaves(people, paper.perceptual_px ? 0.5 : 1, false);
    people.midpoint_px[c] = published_px / std::exp2(above);
  }
  return people;
}

/// A study of people of whom the truth is known as `analyze --published` needs it, in the paper's widths.
inline JointAnalysis replicating_study(const TruePeople& people, int count, std::uint64_t seed) {
  const std::vector<int> width_px = true_widths().front().width_px;
  const TrueStudy study{.width_px = width_px,
                        .people = answer_as_people(people, count, log2_widths(width_px), seed)};
  JointAnalysis joint;
  for (const Artifact artifact : paper_artifacts)
    joint.labels.push_back({.artifact = std::string(word(artifact)), .condition = "", .group = ""});
  joint.data = joint_data_of(study);
  joint.fit = fit_shared(joint.data, {}, true).fit;
  if (joint.fit.estimated()) joint.left_out = leave_people_out(joint.fit, joint.data, 1);
  joint.thresholds = joint_thresholds(joint.fit, joint.data, joint.left_out);
  return joint;
}

/// What is compared: PT, SN and both corrected of every artifact, at the truth, taken for exact as the
/// paper's values are.
inline PublishedThresholds published_truth(const TruePeople& people) {
  PublishedThresholds published{.name = "the truth", .sha256 = {}, .values = {}};
  for (int curve = 0; curve < true_curves; ++curve) {
    const std::array<double, 4> truth_x = true_crossings_x(people, curve);
    for (std::size_t q = 0; q < true_quantities.size(); ++q)
      published.values.push_back({.artifact = paper_artifacts[static_cast<std::size_t>(curve)],
                                  .condition = {},
                                  .quantity = true_quantities[q],
                                  .level = std::exp2(truth_x[q]),
                                  .low = {},
                                  .high = {},
                                  .participants = {},
                                  .source = "planted"});
  }
  return published;
}

/// What another study would have published, with its intervals. An open one says that there is no number.
inline PublishedThresholds published_by(const JointAnalysis& study) {
  PublishedThresholds published{.name = "another study", .sha256 = {}, .values = {}};
  for (const JointThreshold& threshold : study.thresholds) {
    if (static_cast<std::size_t>(threshold.quantity) >= true_quantities.size()) continue;
    const LevelInterval& ci95 = threshold.here.ci95;
    PublishedThreshold one{.artifact = paper_artifacts[static_cast<std::size_t>(threshold.curve)],
                           .condition = {},
                           .quantity = std::string(word(threshold.quantity)),
                           .level = {},
                           .low = {},
                           .high = {},
                           .participants = study.fit.people,
                           .source = "simulated"};
    if (threshold.here.level_x && std::isfinite(ci95.low_x) && std::isfinite(ci95.high_x)) {
      one.level = std::exp2(*threshold.here.level_x);
      one.low = std::exp2(ci95.low_x);
      one.high = std::exp2(ci95.high_x);
    }
    published.values.push_back(one);
  }
  return published;
}

/// Every level times 2^octaves.
inline PublishedThresholds moved(PublishedThresholds published, double octaves) {
  for (PublishedThreshold& one : published.values)
    for (std::optional<double>* level : {&one.level, &one.low, &one.high})
      if (*level) **level *= std::exp2(octaves);
  return published;
}

/// How often each verdict was given; `half` sums half lengths of the differences' intervals of 95 %.
struct VerdictTally {
  int all = 0, agrees = 0, differs = 0, undecided = 0, no_number = 0, closed = 0;
  double half = 0;

  void add(const Replication& replication) {
    for (const ReplicatedThreshold& row : replication.thresholds) {
      if (row.verdict == ReplicationVerdict::not_reported) continue;
      ++all;
      agrees += row.verdict == ReplicationVerdict::agrees ? 1 : 0;
      differs += row.verdict == ReplicationVerdict::differs ? 1 : 0;
      undecided += row.verdict == ReplicationVerdict::undecided ? 1 : 0;
      no_number += row.verdict == ReplicationVerdict::no_estimate ? 1 : 0;
      if (!row.low95 || !row.high95) continue;
      ++closed;
      half += (*row.high95 - *row.low95) / 2;
    }
  }
  [[nodiscard]] double percent(int count) const { return 100.0 * count / all; }
};

/// Shares of "agrees" and "differs" in percent.
struct PromisedVerdicts {
  double agrees = 0, differs = 0;
};

/// Of an estimate that is normal about the truth with the standard error of an interval of 95 % of t, `half`
/// long on each side: P of two one-sided tests at 5 % within the margin, and of the interval excluding 0
/// without that.
inline PromisedVerdicts promised_verdicts(double octaves, double half, double margin, int people) {
  const double t95 = analysis::student_quantile(people - 1, 0.975),
               t90 = analysis::student_quantile(people - 1, 0.95);
  const double se = half / t95, within = margin - t90 * se;
  const auto below = [&](double x) { return std::erfc(-(x - octaves) / se / std::sqrt(2.0)) / 2; };
  const double agrees = within > 0 ? below(within) - below(-within) : 0;
  const double excluded = 1 - (below(half) - below(-half));
  const double both = within > half ? below(within) - below(half) + below(-half) - below(-within) : 0;
  return {.agrees = 100 * agrees, .differs = 100 * (excluded - both)};
}

inline constexpr const char* replication_header =
    "population,published,moved_octaves,people,studies,thresholds,agrees_percent,promised_agrees,differs_percent,"
    "promised_differs,undecided_percent,no_number_percent,half_length_octaves\n";
inline constexpr const char* replication_orders_header =
    "population,people,studies,order,found_percent,median_probability,tenth_probability,above_95_percent\n";
inline constexpr std::array<double, 5> replication_octaves = {0, 0.25, 0.5, 1, 3};

/// How often an order of the paper's Table 1 was found, and how probable it was called.
struct OrderTally {
  std::vector<double> probability;
  int found = 0;
};

/// Rows of one population: how often thresholds are said to agree with and to differ from values that lie at
/// the truth and beside it, and the paper's order.
inline std::vector<VerdictTally> write_replications(const TruePeople& people, int count, int studies,
                                                    std::ostream& rates, std::ostream& orders) {
  constexpr double margin = 0.5;
  std::vector<JointAnalysis> found(static_cast<std::size_t>(studies));
  run_parallel(studies, 0, [&](int study) {
    found[static_cast<std::size_t>(study)] =
        replicating_study(people, count, 5000 + static_cast<std::uint64_t>(study));
  });
  const PublishedThresholds truth = published_truth(people);
  std::vector<VerdictTally> exact_tallies;
  for (const bool exact : {true, false})
    for (const double octaves : replication_octaves) {
      VerdictTally tally;
      for (std::size_t study = 0; study < found.size(); ++study)
        tally.add(analysis::compare_with_published(
            found[study],
            {.published = moved(exact ? truth : published_by(found[(study + 1) % found.size()]), octaves),
             .margin = margin,
             .replicates = 1}));
      const double half = tally.half / std::max(1, tally.closed);
      const PromisedVerdicts promised = promised_verdicts(octaves, half, margin, count);
      rates << people.name << "," << (exact ? "exact" : "by as many people") << "," << octaves << "," << count
            << "," << studies << "," << tally.all << "," << tally.percent(tally.agrees) << ","
            << promised.agrees << "," << tally.percent(tally.differs) << "," << promised.differs << ","
            << tally.percent(tally.undecided) << "," << tally.percent(tally.no_number) << "," << half << "\n";
      if (exact) exact_tallies.push_back(tally);
    }
  std::map<std::string, OrderTally> by_order;
  for (const JointAnalysis& study : found)
    for (const ReplicatedOrder& order :
         analysis::compare_with_published(
             study, {.published = analysis::read_published("paper"), .replicates = 2000})
             .orders) {
      if (order.quantity == "IP") continue;  // not planted
      std::string name = order.quantity + ":";
      for (const std::string& artifact : order.artifacts) name += " " + artifact;
      by_order[name].probability.push_back(order.probability);
      by_order[name].found += order.found == order.artifacts ? 1 : 0;
    }
  for (auto& [name, order] : by_order) {
    std::sort(order.probability.begin(), order.probability.end());
    const auto asked = static_cast<double>(order.probability.size());
    const auto certain = std::count_if(order.probability.begin(), order.probability.end(),
                                       [](double probability) { return probability > 0.95; });
    orders << people.name << "," << count << "," << studies << "," << name << "," << 100 * order.found / asked
           << "," << order.probability[order.probability.size() / 2] << ","
           << order.probability[order.probability.size() / 10] << ","
           << 100.0 * static_cast<double>(certain) / asked << "\n";
  }
  rates.flush();
  orders.flush();
  return exact_tallies;
}

}  // namespace seamline::test
