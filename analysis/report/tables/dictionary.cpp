#include "analysis/report/tables/dictionary.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "analysis/scores/level_words.h"
#include "analysis/thresholds/threshold_rules.h"

namespace seamline::analysis {

namespace {

struct Field {
  std::string path, unit, meaning;
};

/// How files of a study name its levels.
struct LevelNames {
  explicit LevelNames(const LevelAxis& axis)
      : of(axis),
        words(level_words(axis)),
        suffix(unit_suffix(axis)),
        unit(facts(axis.quantity).unit),
        key(level_key(axis)),
        key_meaning(of_depth_widths(axis) ? "width W of the depth map" : facts(axis.quantity).name),
        thresholds{{{"perceptual_threshold", "PT, the " + words.level + " where mean noticeability is 0.5"},
                    {"slightly_noticeable", "SN, the " + words.level + " where it is 1.0"},
                    {"inflection", "IP, the centre of the logistic"}}} {}

  LevelAxis of;
  LevelWords words;
  std::string suffix;                                             ///< of names of estimates: "_px"
  std::string unit;                                               ///< "px"
  std::string key;                                                ///< of a level: "width_px"
  std::string key_meaning;                                        ///< "width W of the depth map"
  std::array<std::pair<const char*, std::string>, 3> thresholds;  ///< key and meaning of PT, SN, IP
};

/// What every file of results begins with.
std::vector<Field> head_fields() {
  return {{"format", "text", "name of the format"},
          {"version", "count", "version of the format"},
          {"program_version", "text", "version of Seamline"},
          {"study.name", "text", "name of the study"},
          {"study.hash", "hexadecimal", "hash of the study file"},
          {"set.hash", "hexadecimal", "hash of the stimulus set"},
          {"source", "text", "who answered: participants or simulated observers"},
          {"notes[]", "text", "what a reader must know"}};
}

/// An estimated level: estimate, reason, interval.
void add_estimate(std::vector<Field>& fields, const std::string& path, const std::string& unit,
                  const std::string& meaning) {
  fields.push_back({path + ".estimate", unit, meaning + "; null when there is none"});
  fields.push_back({path + ".reason", "text", "why there is no estimate; null when there is one"});
  fields.push_back({path + ".reason_word", "word", "the same for programs; not written when there is one"});
  fields.push_back(
      {path + ".ci95[]", unit, "lower and upper end of its 95 % interval; null when open on that side"});
}

void add_thresholds(std::vector<Field>& fields, const LevelNames& names, const std::string& prefix,
                    const std::string& more) {
  for (const auto& [key, meaning] : names.thresholds)
    add_estimate(fields, prefix + key + names.suffix, names.unit, meaning + more);
}

/// A number a quantity.
void add_numbers(std::vector<Field>& fields, const LevelNames& names, const std::string& prefix,
                 const char* brackets, const std::string& more) {
  for (const auto& [key, meaning] : names.thresholds)
    fields.push_back({prefix + key + names.suffix + brackets, names.unit, meaning + more});
}

void add_means(std::vector<Field>& fields, const LevelNames& names, const std::string& prefix) {
  fields.push_back({prefix + names.key, names.unit,
                    names.key_meaning + (of_depth_widths(names.of) ? "; its height is W / 2" : "")});
  fields.push_back({prefix + "n", "participants", "participants in the mean"});
  fields.push_back({prefix + "mean", "noticeability 0 to 4", "mean over participants"});
  fields.push_back({prefix + "sem", "noticeability", "its standard error; null with one participant"});
  fields.push_back({prefix + "correct", "share 0 to 1", "share of right choices"});
}

void add_object(std::vector<Field>& fields, const std::string& prefix) {
  fields.push_back({prefix + "scene", "text", "name of the scene in the study file"});
  fields.push_back({prefix + "object", "text", "name of the inserted object"});
  fields.push_back(
      {prefix + "object_index", "from 1", "its place from the left: of three, 1 left, 2 middle, 3 right"});
}

void add_curves(std::vector<Field>& fields, const LevelNames& names, const std::string& artifact) {
  const std::string logistic = artifact + "logistic.";
  const bool widths = of_depth_widths(names.of);
  fields.push_back(
      {logistic + "upper", "noticeability",
       std::string("what the fitted logistic tends to") + (widths ? " at small widths" : ", upper end")});
  fields.push_back({logistic + "lower", "noticeability",
                    std::string("what it tends to") + (widths ? " at large widths" : ", lower end")});
  fields.push_back(
      {logistic + "centre" + names.suffix, names.unit, "its centre, whether or not that is identified"});
  fields.push_back({logistic + "scale_" + length_key(names.of), length_unit(names.of),
                    "its scale on " + names.words.short_axis});
  fields.push_back({logistic + "residual_sum_of_squares", "", "of the means about it"});
  fields.push_back({logistic + "identified", "true or false", "whether the data say where the centre is"});
  add_means(fields, names, artifact + "curve[].");
  fields.push_back({artifact + "curve[].isotonic", "noticeability", names.words.monotone + " isotonic fit"});
  fields.push_back({artifact + "curve[].logistic", "noticeability", "four-parameter logistic"});
  fields.push_back({artifact + "cells[].artifact", "word", "the artifact"});
  add_object(fields, artifact + "cells[].");
  add_means(fields, names, artifact + "cells[].");
}

void add_artifact_checks(std::vector<Field>& fields, const LevelNames& names, const std::string& artifact) {
  for (const char* key : {"perceptual_threshold", "slightly_noticeable"})
    add_estimate(fields, artifact + "logistic_thresholds." + key + names.suffix, names.unit,
                 "the same quantity read off the logistic");
  const std::string corrected = artifact + "corrected_for_guessing.";
  add_thresholds(fields, names, corrected, ", of the curve corrected for guessing");
  add_numbers(fields, names, corrected + "expanded_percentile_ci95.", "[]",
              ": bootstrap interval, for comparison; null when open");
  fields.push_back(
      {corrected + "above_chance", "true or false",
       "whether people are shown to be right more often than guessers; false: chance is not excluded"});
  fields.push_back({corrected + "curve[]." + names.key, names.unit, names.key_meaning});
  fields.push_back({corrected + "curve[].saw", "probability", "P(saw the insertion)"});
  fields.push_back({corrected + "curve[].noticeability", "0 to 4", "mean noticeability without guesses"});
  const std::string objects = artifact + "one_object_left_out.";
  add_numbers(fields, names, objects, "[]", ": range of the estimates when each object in turn is left out");
  add_object(fields, objects + "without[].");
  add_numbers(fields, names, objects + "without[].", "", ", without that object");
  if (!of_depth_widths(names.of)) return;
  fields.push_back({artifact + "field_of_view.degrees", "degree", "horizontal field of view"});
  for (const auto& [key, meaning] : names.thresholds) {
    const std::string view = artifact + "field_of_view." + key;
    fields.push_back({view + ".equirectangular_px", "px", "width of a cut of that field of view"});
    fields.push_back({view + ".pinhole_px", "px", "width of a pinhole depth map as fine at its centre"});
  }
}

void add_artifacts(std::vector<Field>& fields, const LevelNames& names, bool conditions) {
  const std::string artifact = "artifacts[].";
  fields.push_back({artifact + "artifact", "word", "receiver, shadow, occlusion or overlap"});
  fields.push_back({artifact + "participants", "count", "participants on the curve"});
  fields.push_back({artifact + "participants_at_fewest", "count",
                    "of them at the level where the fewest answered; the intervals' degrees of freedom"});
  for (const auto& [key, meaning] : names.thresholds) {
    add_estimate(fields, artifact + key + names.suffix, names.unit, meaning);
    fields.push_back({artifact + key + names.suffix + ".ci95_text", "text", "the interval in words"});
    if (!of_depth_widths(names.of)) continue;
    add_estimate(fields, artifact + key + "_texels_per_degree", "1/degree", meaning);
    fields.push_back({artifact + key + "_texels_per_degree.ci95_text", "text", "the interval in words"});
  }
  add_numbers(fields, names, artifact + "planted.", "",
              ": where simulated observers' expected mean truly crosses");
  add_numbers(fields, names, artifact + "planted_limit.", "",
              ": what the estimate approaches with ever more simulated observers");
  if (of_depth_widths(names.of) && !conditions)
    add_numbers(fields, names, artifact + "paper.", "", ": Table 1 of the paper; null where it has a dash");
  add_numbers(fields, names, artifact + "expanded_percentile_ci95.", "[]",
              ": bootstrap interval, for comparison; null when open");
  add_curves(fields, names, artifact);
  add_artifact_checks(fields, names, artifact);
}

void add_joint(std::vector<Field>& fields, const LevelNames& names) {
  fields.push_back({"headline", "word",
                    "joint: thresholds of record are under artifacts[].joint; paper_way: there is none"});
  fields.push_back({"joint.verdict", "word", "estimated, or why the joint model has no numbers"});
  fields.push_back({"joint.explanation", "text", "the same as a sentence; null when it has numbers"});
  fields.push_back({"joint.participants", "count", "participants it was fitted to"});
  fields.push_back({"joint.answers", "count", "answers it was fitted to"});
  fields.push_back({"joint.log_likelihood", "", "at its maximum"});
  fields.push_back(
      {"joint.people_sd", length_unit(names.of), "how participants' thresholds differ, standard deviation"});
  fields.push_back(
      {"joint.people_by_curve_sd", length_unit(names.of), "and from curve to curve beside that"});
  fields.push_back(
      {"joint.choices_p", "0 to 1", "of right and wrong choices, parametric bootstrap; null: not tested"});
  fields.push_back({"joint.ratings_p", "0 to 1", "of ratings of right choices, the same"});
  fields.push_back({"joint.replicates", "count", "simulated data sets behind both"});
  for (const ThresholdRule& rule : threshold_rules) {
    const std::string path = std::string("artifacts[].joint.") + rule.key + names.suffix;
    add_estimate(fields, path, names.unit, std::string(rule.name) + ", where " + rule.meaning);
    fields.push_back({path + ".ci95_text", "text", "the interval in words"});
    fields.push_back({path + ".simultaneous_ci95[]", names.unit,
                      "holds together with those of all curves; null when open"});
    fields.push_back(
        {path + ".beyond_levels", "true or false", "whether the estimate is outside the levels tested"});
    fields.push_back(
        {path + ".differs", "text", "why the paper's way lies outside the interval; null when it does not"});
  }
}

void add_screening(std::vector<Field>& fields, const LevelNames& names) {
  for (const char* screen : {"attention", "kurtosis", "correlation"}) {
    const std::string path = std::string("screening.") + screen;
    fields.push_back({path + ".rule", "text", "the rule with its numbers"});
    fields.push_back(
        {path + ".judged", "true or false", "whether the screen judges the people of this study"});
    fields.push_back({path + ".not_judged_because", "text", "why not; empty when it does"});
    fields.push_back({path + ".count", "count", "participants it names"});
    fields.push_back({path + ".named[]", "text", "their codes"});
  }
  for (const char* screen : {"kurtosis", "correlation"})
    fields.push_back(
        {std::string("screening.") + screen + ".honest_named", "0 to 1",
         "share of simulated honest people of this study whom it would name; it judges under 0.01; "
         "null with fewer than three people"});
  fields.push_back({"screening.correlation.limit[]", "between -1 and 1",
                    "the correlation a participant has to exceed: the least and the most of this study's"});
  fields.push_back({"screening.honest_simulated", "count", "honest people simulated"});
  const std::string person = "screening.people[].";
  fields.push_back({person + "participant", "text", "code"});
  fields.push_back({person + "catch_trials.shown", "count", "catch trials answered"});
  fields.push_back({person + "catch_trials.right", "count", "of these right"});
  fields.push_back({person + "kurtosis.P", "count", "scores far above the mean of all"});
  fields.push_back({person + "kurtosis.Q", "count", "scores far below it"});
  fields.push_back({person + "kurtosis.stimuli", "count", "stimuli with a score"});
  fields.push_back(
      {person + "correlation.stimuli", "between -1 and 1", "with the mean of the others, over stimuli"});
  fields.push_back({person + "correlation.conditions", "between -1 and 1",
                    "the same over artifacts and " + names.words.levels});
  fields.push_back(
      {person + "correlation.critical", "between -1 and 1", "what chance exceeds in 0.1 % of cases"});
  fields.push_back({person + "correlation.below_p913", "true or false", "under the limits of ITU-T P.913"});
  const std::string screened = "thresholds_by_screen[].";
  fields.push_back({screened + "who", "text", "everybody, or without those whom a screen names"});
  fields.push_back({screened + "left_out[]", "text", "codes of those left out"});
  fields.push_back({screened + "artifacts[].artifact", "word", "the artifact"});
  add_thresholds(fields, names, screened + "artifacts[].", ", of those people");
  fields.push_back({"exclude_screened", "true or false", "whether those named are left out throughout"});
  fields.push_back({"exclude_inattentive", "true or false",
                    "whether those named by catch trials are left out throughout"});
  fields.push_back({"exclude_uncorrected", "true or false",
                    "whether those whose vision is neither normal nor corrected are left out throughout"});
}

std::vector<Field> thresholds_fields(const LevelNames& names, bool conditions) {
  std::vector<Field> fields = head_fields();
  fields.push_back({"simulated", "true or false", "whether any of those used is simulated"});
  fields.push_back({"observer", "word", "kind of simulated observer when all are of one; else null"});
  for (const auto& [key, meaning] : {std::pair{"in_log", "in the log"},
                                     {"used", "whose answers are used"},
                                     {"excluded", "excluded by the researcher"},
                                     {"pilot_left_out", "of a pilot, left out"},
                                     {"incomplete", "who did not finish"},
                                     {"screened", "left out because a screen names them"},
                                     {"vision", "left out: vision neither normal nor corrected"},
                                     {"simulated", "used who are simulated"},
                                     {"forgotten", "deleted from the log at their request"}})
    fields.push_back({std::string("participants.") + key, "count", std::string("participants ") + meaning});
  fields.push_back({"include_pilot", "true or false", "whether pilot data are used"});
  fields.push_back({"bootstrap.replicates", "count", "bootstrap samples of participants"});
  fields.push_back({"bootstrap.seed", "count", "their seed"});
  fields.push_back({"intervals", "text", "how intervals were computed"});
  add_joint(fields, names);
  add_artifacts(fields, names, conditions);
  fields.push_back({"guessing.position_probability[]", "probability", "a guess falls left, middle, right"});
  fields.push_back({"guessing.position_estimated", "true or false", "false: equal positions are assumed"});
  fields.push_back({"guessing.rating_probability[]", "probability", "a guesser rates 1, 2, 3, 4"});
  fields.push_back({"guessing.mean_rating", "1 to 4", "mean rating of guessers"});
  fields.push_back({"guessing.floor", "noticeability", "mean of people who see nothing"});
  fields.push_back({"guessing.wrong_choices", "count", "wrong choices it is estimated from"});
  fields.push_back({"guessing.reference_trials", "count", "reference trials it is estimated from"});
  add_screening(fields, names);
  fields.push_back({"sos_parameter.a", "0 to 1", "standard deviation of opinion scores (SOS)"});
  fields.push_back({"sos_parameter.ci95[]", "0 to 1", "its 95 % interval"});
  fields.push_back({"sos_parameter.stimuli", "count", "stimuli it is fitted to"});
  return fields;
}

std::vector<Field> report_fields(const std::vector<CsvTable>& tables) {
  std::vector<Field> fields = head_fields();
  fields.push_back({"seed", "count", "seed of every random number of the analysis"});
  fields.push_back({"methods[]", "text", "paragraphs of the method text"});
  fields.push_back({"references[]", "text", "works that they name"});
  for (const CsvTable& table : tables)
    for (const CsvColumn& column : table.columns)
      fields.push_back({"tables." + table.name + "[]." + column.name, column.unit,
                        column.meaning + " (null instead of an empty cell)"});
  return fields;
}

/// What a study with conditions has besides.
std::vector<Field> condition_fields(const LevelAxis& axis) {
  std::vector<Field> fields = {
      {"conditions[]", "text", "conditions of the study, in its order"},
      {"artifacts[].condition", "text", "condition of the curve"},
      {"thresholds_by_screen[].artifacts[].condition", "text", "condition of the curve"},
      {"differences[].artifact", "word", "the artifact"},
      {"differences[].quantity", "word", "PT, SN or IP"},
      {"differences[].condition", "text", "condition whose threshold is compared"},
      {"differences[].to", "text", "condition that it is compared to: the study's first"},
      {"differences[].participants", "count", "participants on the curves of all conditions"},
      {"differences[].estimate", length_unit(axis),
       "threshold of the condition less that of the first, along the axis; null unless its interval is "
       "closed"},
      {"differences[].bounds[]", length_unit(axis),
       "between what the difference lies when a threshold is beyond the levels tested; null when open"},
      {"differences[].ci95[]", length_unit(axis),
       "95 % interval over participants, drawn for all conditions together; null when open"},
      {"differences[].text", "text", "the same in words"}};
  return fields;
}

/// What a study of another quantity than depth widths has besides.
std::vector<Field> quantity_fields() {
  return {{"level.quantity", "word", "what the levels are values of"},
          {"level.axis", "word", "linear or log2"},
          {"level.noticeability", "word", "rises or falls as the level grows"}};
}

/// What a study with several scenes an artifact has besides.
std::vector<Field> scenes_fields(const LevelNames& names, bool conditions) {
  const std::string curve = "scenes[].", one = "scenes[].thresholds[].", length = length_unit(names.of);
  std::vector<Field> fields = {{curve + "artifact", "word", "the artifact"}};
  if (conditions) fields.push_back({curve + "condition", "text", "condition of the curve"});
  fields.push_back({curve + "scenes[]", "text", "in which it was shown"});
  fields.push_back({curve + "between_people", length,
                    "standard deviation of a person's thresholds, alike in all scenes; null without a fit"});
  fields.push_back({curve + "people_by_scenes", length, "and from scene to scene beside that"});
  fields.push_back({one + "quantity", "word", "PT, SN, both corrected, IP or detection"});
  fields.push_back(
      {one + "mean" + names.suffix, names.unit, "mean over scenes along the axis; null without one"});
  fields.push_back({one + "reason", "text", "why there is none; null when there is one"});
  fields.push_back({one + "these_ci95[]", names.unit,
                    "95 % interval over participants, for these scenes; null when open"});
  fields.push_back(
      {one + "like_these_ci95[]", names.unit, "95 % interval over participants and scenes; null when open"});
  fields.push_back({one + "between_scenes", length, "standard deviation between scenes"});
  return fields;
}

/// What a log with lab and web has besides.
std::vector<Field> origin_fields(const LevelNames& names, bool conditions) {
  std::vector<Field> fields;
  for (const char* group : {"origins.lab.", "origins.web."}) {
    const std::string path = group, artifact = path + "artifacts[].";
    fields.push_back({path + "participants", "count", "participants used who came by this way"});
    fields.push_back({artifact + "artifact", "word", "the artifact"});
    if (conditions) fields.push_back({artifact + "condition", "text", "condition of the curve"});
    fields.push_back({artifact + "participants", "count", "of them on the curve"});
    add_thresholds(fields, names, artifact, ", of them alone");
  }
  fields.push_back({"origins.permutations", "count", "of participants between lab and web"});
  const std::string one = "origins.differences[].";
  fields.push_back({one + "artifact", "word", "the artifact"});
  if (conditions) fields.push_back({one + "condition", "text", "condition of the curve"});
  fields.push_back({one + "quantity", "word", "PT or SN"});
  fields.push_back({one + "lab", "count", "participants of the lab on the curve"});
  fields.push_back({one + "web", "count", "participants of the web on the curve"});
  fields.push_back({one + "difference_" + length_key(names.of), length_unit(names.of),
                    "web less lab along the axis; null without both"});
  fields.push_back({one + "p", "probability", "of no difference, by permuting participants"});
  fields.push_back({one + "p_holm", "probability", "adjusted for all of them (Holm)"});
  return fields;
}

}  // namespace

CsvTable report_dictionary(const std::vector<CsvTable>& tables, const LevelAxis& axis, bool conditions) {
  CsvTable dictionary = data_dictionary(tables);
  const auto add = [&](const char* file, const std::vector<Field>& fields) {
    for (const Field& field : fields)
      dictionary.rows.push_back({std::string(file), field.path, field.unit, field.meaning});
  };
  const LevelNames names(axis);
  std::vector<Field> thresholds = thresholds_fields(names, conditions);
  const auto append = [&](std::vector<Field> more) {
    thresholds.insert(thresholds.end(), more.begin(), more.end());
  };
  if (std::any_of(tables.begin(), tables.end(),
                  [](const CsvTable& table) { return table.name == "lab_and_web"; }))
    append(origin_fields(names, conditions));
  if (std::any_of(tables.begin(), tables.end(),
                  [](const CsvTable& table) { return table.name == "thresholds_over_scenes"; }))
    append(scenes_fields(names, conditions));
  if (conditions) append(condition_fields(axis));
  if (!of_depth_widths(axis)) append(quantity_fields());
  add("thresholds.json", thresholds);
  add("report.json", report_fields(tables));
  return dictionary;
}

}  // namespace seamline::analysis
