#include "study/online/page/web_study.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "stimuli/definition/looks/condition_tasks.h"
#include "stimuli/definition/looks/study_look.h"
#include "stimuli/definition/moving/clip_definition.h"
#include "stimuli/definition/people/form_kinds.h"
#include "stimuli/definition/people/language_definition.h"
#include "stimuli/definition/people/recruitment_definition.h"
#include "stimuli/settings/people/form_settings.h"
#include "study/online/page/web_format.h"
#include "study/trials/level_ladders.h"
#include "study/trials/right_rule.h"
#include "study/trials/trial_picture.h"
#include "study/visit/visit_script.h"
#include "support/files/hash.h"

namespace seamline::study::online {
namespace {

using Json = nlohmann::ordered_json;

Json trial_json(const ShownNames& names, const WebPictures& pictures, const Trial& trial) {
  return {{"kind", word(trial.kind)},
          {"stimulus_id", names.name_of(trial)},
          {"picture", pictures.file.at({trial.kind, trial.stimulus})}};
}

/// With the pictures that the trial shows, where these are several: nothing else says which is right. Of a
/// match those of its ladder, their names, and with which it begins.
Json trial_json(const WebParts& parts, const Trial& trial) {
  Json json = trial_json(parts.names, parts.pictures, trial);
  const LevelLadders* ladders = parts.rules.ladders.get();
  const std::vector<Trial> shown = ladders != nullptr ? pictures_of_ladder(*ladders, trial)
                                                      : shown_pictures(parts.rules.task_of(trial), trial);
  if (!parts.own_task.empty()) json["task"] = parts.own_task.at(trial.stimulus);
  const Trial mask{.kind = TrialKind::mask, .stimulus = trial.stimulus};
  if (const auto found = parts.pictures.file.find({mask.kind, mask.stimulus});
      found != parts.pictures.file.end())
    json["mask"] = found->second;
  if (parts.briefed && parts.briefed->at(static_cast<std::size_t>(trial.stimulus)) >= 0)
    json["briefing"] = parts.briefed->at(static_cast<std::size_t>(trial.stimulus));
  if (shown.size() < 2) return json;
  if (ladders != nullptr) {
    json["start"] = ladders->places.at(trial.stimulus).rung;
    json["names"] = Json::array();
    for (const Trial& one : shown) json["names"].push_back(parts.names.name_of(one));
  }
  json["pictures"] = Json::array();
  for (const Trial& one : shown) json["pictures"].push_back(parts.pictures.file.at({one.kind, one.stimulus}));
  json["picture"] = json["pictures"].front();
  return json;
}

Json task_json(const TaskDefinition* definition, const SessionTask& task) {
  Json json = {{"kind", word(task.facts.kind)},   {"alternatives", task.facts.alternatives},
               {"pictures", task.facts.pictures}, {"exposure_ns", task.exposure_ns},
               {"gap_ns", task.gap_ns},           {"chooses", task.facts.chooses},
               {"rates", task.facts.rates},       {"pair_gap_px", pair_gap_px},
               {"answers", Json::array()},        {"labels", Json::array()}};
  if (definition != nullptr) {
    json["answers"] = definition->answers;
    json["labels"] = definition->labels;
  }
  if (task.mask_ns > 0) json["mask_ns"] = task.mask_ns;
  if (task.facts.slides) json["slides"] = true;
  if (task.facts.adjusts()) json["adjusts"] = true;
  if (task.facts.compares) json["compares"] = true;
  return json;
}

/// What conditions with tasks of their own ask, each with all its words as in `read`; a trial says which it
/// is.
Json own_tasks_json(const RenderedSet& set, const StudyDefinition& read) {
  const VisitScript script = make_visit_script(set);
  Json tasks = Json::array();
  for (const TaskGroup& group : task_groups(set.study)) {
    SessionTask paced;
    for (std::size_t i = 0; i < set.manifest.stimuli.size(); ++i)
      if (set.manifest.stimuli[i].stimulus.condition == group.conditions.front())
        paced = script.pace.own_tasks->at(i);
    const std::shared_ptr<const TaskDefinition> task = task_of(read, group.conditions.front());
    Json json = task_json(task.get(), paced);
    const AskedTexts texts = asked_texts(read, task.get());
    json.update({{"question", texts.question},
                 {"hint", texts.hint},
                 {"rating_hint", texts.rating_hint},
                 {"feedback_right", texts.feedback_right},
                 {"feedback_wrong", texts.feedback_wrong}});
    tasks.push_back(std::move(json));
  }
  return tasks;
}

Json texts_json(const StudyDefinition& study) {
  Json texts = Json::object();
  for (const PhraseEntry& entry : every_phrase())
    texts[std::string(entry.key)] = phrase_text(study.texts, entry.phrase);
  for (const auto& [key, text] : page_texts_of(study)) texts[key] = text;
  return texts;
}

/// What is read before the block of each condition, in their order; nothing where none is.
void add_briefings(const StudyDefinition& read, Json& json) {
  Json briefings = Json::array();
  bool any = false;
  for (const ConditionDefinition& condition : read.conditions) {
    briefings.push_back(condition.instructions);
    any = any || !condition.instructions.empty();
  }
  if (any) json["briefings"] = std::move(briefings);
}

/// Without codes, which the server keeps until somebody has one.
Json recruitment_json(const RecruitmentDefinition& recruitment) {
  return {{"identifiers", recruitment.identifiers},
          {"required", recruitment.identifiers_required},
          {"host", return_host(recruitment)}};
}

/// What the rows of a kind of question say, by their keys.
template <class Kind>
void add_keys(const Kind& kind, Json& json) {
  static_assert(!settings_of<Kind>.empty(), "include the header with its rows");
  for (const Setting<Kind>& row : settings_of<Kind>)
    std::visit(
        [&](const auto& value) {
          if constexpr (requires { Json(*value); }) json[std::string(row.key)] = *value;
        },
        value_of(row, kind));
}

/// `own`: the study's, whose options are what is stored.
Json form_json(const std::vector<FormField>& form, const std::vector<FormField>& own) {
  Json fields = Json::array();
  for (std::size_t i = 0; i < form.size(); ++i) {
    const FormField& field = form[i];
    Json json = {{"name", field.name},
                 {"label", field.label},
                 {"required", field.required},
                 {"kind", word_of(field.kind)}};
    std::visit([&](const auto& kind) { add_keys(kind, json); }, field.kind);
    const auto *options = options_of(field), *values = options_of(own.at(i));
    if (options != nullptr && *options != *values) json["values"] = *values;
    fields.push_back(std::move(json));
  }
  return fields;
}

Json instructions_json(const WebStudy& web, const StudyDefinition& read) {
  Json pages = Json::array();
  for (std::size_t i = 0; i < read.instructions.size(); ++i)
    pages.push_back({{"text", read.instructions[i].text}, {"pictures", web.instruction_files.at(i)}});
  return pages;
}

Json consent_json(const ConsentDefinition& consent) {
  return {{"text", consent.text},
          {"accept", consent.accept},
          {"decline", consent.decline},
          {"sha256", sha256(consent.text)}};
}

Json training_json(const WebStudy& web, const VisitScript& script) {
  const WebParts parts{web.names, web.pictures, web.rules, places_of_tasks(web.set), {}};
  Json trials = Json::array();
  for (std::size_t i = 0; i < script.training.size(); ++i) {
    Json trial = {{"training_index", i}};
    trial.update(trial_json(parts, script.training[i]));
    trial["right_index"] = script.training_right[i];
    trials.push_back(std::move(trial));
  }
  return trials;
}

Json values_of(std::map<std::string, Json> by_name) {
  Json values = Json::array();
  for (auto& [name, value] : by_name) values.push_back(std::move(value));
  return values;
}

Json stimuli_json(const WebStudy& web) {
  std::map<std::string, Json> by_name;
  for (const auto& [trial, file] : web.pictures.file) {
    if (trial.first != TrialKind::stimulus) continue;
    const std::string name = web.names.name_of({.kind = trial.first, .stimulus = trial.second});
    by_name[name] = {{"id", name},
                     {"file", file},
                     {"sha256", web.files.at(file).sha256},
                     {"width_px", web.set.manifest.width_px},
                     {"height_px", web.set.manifest.height_px}};
  }
  return values_of(std::move(by_name));
}

Json catches_json(const WebStudy& web) {
  std::map<std::string, Json> by_name;
  for (const auto& [trial, file] : web.pictures.file) {
    if (trial.first == TrialKind::stimulus) continue;
    const Trial shown{.kind = trial.first, .stimulus = trial.second};
    by_name[web.names.name_of(shown)] = trial_json(web.names, web.pictures, shown);
  }
  return values_of(std::move(by_name));
}

Json pictures_json(const WebStudy& web) {
  Json pictures = Json::array();
  for (const auto& [file, map] : web.pictures.map) {
    pictures.push_back({{"file", file},
                        {"sha256", web.files.at(file).sha256},
                        {"bytes", web.files.at(file).bytes},
                        {"width_px", web.set.manifest.width_px},
                        {"height_px", web.set.manifest.height_px},
                        {"map", map}});
    if (const auto base = web.pictures.base.find(file); base != web.pictures.base.end())
      pictures.back()["base"] = base->second;
  }
  return pictures;
}

Json look_json(const LookDefinition& look, const std::array<double, 2>& start) {
  Json json = {
      {"kind", word(look.kind)}, {"view_px", look.view_px}, {"horizontal_fov_deg", look.horizontal_fov_deg},
      {"start_deg", start},      {"yaw_deg", look.yaw_deg}, {"pitch_deg", look.pitch_deg},
      {"hint", look.hint}};
  if (look.start_spread_deg > 0) json["start_spread_deg"] = look.start_spread_deg;
  if (look.fov_limits_deg) json["fov_limits_deg"] = *look.fov_limits_deg;
  if (look.follows_device) json["follows_device"] = true;
  return json;
}

/// How each picture of all directions is looked at: `looks`, and by the stimulus' shown name which of them.
/// Nothing for other studies.
void add_looks(const WebStudy& web, Json& json) {
  const StudyDefinition& study = web.set.study;
  if (!is_panorama(study)) return;
  if (const LookDefinition* asked = comfort_asked(study))
    json["comfort"] = {{"question", asked->comfort_question}, {"labels", asked->comfort_labels}};
  Json looks = Json::array();
  std::map<std::string, Json> of_name;
  for (const auto& [shown, file] : web.pictures.file) {
    const Stimulus& stimulus = web.set.manifest.stimuli.at(shown.second).stimulus;
    const LookDefinition& look = *look_of(study, stimulus.condition);
    Json one = look_json(look, start_deg(look, study, stimulus.scene));
    auto known = std::find(looks.begin(), looks.end(), one);
    if (known == looks.end()) known = looks.insert(looks.end(), std::move(one));
    of_name[web.names.name_of({.kind = shown.first, .stimulus = shown.second})] = known - looks.begin();
  }
  json["looks"] = std::move(looks);
  json["look_of"] = of_name;
}

int most_trials_of_a_participant(const TrialRules& rules) {
  const std::vector<Trial> decided = decided_trials(rules, 0, {});
  return study::most_trials(trial_sequence(rules, {.slot = 0, .trials = decided, .answers = {}}));
}

}  // namespace

std::string web_study_text(const WebStudy& web) {
  const StudyDefinition& study = web.set.study;
  const VisitScript script = make_visit_script(web.set);
  Json json = {
      {"format", web_format},
      {"study_hash", web.set.manifest.study_hash},
      {"set_hash", web.set.set_hash},
      {"study_name", study.name},
      {"title", study.name},
      {"language", study.session.language},
      {"host", word(web.host)},
      {"pilot", web.pilot},
      {"adaptive", web.rules.is_adaptive()},
      {"slots", web.slots},
      {"orders", order_file(0)},
      {"most_trials", most_trials_of_a_participant(web.rules)},
      {"width_px", web.set.manifest.width_px},
      {"height_px", web.set.manifest.height_px},
      {"text_scale", study.session.text_scale},
      {"font", web.font},
      {"consent", consent_json(study.consent)},
      {"form", form_json(study.form, study.form)},
      {"instructions", instructions_json(web, study)},
      {"question", study.session.question},
      {"rating_question", study.session.rating_question},
      {"rating_labels", study.session.rating_labels},
      {"feedback_right", study.training.feedback_right},
      {"feedback_wrong", study.training.feedback_wrong},
      {"pace",
       {{"inter_trial_ns", script.pace.inter_trial_ns},
        {"minimum_viewing_ns", script.pace.minimum_viewing_ns},
        {"break_every_trials", script.pace.break_every_trials}}},
      {"texts", texts_json(study)},
      {"training", training_json(web, script)},
      {"stimuli", stimuli_json(web)},
      {"catches", catches_json(web)},
      {"pictures", pictures_json(web)},
  };
  if (study.recruitment) json["recruitment"] = recruitment_json(*study.recruitment);
  add_looks(web, json);
  if (study.languages) {
    json["languages"] = Json::array({{{"tag", study.session.language}}});
    for (const LanguageDefinition& language : study.languages->languages)
      json["languages"].push_back({{"tag", language.tag}, {"file", language_file(language.tag)}});
  }
  if (study.clip) json["clip"] = {{"frames_per_s", study.clip->frames_per_s}, {"loops", study.clip->loops}};
  if (study.task) json["task"] = task_json(study.task.get(), script.pace.task);
  if (has_own_tasks(study)) json["tasks"] = own_tasks_json(web.set, study);
  add_briefings(study, json);
  return json.dump(1) + "\n";
}

std::string web_language_text(const WebStudy& web, const StudyDefinition& read, const std::string& font) {
  Json json = {{"language", read.session.language},
               {"font", font},
               {"consent", consent_json(read.consent)},
               {"form", form_json(read.form, web.set.study.form)},
               {"instructions", instructions_json(web, read)},
               {"question", read.session.question},
               {"rating_question", read.session.rating_question},
               {"rating_labels", read.session.rating_labels},
               {"feedback_right", read.training.feedback_right},
               {"feedback_wrong", read.training.feedback_wrong},
               {"texts", texts_json(read)}};
  if (read.task) json["task"] = task_json(read.task.get(), make_visit_script(web.set).pace.task);
  if (has_own_tasks(read)) json["tasks"] = own_tasks_json(web.set, read);
  add_briefings(read, json);
  return json.dump(1) + "\n";
}

std::vector<int> places_of_tasks(const RenderedSet& set) {
  std::vector<int> places;
  if (!has_own_tasks(set.study)) return places;
  const std::vector<TaskGroup> groups = task_groups(set.study);
  for (const ManifestStimulus& record : set.manifest.stimuli)
    for (std::size_t group = 0; group < groups.size(); ++group)
      if (const std::vector<std::string>& names = groups[group].conditions;
          std::find(names.begin(), names.end(), record.stimulus.condition) != names.end())
        places.push_back(static_cast<int>(group));
  return places;
}

std::string language_file(const std::string& tag) {
  return "languages/" + tag + ".json";
}

std::string order_text(const WebParts& parts, std::span<const Trial> trials) {
  std::string text = "[";
  for (std::size_t i = 0; i < trials.size(); ++i) {
    Json trial = {{"trial_index", i}};
    trial.update(trial_json(parts, trials[i]));
    text += (i == 0 ? "\n" : ",\n") + trial.dump();
  }
  return text + "\n]\n";
}

std::string order_file(int slot) {
  return fmt::format("orders/{:04}.json", slot);
}

}  // namespace seamline::study::online
