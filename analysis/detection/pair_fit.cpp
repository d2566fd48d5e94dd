#include "analysis/detection/pair_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "support/text/error.h"

namespace seamline::analysis {
namespace {

struct Half {
  std::vector<SeenPair> pairs;
  std::vector<MeasuredDifference> measured;

  [[nodiscard]] int looks() const {
    return std::accumulate(pairs.begin(), pairs.end(), 0,
                           [](int sum, const SeenPair& pair) { return sum + pair.looks; });
  }
  [[nodiscard]] int seen() const {
    return std::accumulate(pairs.begin(), pairs.end(), 0,
                           [](int sum, const SeenPair& pair) { return sum + pair.seen; });
  }
};

/// log2 likelihood of all looks of a pair; certainty is bounded so that one look against it is no infinity.
double pair_bits(const SeenPair& pair, double right) {
  const double bounded = std::clamp(right, 1e-6, 1 - 1e-6);
  return pair.seen * std::log2(bounded) + (pair.looks - pair.seen) * std::log2(1 - bounded);
}

double total_bits(const SeenModel& model, const std::vector<SeenPair>& pairs,
                  const std::vector<MeasuredDifference>& measured) {
  double sum = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    sum += pair_bits(pairs[i], right_probability(model, measured[i], pairs[i].chance));
  return sum;
}

double bits_of(const SeenModel& model, const Half& half) {
  return total_bits(model, half.pairs, half.measured) / half.looks();
}

/// Area under the curve of hits over false alarms as the measure's criterion falls; ties count a half.
double roc_area(DifferenceMeasure measure, const Half& half) {
  std::map<double, std::pair<double, double>> seen_and_not;
  for (std::size_t i = 0; i < half.pairs.size(); ++i) {
    auto& [seen, not_seen] = seen_and_not[value_of(half.measured[i], measure)];
    seen += half.pairs[i].seen;
    not_seen += half.pairs[i].looks - half.pairs[i].seen;
  }
  double area = 0, not_seen_below = 0;
  for (const auto& [value, counts] : seen_and_not) {
    area += counts.first * (not_seen_below + counts.second / 2);
    not_seen_below += counts.second;
  }
  return area / (static_cast<double>(half.seen()) * not_seen_below);
}

std::vector<CalibrationGroup> calibration_of(const SeenModel& model, const Half& half) {
  constexpr std::size_t groups = 5;
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < half.pairs.size(); ++i)
    order.emplace_back(right_probability(model, half.measured[i], half.pairs[i].chance), i);
  std::sort(order.begin(), order.end());
  const std::size_t count = std::min(groups, order.size());
  std::vector<CalibrationGroup> calibration(count);
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    CalibrationGroup& group = calibration[rank * count / order.size()];
    const SeenPair& pair = half.pairs[order[rank].second];
    group.predicted += order[rank].first * pair.looks;
    group.seen += pair.seen;
    group.looks += pair.looks;
  }
  for (CalibrationGroup& group : calibration) {
    group.predicted /= group.looks;
    group.seen /= group.looks;
  }
  return calibration;
}

JudgedModel judged_model(DifferenceMeasure measure, const Half& fitted, const Half& other) {
  JudgedModel result{.model = fit_seen_model(measure, fitted.pairs, fitted.measured), .calibration = {}};
  result.fitted_bits = bits_of(result.model, fitted);
  result.judged_bits = bits_of(result.model, other);
  result.roc_area = roc_area(measure, other);
  result.calibration = calibration_of(result.model, other);
  return result;
}

void require_both_answers(const Half& half, const char* which) {
  const int seen = half.seen();
  if (seen > 0 && seen < half.looks()) return;
  throw input_error(
      {.field = "seen",
       .wanted = std::string("pairs that were seen and looks that were not in the ") + which + " half",
       .found = seen == 0 ? "nothing seen" : "everything seen"});
}

double constant_bits(const Half& fitted, const Half& other) {
  const double share = static_cast<double>(fitted.seen()) / fitted.looks();
  double sum = 0;
  for (const SeenPair& pair : other.pairs) sum += pair_bits(pair, share);
  return sum / other.looks();
}

}  // namespace

double right_probability(const SeenModel& model, const MeasuredDifference& measured, double chance) {
  const double difference = value_of(measured, model.measure);
  if (!(difference > 0)) return chance;
  const double seen = 1 / (1 + std::exp(-std::log2(model.gain * difference) / model.scale_octaves));
  return chance + (1 - chance) * seen;
}

SeenModel fit_seen_model(DifferenceMeasure measure, const std::vector<SeenPair>& pairs,
                         const std::vector<MeasuredDifference>& measured) {
  const auto model_at = [&](double log_gain, double log_scale) {
    return SeenModel{.measure = measure, .gain = std::exp2(log_gain), .scale_octaves = std::exp2(log_scale)};
  };
  double log_gain = 0, log_scale = 0;
  double best = total_bits(model_at(0, 0), pairs, measured);
  // Compass search: the likelihood of a logistic has one maximum along each axis.
  double step = 8;
  while (step > 1e-7) {
    bool better = false;
    constexpr std::array<std::array<double, 2>, 4> directions = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    for (const auto& [along_gain, along_scale] : directions) {
      const double gain_there = std::clamp(log_gain + step * along_gain, -40.0, 40.0);
      const double scale_there = std::clamp(log_scale + step * along_scale, -5.0, 5.0);
      const double bits = total_bits(model_at(gain_there, scale_there), pairs, measured);
      if (!(bits > best)) continue;
      best = bits;
      log_gain = gain_there;
      log_scale = scale_there;
      better = true;
    }
    if (!better) step /= 2;
  }
  return model_at(log_gain, log_scale);
}

PairJudgement judge_pairs(const std::vector<SeenPair>& pairs,
                          const std::vector<MeasuredDifference>& measured) {
  std::map<std::string, std::size_t> reference_places;
  for (const SeenPair& pair : pairs)
    reference_places.emplace(pair.reference.lexically_normal().string(), reference_places.size());
  PairJudgement result{.references = static_cast<int>(reference_places.size()),
                       .split_by_reference = reference_places.size() >= 4,
                       .observer = {},
                       .others = {}};
  std::array<Half, 2> halves;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::size_t place =
        result.split_by_reference ? reference_places.at(pairs[i].reference.lexically_normal().string()) : i;
    halves[place % 2].pairs.push_back(pairs[i]);
    halves[place % 2].measured.push_back(measured[i]);
  }
  const auto& [fitted, other] = halves;
  require_both_answers(fitted, "first");
  require_both_answers(other, "second");
  result.fitted_pairs = static_cast<int>(fitted.pairs.size());
  result.judged_pairs = static_cast<int>(other.pairs.size());
  result.constant_bits = constant_bits(fitted, other);
  for (std::size_t place = 0; place < compared_exponents.size(); ++place) {
    const JudgedModel model = judged_model(difference_measure(place), fitted, other);
    if (place == 0 || model.fitted_bits > result.observer.fitted_bits) result.observer = model;
  }
  for (const DifferenceMeasure measure :
       {DifferenceMeasure::pooled_3, DifferenceMeasure::mean_flip, DifferenceMeasure::largest_flip,
        DifferenceMeasure::root_mean_square})
    result.others.push_back(judged_model(measure, fitted, other));
  return result;
}

}  // namespace seamline::analysis
