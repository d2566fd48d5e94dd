#include "analysis/report/page/methods_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "analysis/log_analysis/participant_facts.h"
#include "analysis/log_analysis/task_words.h"
#include "analysis/report/figures/figure_parts.h"
#include "analysis/report/page/sections.h"
#include "analysis/report/text/adaptive_methods.h"
#include "analysis/report/text/joint_text.h"
#include "analysis/report/text/methods_references.h"
#include "analysis/report/text/order_text.h"
#include "analysis/report/text/replication_text.h"
#include "analysis/report/text/scenes_text.h"
#include "analysis/scores/level_words.h"
#include "analysis/statistics/many_people.h"
#include "analysis/thresholds/threshold_rules.h"
#include "support/files/assets.h"
#include "support/text/counted.h"

namespace seamline::analysis {

namespace {

std::string widths_text(const Analysis& analysis) {
  const LevelsDrawn drawn = levels_drawn(analysis.data);
  std::string text;
  for (const double level : drawn.levels)
    text += (text.empty() ? "" : ", ") + (of_depth_widths(drawn.axis)
                                              ? fmt::format("{} × {}", level, std::floor(level / 2))
                                              : tested_text(drawn.axis, level));
  if (of_depth_widths(drawn.axis)) return "Equirectangular depth maps of " + text + " texels were tested.";
  const QuantityFacts& about = facts(drawn.axis.quantity);
  return fmt::format("Levels of the {} were tested: {}{}.", about.name, text,
                     about.unit.empty() ? "" : " " + std::string(about.unit));
}

/// Which conditions there were, and that each has thresholds of its own.
std::string conditions_text(const Analysis& analysis) {
  if (!has_conditions(analysis.data)) return "";
  std::string names;
  for (const std::string& name : analysis.data.conditions) names += (names.empty() ? "" : ", ") + name;
  return fmt::format(" There were {} conditions: {}. Each has curves and thresholds of its own.",
                     analysis.data.conditions.size(), names);
}

std::string people_text(const Analysis& analysis) {
  const ParticipantCounts& counts = analysis.counts;
  std::string text = counted(counts.in_log, "participant is", "participants are") + " in the log";
  std::string left_out;
  const auto add = [&](int count, const char* why) {
    if (count > 0) left_out += fmt::format("{}{} {}", left_out.empty() ? "" : ", ", count, why);
  };
  add(counts.excluded, "excluded by the researcher");
  add(counts.pilot, "of a pilot");
  add(counts.incomplete, "who did not finish");
  add(counts.screened, "named by a screen");
  add(counts.vision, "whose vision is neither normal nor corrected");
  int trials = 0;
  for (const ParticipantUse& person : analysis.people)
    if (person.use == Use::used) trials += person.answers;
  text += left_out.empty() ? "; none was left out"
                           : fmt::format("; left out: {} ({})", counts.in_log - counts.used, left_out);
  text += fmt::format(". The analysis is of {} with {}.", source_text(analysis), counted(trials, "trial"));
  if (analysis.log.forgotten_participants > 0)
    text += fmt::format(" {} more asked for their data to be deleted.", analysis.log.forgotten_participants);
  for (const std::string& sentence : participants_described(analysis)) text += " " + sentence;
  return text;
}

std::string procedure(const Analysis& analysis) {
  int trials = 0;
  for (const ParticipantUse& person : analysis.people)
    if (person.use == Use::used) trials = std::max(trials, person.answers);
  const TaskWords task = task_words(analysis);
  if (!task.procedure.empty())
    return fmt::format("{} There were up to {} such trials for each of {}, in an order of their own. {}{}",
                       task.procedure, trials, source_text(analysis), widths_text(analysis),
                       conditions_text(analysis));
  return fmt::format(
      "Each image showed three objects, one of which had been composited into the picture with the help of a "
      "depth map; {} judged up to {} images each, in an order of their own. They chose the object that they "
      "took for the inserted one (forced choice) and rated how noticeable the insertion was: 1 slightly, 2 "
      "moderately, 3 very, 4 extremely. Noticeability is the rating when the choice was right and 0 when it "
      "was wrong. {}{}",
      source_text(analysis), trials, widths_text(analysis), conditions_text(analysis));
}

/// "12 yes, 8 no".
/// What the bootstrap draws.
std::string drawn_text(const Analysis& analysis) {
  return analysis.counts.used > many_people ? fmt::format("{} blocks of participants", many_people)
                                            : "participants";
}

std::string groups_in_words(const GroupComparison& groups) {
  std::string text;
  for (std::size_t g = 0; g < groups.groups.size(); ++g)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", groups.people[g], groups.groups[g]);
  return text;
}

/// Participants and answers of every curve.
std::string curves_text(const Analysis& analysis) {
  std::map<std::pair<Artifact, std::string>, int> answers_of;
  for (const study::Answer& answer : used_answers(analysis.log, analysis.people))
    ++answers_of[{answer.artifact, answer.condition}];
  std::string curves;
  for (const ArtifactScores& scores : analysis.data.artifacts) {
    const int answers = answers_of[{scores.artifact, scores.condition}];
    curves += fmt::format("{}{}{} {} and {}", curves.empty() ? "" : "; ", word(scores.artifact),
                          in_condition(scores.condition), counted(scores.people.size(), "participant"),
                          counted(answers, "answer"));
  }
  return "Behind the curves are: " + curves + ". " + fixed_effects_text(analysis);
}

/// The model of record, as far as it was fitted.
std::string joint_text(const Analysis& analysis, const LevelWords& words) {
  const JointAnalysis& joint = *analysis.joint;
  const bool rated = asks_ratings(analysis.log);
  std::string sought;
  for (const ThresholdRule& rule : threshold_rules)
    if (rated || rule.name == word(JointQuantity::detection))
      sought += fmt::format("{}{} where {}", sought.empty() ? "" : "; ", rule.name, rule.meaning);
  const JointSharing& sharing = joint.fit.model.sharing;
  std::string shared, own = "thresholds";
  const auto sort_into = [&](bool is_shared, const char* what) {
    std::string& list = is_shared ? shared : own;
    list += (list.empty() ? "" : ", ") + std::string(what);
  };
  sort_into(sharing.scale, "scale");
  sort_into(sharing.criteria, "rating criteria");
  sort_into(sharing.lapse, "lapse rate (0 to 0.1)");
  sort_into(sharing.guess_ratings, "guess ratings");
  std::string text = fmt::format(
      "Thresholds are of one joint model of all answers. An insertion is seen with probability psi, (1 - "
      "lapse) "
      "times a cumulative normal of {}; what is seen is chosen rightly and rated by a cumulative link with "
      "ordered criteria (Agresti, 2010); what is not seen is guessed, right with the chance of the guessers' "
      "positions (about {}), and rated as wrong choices are. Shared by all curves: {}; each curve's own: "
      "{}. The model was fitted by "
      "maximum likelihood with a weak penalty. Read off it are: {}. ",
      words.axis, task_words(analysis).chance_number, shared.empty() ? "nothing" : shared, own, sought);
  text += sharing_method(analysis);
  if (!joint.fit.estimated()) return text + joint.fit.explanation;
  text += fmt::format(
      "Intervals of {:g} % are over participants: they hold the {} at which the logarithm of mean noticeability above "
      "the guess floor is not told from that of the level sought, with the variance of leaving out each participant in "
      "turn (Student's t with {} degrees of freedom) and a scale known to 5 % only, because the form of the curve is "
      "assumed; for IP they are the estimate and as many standard errors. Beside "
      "each stands one that holds together with those of the same threshold of all curves. There is an estimate where "
      "its interval is closed, and none where the level lies in the guess floor.",
      100 * confidence, words.levels, joint.fit.people - 1);
  for (const std::string& sentence : joint_check_sentences(analysis)) text += " " + sentence;
  return text;
}

std::string joint_comparisons_text(const ReportNumbers& numbers) {
  std::string text =
      "Thresholds and slopes were compared by contrasts of the joint model (slopes in a fit with a scale for "
      "each "
      "curve), adjusted within each question by the contrasts' joint distribution (Hothorn, Bretz and "
      "Westfall, 2008); "
      "questions are not adjusted for each other.";
  for (const GroupComparison& groups : numbers.groups)
    text +=
        fmt::format(" Groups by {}: {}", groups.field,
                    groups.verdict.empty()
                        ? fmt::format("{}{}.", groups_in_words(groups),
                                      groups.shifts.correction == Correction::holm
                                          ? "; adjusted by Holm's method, since a group has under 20 people"
                                          : "")
                        : groups.verdict);
  return text;
}

/// Why there are so many participants, as it was frozen.
std::string why_so_many_text(const Analysis& analysis) {
  if (!analysis.frozen) return "The number of participants was not preregistered.";
  return fmt::format("The study was preregistered (SHA-256 {}) for {}. Why so many: {} {}",
                     analysis.frozen->sha256.substr(0, 12),
                     counted(analysis.frozen->participants, "participant"), analysis.frozen->why_so_many,
                     deviations_in_words(*analysis.frozen));
}

std::string means_text(const Analysis& analysis, const LevelWords& words) {
  return fmt::format(
      "Beside them stands the paper's own way. Answers were averaged over the objects of an artifact within "
      "each "
      "participant and then over "
      "participants; error bars are standard errors of the mean over participants. The perceptual threshold "
      "(PT) and the {level} at which an artifact becomes slightly noticeable (SN) are then {sought} at which "
      "the "
      "{monotone} isotonic regression of mean noticeability, linear in {axis}, equals {pt:.1f} and {sn:.1f} "
      "(Barlow et al., 1972). The inflection point (IP) is the centre of a four-parameter logistic fitted by "
      "least squares in {axis}. A threshold is given where its interval is closed; where the answers leave a "
      "side open, the bound is given. {guess}",
      fmt::arg("guess", task_words(analysis).guess), fmt::arg("level", words.level),
      fmt::arg("sought", words.sought), fmt::arg("monotone", words.monotone), fmt::arg("axis", words.axis),
      fmt::arg("pt", perceptual_level), fmt::arg("sn", slight_level));
}

/// What each way to make an interval does, of the thresholds that are made so.
std::string intervals_text(const Analysis& analysis, const LevelWords& words) {
  std::string text = fmt::format(
      "Intervals of the paper's way are {:g} % confidence intervals over participants.", 100 * confidence);
  if (const std::string names = names_with(IntervalMethod::score_test); !names.empty())
    text += fmt::format(
        " For {} they hold every {} at which a score test does not tell the curve from that mean (Student's "
        "t "
        "with n - 1 degrees of freedom; the variance over participants is read at that mean, as in Wilson's "
        "interval).",
        names, words.level);
  if (const std::string names = names_with(IntervalMethod::expanded_percentile); !names.empty())
    text += fmt::format(
        " For {} they are expanded percentile intervals (Hesterberg, 2015) of {} bootstrap samples of "
        "{} (seed {}); a sample without such a point counts as infinite and is never dropped.",
        names, analysis.resampling.replicates, drawn_text(analysis), analysis.resampling.seed);
  return text +
         fmt::format(
             " An interval is open (\"above\", \"below\") where the data do not exclude a threshold beyond "
             "the {} tested. Each threshold has an interval of its own, not adjusted for their number.",
             words.levels);
}

std::string checks_method_text(const LevelWords& words) {
  return fmt::format(
      "Beside the thresholds stand: PT and SN read off the logistic (intervals by the same score test, of "
      "the best "
      "logistic that equals {:.1f} or {:.1f} at a given {}); thresholds of the curve corrected for guessing "
      "by "
      "a latent-class model (saw it, or guessed) fitted by expectation maximisation (Dempster, Laird and "
      "Rubin, "
      "1977), with guessers' positions and ratings estimated from wrong choices and reference trials; and "
      "the "
      "range found when each object in turn is left out.",
      perceptual_level, slight_level, words.level);
}

std::string screening_text(const Analysis& analysis) {
  const Screening& screening = analysis.screening;
  std::string text = "Participants were screened by ";
  if (screening.catch_trials) text += "catch trials (right in at least 75 % of them), by ";
  text += fmt::format(
      "ITU-R BT.500 (kurtosis) and by correlation with the mean of the others (limit {}). The two screens of "
      "scores judge only where they would name fewer than 1 % of honest people, simulated by this study's "
      "own "
      "answers ({} people). ",
      limit_text(screening), screening.honest.simulated);
  for (const ScreeningRule rule : {ScreeningRule::kurtosis, ScreeningRule::correlation}) {
    const std::string why = why_not_judged(screening, rule);
    text += why.empty()
                ? fmt::format("By {} it would be {}. ", word(rule), honest_share_text(screening.honest, rule))
                : fmt::format("By {} nobody was judged: {}. ", word(rule), why);
  }
  text += "Of those judged: ";
  const std::size_t named = analysis.screening.named().size(), people = analysis.screening.people.size();
  if (named == 0) return text + fmt::format("none of {} was named.", people);
  return text + fmt::format("{} of {} {} named and {}.", named, people, named == 1 ? "was" : "were",
                            analysis.options.exclude_screened      ? "left out"
                            : analysis.options.exclude_inattentive ? "left out where catch trials named them"
                                                                   : "used all the same");
}

std::string software(const Analysis& analysis) {
  return fmt::format("Analysed with Seamline {} (study {}, study hash {}, set hash {}).", program_version(),
                     analysis.log.study_name, analysis.log.study_hash.substr(0, 12),
                     analysis.log.set_hash.substr(0, 12));
}

std::string choices_text(const Analysis& analysis, int replicates) {
  return fmt::format(
      "Right choices were described by psychometric functions, cumulative normal in {} with a guess "
      "rate of {} and a lapse rate estimated up to 0.1, fitted by maximum likelihood to the answers of all "
      "participants (Wichmann and Hill, 2001). The interval of the threshold is that of the profile "
      "likelihood, scaled by the variance of the threshold over participants (leaving out one at a time) "
      "with Student's t. Intervals of width and lapse and the bands are 95 % percentiles of {} bootstrap "
      "samples of participants (seed {}). Goodness of fit is the deviance against {} data sets simulated "
      "from the fit.",
      level_words(analysis.data.axis).axis, task_words(analysis).chance_number, replicates,
      analysis.resampling.seed, deviance_replicates);
}

std::string differences_text(const Analysis& analysis) {
  return fmt::format(
      "Thresholds of each condition were compared to those of '{}' ({}). Their intervals are expanded "
      "percentile intervals of {} bootstrap samples of {} (seed {}), drawn for all conditions "
      "together; a sample whose threshold lies beyond the levels tested counts as anywhere there.",
      analysis.data.conditions.front(), length_unit(analysis.data.axis), analysis.resampling.replicates,
      drawn_text(analysis), analysis.resampling.seed);
}

std::string comparisons_text(const OrdinalStudy& study, const ReportNumbers& numbers) {
  return fmt::format(
      "Beside these comparisons stands a cumulative link mixed model (Agresti, 2010) of noticeability with "
      "{} "
      "link, a {} and a slope over {} for each artifact{}, objects nested in artifacts{} and a normal "
      "random intercept for each participant, integrated by adaptive Gauss-Hermite quadrature with {} nodes. "
      "Standard errors {}. Contrasts were adjusted within each question: {}.",
      word(study.fit.link), of_depth_widths(numbers.axis) ? "level" : "mean", level_words(numbers.axis).axis,
      numbers.conditions ? " in each condition" : "",
      study.design.groups.empty() ? ""
                                  : ", a shift between participants with and without technical background",
      study.fit.nodes,
      study.errors == ErrorSource::participants
          ? "were computed by leaving out each participant in turn, with Student's t"
          : "are those of the likelihood's curvature",
      study.contrasts.empty() || study.contrasts.front().correction == Correction::single_step
          ? "single-step, by the contrasts' joint distribution (Hothorn, Bretz and Westfall, 2008)"
          : "by Holm's method (1979)");
}

constexpr const char* reaction_times_text =
    "Response times run from the image's onset to the choice, and from the choice to the rating; medians and "
    "quartiles over answers are given and no answer was left out for its time.";

constexpr const char* paragraph_on_planted =
    "The answers come from simulated observers with known psychometric functions. Planted values are the "
    "levels at which their expected mean noticeability, the floor from guessing included, equals 0.5 (PT) "
    "and 1 (SN) and falls most steeply (IP), computed on the continuous axis and not from the tested "
    "levels; they test the analysis and are not the values of Table 1 of the paper.";

}  // namespace

MethodsText methods_text(const Analysis& analysis, const ReportNumbers& numbers, const std::string& clips) {
  MethodsText methods;
  std::vector<std::string>& paragraphs = methods.paragraphs;
  const LevelWords words = level_words(analysis.data.axis);
  paragraphs = {people_text(analysis), procedure(analysis)};
  if (!clips.empty()) paragraphs.push_back(clips);
  if (analysis.adaptive) {
    for (std::string& paragraph : adaptive_methods(analysis)) paragraphs.push_back(std::move(paragraph));
  } else {
    paragraphs.push_back(curves_text(analysis));
    paragraphs.push_back(why_so_many_text(analysis));
    if (analysis.joint) paragraphs.push_back(joint_text(analysis, words));
    if (analysis.joint && analysis.joint->fit.estimated())
      paragraphs.push_back(joint_comparisons_text(numbers));
    if (std::string scenes = scenes_method(numbers); !scenes.empty()) paragraphs.push_back(std::move(scenes));
    const bool rated = asks_ratings(analysis.log);
    if (rated) paragraphs.push_back(means_text(analysis, words));
    if (stands_apart(analysis.data.axis, levels_drawn(analysis.data).levels.front()))
      paragraphs.emplace_back(
          "The level none stands apart: it lies on no logarithmic axis, and is no part of the fits.");
    if (const std::string answered = answered_text(analysis); !answered.empty())
      paragraphs.push_back(answered);
    if (rated && analysis.counts.used > 1) paragraphs.push_back(intervals_text(analysis, words));
    if (std::string few = few_people_sentence(analysis); !few.empty()) paragraphs.push_back(std::move(few));
    for (const ChoiceCurve& curve : numbers.choices)
      if (curve.pooled) {
        paragraphs.push_back(choices_text(analysis, curve.band_replicates));
        break;
      }
    if (numbers.comparisons && has_estimates(numbers.comparisons->fit.verdict))
      paragraphs.push_back(comparisons_text(*numbers.comparisons, numbers));
    if (numbers.conditions && !analysis.differences.empty()) paragraphs.push_back(differences_text(analysis));
    if (analysis.replication) paragraphs.push_back(replication_method(analysis));
    if (rated) paragraphs.push_back(checks_method_text(words));
    if (numbers.order.missing.empty())
      paragraphs.push_back(order_text(numbers.order, numbers.halves, numbers.axis));
  }
  paragraphs.push_back(screening_text(analysis));
  if (!numbers.times.rows.empty()) paragraphs.emplace_back(reaction_times_text);
  paragraphs.push_back(software(analysis));
  if (!analysis.planted.empty()) paragraphs.emplace_back(paragraph_on_planted);
  methods.references = references_in(paragraphs);
  return methods;
}

std::string plain_text(const MethodsText& methods) {
  std::string text;
  for (const std::string& paragraph : methods.paragraphs) text += paragraph + "\n\n";
  text += "References\n\n";
  for (const std::string& reference : methods.references) text += reference + "\n";
  return text;
}

}  // namespace seamline::analysis
