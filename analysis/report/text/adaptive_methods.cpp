#include "analysis/report/text/adaptive_methods.h"

#include <fmt/format.h>

#include <optional>
#include <variant>

#include "analysis/report/text/joint_text.h"
#include "analysis/scores/level_words.h"
#include "stimuli/definition/parts/staircase_definition.h"
#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/definition/procedure_definition.h"
#include "support/running/overloaded.h"
#include "support/text/counted.h"

namespace seamline::analysis {

namespace {

std::string sigmoid_in_words(Sigmoid sigmoid) {
  switch (sigmoid) {
    case Sigmoid::logistic:
      return "the logistic function";
    case Sigmoid::normal:
      return "the cumulative normal";
    case Sigmoid::gumbel:
      return "the Gumbel function 1 - 2^-exp(z) (a Weibull function of the level on a log axis)";
  }
  return {};
}

std::string function_text(const QuestPlusDefinition& quest) {
  const std::string z =
      fmt::format("z = ({}) / s, x the level on the {} axis, t threshold, s scale and F {}",
                  quest.direction == Direction::decreasing ? "t - x" : "x - t",
                  quest.axis == Axis::log2 ? "log2" : "linear", sigmoid_in_words(quest.sigmoid));
  switch (quest.outcome) {
    case PlacementOutcome::correct:
      return "It learns from right and wrong choices, P(right) = g + (1 - g - l) F(z) with " + z +
             ", lapse rate l and guess rate g";
    case PlacementOutcome::noticeability:
      return "It learns from noticeability, 0 where the choice was wrong, else the rating: P(1 or more) = g + (1 - g "
             "- l) F(z) and P(k or more) = (1 - l / (1 - g)) F(z - (k - 1) r / s) for k = 2, 3, 4, with " +
             z + ", lapse rate l, guess rate g and rating step r";
    case PlacementOutcome::joint:
      return "It learns from noticeability, 0 where the choice was wrong, else the rating, by the joint model of "
             "seeing, guessing and rating: seen with probability (1 - l) F(z), then rated k or more with probability "
             "F(z - f - (k - 2) r / s) for k = 2, 3, 4; otherwise guessed, right with probability g and rated one more "
             "with probabilities that fall as powers of q; with " +
             z + ", lapse rate l, first criterion f and rating step r";
  }
  return {};
}

std::string prior_text(const ParameterPrior& prior) {
  return std::visit(
      Overloaded{[](const EvenMass&) { return std::string("even"); },
                 [](const NormalMass& normal) {
                   return fmt::format("normal about {:g} with standard deviation {:g}", normal.mean,
                                      normal.sd);
                 },
                 [](const BetaMass& beta) { return fmt::format("beta({:g}, {:g})", beta.a, beta.b); },
                 [](const ListedMass&) { return std::string("as the study file lists it"); }},
      prior);
}

std::string grid_range_text(const char* name, const ParameterRange& range, const std::string& unit) {
  const std::string prior = ", prior " + prior_text(range.prior);
  if (range.count == 1) return fmt::format("{} {:.4g}{}", name, range.least, unit);
  return fmt::format("{} {:.4g} to {:.4g}{} ({} values{})", name, range.least, range.most, unit, range.count,
                     prior);
}

std::string grid_text(const QuestPlusDefinition& quest, const LevelAxis& axis) {
  const std::string level_unit =
      facts(axis.quantity).unit.empty() ? "" : " " + std::string(facts(axis.quantity).unit);
  const std::string length = quest.axis == Axis::log2 ? " octaves" : level_unit;
  std::string text = "Its grid: " + grid_range_text("threshold", quest.threshold, level_unit) + "; " +
                     grid_range_text("scale", quest.scale, length) + "; " +
                     grid_range_text("lapse rate", quest.lapse, "") + "; " +
                     grid_range_text("guess rate", quest.guess, "");
  if (quest.outcome != PlacementOutcome::correct)
    text += "; " + grid_range_text("rating step", quest.rating_step, length);
  if (quest.outcome == PlacementOutcome::joint)
    text += "; first criterion -2 to 2 scales (6 values, prior even); q 0.05 and 0.2 (prior even)";
  return text + ".";
}

std::string stops_text(const QuestPlusDefinition& quest, const LevelAxis& axis) {
  const std::string length = quest.axis == Axis::log2 ? (quest.stop_interval == 1.0 ? "octave" : "octaves")
                                                      : std::string(facts(axis.quantity).unit);
  std::string text = fmt::format("A track ended after {} trials, when every image had been shown {}",
                                 quest.max_trials, counted(quest.max_shows_per_image, "time"));
  if (quest.stop_interval)
    text += fmt::format(
        ", or, after at least {} trials, when the 95 % interval of its threshold was at most {:g} {} "
        "wide",
        quest.min_trials, *quest.stop_interval, length);
  if (quest.stop_entropy_nats)
    text += fmt::format(", or, after at least {} trials, when the posterior's entropy was at most {:g} nats",
                        quest.min_trials, *quest.stop_entropy_nats);
  return text + ".";
}

std::string group_text(const Analysis& analysis) {
  const JointAnalysis& joint = *analysis.joint;
  std::string text =
      "Thresholds of the group are of one joint model of seeing, guessing and rating, in which each participant has a "
      "threshold of their own on every curve, normal about the group's. Its likelihood is that of each participant's "
      "answers given their thresholds, integrated over them (41 steps), so that levels placed by the answers do not "
      "bias it; it was maximised with a weak penalty. PT, SN and their corrected values are where the mean "
      "noticeability over participants is 0.5 and 1, and the detection threshold where half is seen, over "
      "participants.";
  if (!joint.fit.estimated()) return text + " " + joint.fit.explanation;
  return text + " " + sharing_method(analysis) +
         fmt::format(
             "Intervals of 95 % are over the {} participants: each was left out in turn (Student's t "
             "with {} degrees of freedom), and the scale counts as known to 5 % only, because the form of the "
             "curve is assumed. Because levels depend on the answers, no mean at a level "
             "and no inflection point was computed.",
             joint.fit.people, joint.fit.people - 1);
}

}  // namespace

std::vector<std::string> adaptive_methods(const Analysis& analysis) {
  std::vector<std::string> paragraphs, notes;
  const std::optional<StudyDefinition> study = study_of_log(analysis.log, notes);
  const LevelWords words = level_words(analysis.data.axis);
  if (study)
    if (const auto* quest = std::get_if<QuestPlusDefinition>(&study->procedure))
      paragraphs.push_back(fmt::format(
          "{} were placed by QUEST+ (Watson, 2017): each trial took the level whose answer was expected to leave the "
          "least entropy. {}. {} {} Each participant's thresholds are posterior means with equal-tailed 95 % credible "
          "intervals.",
          words.Levels, function_text(*quest), grid_text(*quest, analysis.data.axis),
          stops_text(*quest, analysis.data.axis)));
  if (study && study->task && study->task->staircase) {
    const StaircaseDefinition& stairs = *study->task->staircase;
    paragraphs.push_back(fmt::format(
        "{} were placed by staircases (Levitt, 1971): {} right answers in a row led to the next level where less is "
        "seen, {} wrong ones to the next where more is; a staircase ended after {} reversals or {} trials.",
        words.Levels, stairs.down, stairs.up, stairs.reversals, stairs.max_trials));
  }
  if (analysis.joint) paragraphs.push_back(group_text(analysis));
  return paragraphs;
}

}  // namespace seamline::analysis
