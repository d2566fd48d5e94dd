#include "study/placement/staircase.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

constexpr std::size_t reversals_left_out = 2;

/// Turns rising levels into levels from where most is seen to where least is.
void begin_where_most_is_seen(StaircaseDesign& design, Direction noticeability) {
  if (noticeability == Direction::decreasing) return;
  for (StimulusTrack& curve : design.curves) {
    std::reverse(curve.levels.begin(), curve.levels.end());
    std::reverse(curve.images.begin(), curve.images.end());
  }
  for (TrackPlace& place : design.places)
    place.level = static_cast<int>(design.curves[place.track].levels.size()) - 1 - place.level;
}

int nearest_level(const std::vector<double>& levels, double wanted) {
  const auto nearest = std::min_element(levels.begin(), levels.end(), [&](double a, double b) {
    return std::abs(a - wanted) < std::abs(b - wanted);
  });
  return static_cast<int>(nearest - levels.begin());
}

/// Unfinished staircases with the fewest answers.
std::vector<std::size_t> stairs_in_turn(const std::vector<Staircase>& stairs) {
  std::vector<std::size_t> turn;
  int fewest = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < stairs.size(); ++i) {
    if (stairs[i].stopped || stairs[i].answered > fewest) continue;
    if (stairs[i].answered < fewest) turn.clear();
    fewest = stairs[i].answered;
    turn.push_back(i);
  }
  return turn;
}

/// The staircase of the next trial, and its stimulus.
struct NextStep {
  std::size_t staircase = 0;
  int stimulus = 0;
};

std::optional<NextStep> next_step(const StaircaseProcedure& procedure) {
  const std::vector<std::size_t> turn = stairs_in_turn(procedure.stairs);
  if (turn.empty()) return std::nullopt;
  Random random(procedure.seed, procedure.answered);
  const std::size_t which = turn[random.below(turn.size())];
  const StimulusTrack& curve = procedure.design->curves[procedure.design->starts[which].curve];
  const std::vector<int>& images = curve.images[procedure.stairs[which].level];
  const auto shows = [&](int image) { return procedure.shows[image]; };
  int fewest = shows(images.front());
  for (const int image : images) fewest = std::min(fewest, shows(image));
  std::vector<int> freshest;
  std::copy_if(images.begin(), images.end(), std::back_inserter(freshest),
               [&](int image) { return shows(image) == fewest; });
  return NextStep{.staircase = which, .stimulus = freshest[random.below(freshest.size())]};
}

/// Moves the staircase whose turn it is. What was shown is taken from the log, not decided again.
void take_in_step(StaircaseProcedure& procedure, const StaircaseAnswer& answer) {
  const std::optional<NextStep> step = next_step(procedure);
  ++procedure.shows[answer.stimulus];
  if (!step) return;
  const TrackPlace& place = procedure.design->places[answer.stimulus];
  Staircase& stairs = procedure.stairs[step->staircase];
  const int curve = procedure.design->starts[step->staircase].curve;
  if (place.track == curve) stairs.level = place.level;
  const auto levels = static_cast<int>(procedure.design->curves[curve].levels.size());
  stairs = after_answer(std::move(stairs), answer.correct, levels, procedure.design->definition);
  ++procedure.answered;
}

void decide_next(StaircaseProcedure& procedure) {
  const std::optional<NextStep> step = next_step(procedure);
  procedure.due = step ? std::optional(step->stimulus) : std::nullopt;
}

}  // namespace

StaircaseDesign make_staircase_design(const StaircaseDefinition& definition, Direction noticeability,
                                      const std::vector<Stimulus>& stimuli) {
  StimulusTracks found = tracks_of(stimuli, definition.by_object);
  StaircaseDesign design{.definition = definition,
                         .curves = std::move(found.tracks),
                         .places = std::move(found.places),
                         .starts = {}};
  begin_where_most_is_seen(design, noticeability);
  for (std::size_t c = 0; c < design.curves.size(); ++c) {
    const int curve = static_cast<int>(c);
    if (definition.start.empty()) design.starts.push_back({.curve = curve, .level = 0});
    for (const double start : definition.start)
      design.starts.push_back({.curve = curve, .level = nearest_level(design.curves[c].levels, start)});
  }
  return design;
}

Staircase after_answer(Staircase stairs, bool correct, int levels, const StaircaseDefinition& definition) {
  ++stairs.answered;
  stairs.right = correct ? stairs.right + 1 : 0;
  stairs.wrong = correct ? 0 : stairs.wrong + 1;
  int heading = 0;
  if (stairs.right == definition.down) heading = 1;
  if (stairs.wrong == definition.up) heading = -1;
  if (heading != 0) {
    if (stairs.heading == -heading) stairs.reversals.push_back(stairs.level);
    stairs.heading = heading;
    stairs.level = std::clamp(stairs.level + heading, 0, levels - 1);
    stairs.right = stairs.wrong = 0;
  }
  stairs.stopped =
      std::ssize(stairs.reversals) >= definition.reversals || stairs.answered >= definition.max_trials;
  return stairs;
}

StaircaseProcedure begin_staircases(std::shared_ptr<const StaircaseDesign> design, std::uint64_t seed) {
  StaircaseProcedure procedure{.design = design,
                               .seed = seed,
                               .stairs = {},
                               .shows = std::vector<int>(design->places.size(), 0),
                               .answered = 0,
                               .due = {}};
  for (const StaircaseDesign::Start& start : design->starts)
    procedure.stairs.push_back({.level = start.level});
  decide_next(procedure);
  return procedure;
}

StaircaseProcedure resume_staircases(StaircaseProcedure procedure,
                                     const std::vector<StaircaseAnswer>& answers, std::optional<int> due) {
  for (const StaircaseAnswer& answer : answers) take_in_step(procedure, answer);
  decide_next(procedure);
  if (due) procedure.due = due;
  return procedure;
}

StaircaseProcedure after_answer(StaircaseProcedure procedure, const TrialAnswer& answer) {
  assert(procedure.due);
  const int due = *procedure.due;
  const int right = procedure.design->places[due].object_index;
  take_in_step(procedure, {.stimulus = due, .correct = answer.chosen_index == right});
  decide_next(procedure);
  return procedure;
}

int most_trials(const StaircaseProcedure& procedure) {
  int trials = 0;
  for (const Staircase& stairs : procedure.stairs)
    trials += stairs.stopped ? stairs.answered : procedure.design->definition.max_trials;
  return trials;
}

std::optional<double> reversals_mean(const Staircase& stairs, const StimulusTrack& curve, Axis axis) {
  if (stairs.reversals.size() < reversals_left_out + 2) return std::nullopt;
  const std::size_t left = stairs.reversals.size() - reversals_left_out, used = left - left % 2;
  double sum = 0;
  for (std::size_t i = stairs.reversals.size() - used; i < stairs.reversals.size(); ++i) {
    const double level = curve.levels[stairs.reversals[i]];
    sum += axis == Axis::log2 ? std::log2(level) : level;
  }
  return sum / used;
}

double staircase_target(const StaircaseDefinition& definition) {
  // Of independent answers, D right in a row come before U wrong in a row with probability
  //   a b / (a + b - a b),  a = p^(D-1), b = 1 - q^U  (Feller 1968, VIII.1, with roles of p and q).
  const auto down_first = [&](double p) {
    const double q = 1 - p, a = std::pow(p, definition.down - 1), b = std::pow(q, definition.up - 1);
    return a * (1 - std::pow(q, definition.up)) / (a + b - a * b);
  };
  double low = 0, high = 1;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    (down_first(middle) < 0.5 ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace seamline::study
