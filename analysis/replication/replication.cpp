#include "analysis/replication/replication.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/statistics/distributions.h"
#include "support/arithmetic/random.h"

namespace seamline::analysis {
namespace {

/// The curve of an artifact and condition; where the published values name no condition, the only curve.
std::optional<int> curve_of(const JointAnalysis& joint, const PublishedThreshold& published) {
  std::optional<int> found;
  for (std::size_t c = 0; c < joint.labels.size(); ++c) {
    if (joint.labels[c].artifact != word(published.artifact)) continue;
    if (joint.labels[c].condition == published.condition) return static_cast<int>(c);
    if (!published.condition.empty()) continue;
    if (found) return std::nullopt;  // several conditions, and none was named
    found = static_cast<int>(c);
  }
  return found;
}

JointQuantity quantity_of(const PublishedThreshold& published) {
  return *std::find_if(every_joint_quantity.begin(), every_joint_quantity.end(),
                       [&](JointQuantity one) { return word(one) == published.quantity; });
}

struct ReplicationInterval {
  double low = below_every_level, high = above_every_level;
};

/// Half lengths of an estimate's interval below and above it; infinite where open.
struct Reach {
  double below = 0, above = 0;
};

/// On the axis. `shorter` scales both sides.
ReplicationInterval difference_interval(double difference, const Reach& here, const Reach& published,
                                        double shorter) {
  return {difference - shorter * std::hypot(here.below, published.above),
          difference + shorter * std::hypot(here.above, published.below)};
}

Reach reach_of_published(const LevelAxis& axis, const PublishedThreshold& published) {
  if (!published.low) return {};
  const double x = x_of(axis, *published.level), one = x_of(axis, *published.low),
               other = x_of(axis, *published.high);
  return {x - std::min(one, other), std::max(one, other) - x};
}

/// From the axis to levels: where noticeability rises with the level the ends change places.
void set_difference(ReplicatedThreshold& row, const LevelAxis& axis, double difference_x,
                    const ReplicationInterval& interval95) {
  row.difference = difference_at(axis, difference_x);
  double low = interval95.low, high = interval95.high;
  if (axis.noticeability == Direction::increasing) std::swap(low, high);
  if (std::isfinite(low)) row.low95 = difference_at(axis, low);
  if (std::isfinite(high)) row.high95 = difference_at(axis, high);
}

ReplicatedThreshold replicated(const JointAnalysis& joint, const PublishedThreshold& published,
                               double margin_x) {
  ReplicatedThreshold row{.published = published,
                          .here = {},
                          .inside = false,
                          .difference = {},
                          .low95 = {},
                          .high95 = {},
                          .verdict = ReplicationVerdict::not_tested};
  const std::optional<int> curve = curve_of(joint, published);
  if (!curve) return row;
  row.here = threshold_of(joint, *curve, quantity_of(published)).here;
  if (!published.level) {
    row.verdict = ReplicationVerdict::not_reported;
    return row;
  }
  const double published_x = x_of(joint.axis, *published.level);
  row.inside = published_x >= row.here.ci95.low_x && published_x <= row.here.ci95.high_x;
  row.verdict = ReplicationVerdict::no_estimate;
  if (!row.here.level_x) return row;
  const double difference_x = *row.here.level_x - published_x;
  const Reach here = {*row.here.level_x - row.here.ci95.low_x, row.here.ci95.high_x - *row.here.level_x};
  const Reach theirs = reach_of_published(joint.axis, published);
  const double freedom = std::max(1, joint.fit.people - 1);
  const double shorter = student_quantile(freedom, 0.95) / student_quantile(freedom, 0.975);
  const ReplicationInterval interval95 = difference_interval(difference_x, here, theirs, 1);
  const ReplicationInterval interval90 = difference_interval(difference_x, here, theirs, shorter);
  set_difference(row, joint.axis, difference_x, interval95);
  if (interval90.low > -margin_x && interval90.high < margin_x)
    row.verdict = ReplicationVerdict::agrees;
  else if (interval95.low > 0 || interval95.high < 0)
    row.verdict = ReplicationVerdict::differs;
  else
    row.verdict = ReplicationVerdict::undecided;
  return row;
}

/// What a person adds to a threshold: pseudo-values less their mean. Empty where a threshold without somebody
/// is not there.
std::vector<double> deviations_of_people(const JointAnalysis& joint, int curve, JointQuantity quantity) {
  const double n = joint.left_out.theta.rows();
  std::vector<double> deviations;
  double mean = 0;
  for (Eigen::Index person = 0; person < joint.left_out.theta.rows(); ++person) {
    const Eigen::VectorXd theta = joint.left_out.theta.row(person);
    const std::optional<JointPlace> place = place_of(joint.fit.model, theta, curve, quantity);
    if (!place) return {};
    deviations.push_back(-(n - 1) * place->x);
    mean += deviations.back() / n;
  }
  for (double& deviation : deviations) deviation -= mean;
  return deviations;
}

struct OrderedCurve {
  std::string artifact;
  double published_level = 0, here_level = 0, here_x = 0;
  std::vector<double> deviations;
};

std::vector<std::string> artifacts_of(const std::vector<OrderedCurve>& curves) {
  std::vector<std::string> names;
  names.reserve(curves.size());
  for (const OrderedCurve& curve : curves) names.push_back(curve.artifact);
  return names;
}

/// The share of draws of people in which the curves' levels rise as they stand.
double probability_of_order(const std::vector<OrderedCurve>& curves, bool x_rises_with_level,
                            const ReplicationRequest& request) {
  const std::size_t people = curves.front().deviations.size();
  Random random(request.seed, 50);
  std::vector<std::uint64_t> drawn(people);
  int kept = 0;
  for (int r = 0; r < request.replicates; ++r) {
    for (std::uint64_t& person : drawn) person = random.below(people);
    double before = 0;
    bool rises = true;
    for (std::size_t c = 0; c < curves.size(); ++c) {
      double sum = 0;
      for (const std::uint64_t person : drawn) sum += curves[c].deviations[person];
      const double x = curves[c].here_x + sum / people;
      const double along = x_rises_with_level ? x : -x;
      rises = rises && (c == 0 || along > before);
      before = along;
    }
    kept += rises ? 1 : 0;
  }
  return static_cast<double>(kept) / request.replicates;
}

std::optional<ReplicatedOrder> replicated_order(const JointAnalysis& joint, std::vector<OrderedCurve> curves,
                                                const std::string& quantity, const std::string& condition,
                                                const ReplicationRequest& request) {
  if (curves.size() < 2) return std::nullopt;
  std::stable_sort(curves.begin(), curves.end(), [](const OrderedCurve& a, const OrderedCurve& b) {
    return a.published_level < b.published_level;
  });
  ReplicatedOrder order{.quantity = quantity,
                        .condition = condition,
                        .artifacts = artifacts_of(curves),
                        .found = {},
                        .probability = 0};
  order.probability =
      probability_of_order(curves, joint.axis.noticeability == Direction::decreasing, request);
  std::stable_sort(curves.begin(), curves.end(),
                   [](const OrderedCurve& a, const OrderedCurve& b) { return a.here_level < b.here_level; });
  order.found = artifacts_of(curves);
  return order;
}

}  // namespace

std::string_view word(ReplicationVerdict verdict) {
  switch (verdict) {
    case ReplicationVerdict::agrees:
      return "agrees within the margin";
    case ReplicationVerdict::differs:
      return "differs";
    case ReplicationVerdict::undecided:
      return "undecided";
    case ReplicationVerdict::no_estimate:
      return "no number here";
    case ReplicationVerdict::not_reported:
      return "not reported there";
    case ReplicationVerdict::not_tested:
      return "not tested here";
  }
  return {};
}

int Replication::count(ReplicationVerdict verdict) const {
  return static_cast<int>(
      std::count_if(thresholds.begin(), thresholds.end(),
                    [&](const ReplicatedThreshold& row) { return row.verdict == verdict; }));
}

Replication compare_with_published(const JointAnalysis& joint, const ReplicationRequest& request) {
  Replication out{.name = request.published.name,
                  .sha256 = request.published.sha256,
                  .margin = request.margin,
                  .thresholds = {},
                  .orders = {}};
  const double margin_x = request.margin / (is_linear(joint.axis) ? joint.axis.unit : 1);
  std::vector<std::pair<std::string, std::string>> orders;  // quantity and condition, as they come
  std::map<std::pair<std::string, std::string>, std::vector<OrderedCurve>> comparable;
  for (const PublishedThreshold& published : request.published.values) {
    out.thresholds.push_back(replicated(joint, published, margin_x));
    const ReplicatedThreshold& row = out.thresholds.back();
    if (!row.difference) continue;
    OrderedCurve curve{
        .artifact = std::string(word(published.artifact)),
        .published_level = *published.level,
        .here_level = level_at(joint.axis, *row.here.level_x),
        .here_x = *row.here.level_x,
        .deviations = deviations_of_people(joint, *curve_of(joint, published), quantity_of(published))};
    if (curve.deviations.empty()) continue;
    if (!comparable.contains({published.quantity, published.condition}))
      orders.emplace_back(published.quantity, published.condition);
    comparable[{published.quantity, published.condition}].push_back(std::move(curve));
  }
  for (const auto& of : orders)
    if (auto order = replicated_order(joint, comparable[of], of.first, of.second, request))
      out.orders.push_back(std::move(*order));
  return out;
}

}  // namespace seamline::analysis
