#include "stimuli/study_file/parts/study_file_task.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>
#include <variant>

#include "stimuli/definition/looks/condition_tasks.h"
#include "stimuli/definition/parts/staircase_definition.h"
#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/settings/people/task_settings.h"
#include "stimuli/settings/read_settings.h"
#include "support/text/error.h"

namespace seamline::inline stimuli {
namespace {

std::vector<std::string> read_task_labels(const TomlTable& task, bool slider) {
  if (!task.has("labels")) return impairment_labels();
  std::vector<std::string> labels = task.texts("labels");
  const std::set<std::string> different(labels.begin(), labels.end());
  const bool so_many = labels.size() == 5 || (slider && labels.size() == 2);
  if (!so_many || different.size() != labels.size() || different.contains(""))
    throw task.complaint("labels",
                         std::string(slider ? "two or five" : "five") +
                             " texts that differ, from nothing seen to most noticeable",
                         fmt::format("{}, {} of them different", labels.size(), different.size()));
  return labels;
}

std::vector<std::string> read_answers(const TomlTable& task, const TaskDefinition& definition) {
  std::vector<std::string> usual = usual_texts(definition).answers;
  if (!task.has("answers")) return usual;
  if (usual.empty())
    throw task.complaint("answers",
                         "kind = \"pair\", \"interval\", \"yes_no\" or \"match\", or other than three "
                         "objects, where they are set",
                         "kind = \"" + std::string(word(definition.kind)) + "\"");
  std::vector<std::string> answers = task.texts("answers");
  const std::set<std::string> different(answers.begin(), answers.end());
  if (answers.size() != usual.size() || different.size() != usual.size() || different.contains(""))
    throw task.complaint("answers", fmt::format("{} texts that differ", usual.size()),
                         fmt::format("{}, {} of them different", answers.size(), different.size()));
  return answers;
}

}  // namespace

TaskDefinition read_task_table(const TomlTable& table, int usual_number_of_objects) {
  TaskDefinition task;
  task.objects = usual_number_of_objects;
  read_setting(table, "kind", task);
  task.second_question = task.kind == TaskKind::object;
  if (task.kind == TaskKind::interval) task.exposure_s = 0.5;
  read_settings(table, task);
  if (task.same && table.has("second_question") && task.second_question)
    throw table.complaint("second_question", "false beside asks = \"same\"", "true");
  task.second_question = task.second_question && !task.same;
  const bool rates = task.kind == TaskKind::rating;
  if (!rates && table.has("labels"))
    throw table.complaint("labels", "kind = \"rating\" where it is set",
                          "kind = \"" + std::string(word(task.kind)) + "\"");
  if (rates) task.labels = read_task_labels(table, task.slider);
  task.answers = read_answers(table, task);
  table.finish();
  return task;
}

namespace {

/// QUEST+ knows the chance of the task; where only reference trials tell it, QUEST+ learns it, too.
void set_guess_of_task(const TomlTable& study, const TaskFacts& facts, QuestPlusDefinition& quest) {
  if (const auto settings = study.table("quest_plus"); settings && settings->has("guess")) return;
  quest.guess =
      facts.right_is_yes ? ParameterRange{0.02, 0.3, 5} : ParameterRange{facts.chance, facts.chance, 1};
}

void check_quest_plus(const TomlTable& study, StudyDefinition& definition) {
  auto* quest = std::get_if<QuestPlusDefinition>(&definition.procedure);
  if (quest == nullptr) return;
  const TaskDefinition& task = *definition.task;
  const TaskFacts facts = facts_of(&task);
  if (task.repetitions > 1)
    throw study.complaint("task.repetitions",
                          "1 beside procedure = \"quest_plus\", which repeats as it needs",
                          fmt::format("{}", task.repetitions));
  if (quest->outcome != PlacementOutcome::correct && !facts.rates)
    throw study.complaint("quest_plus.outcome", "\"correct\" beside a [task] that asks for no rating",
                          "\"noticeability\" or \"joint\"");
  set_guess_of_task(study, facts, *quest);
}

StaircaseDefinition read_staircase_table(const TomlTable& table) {
  StaircaseDefinition staircase;
  read_settings(table, staircase);
  table.finish();
  return staircase;
}

/// `[staircase]`, which stands beside `procedure = "staircase"`; null: none.
std::shared_ptr<const StaircaseDefinition> read_staircase(const TomlTable& study) {
  const auto table = study.table("staircase");
  const bool wanted = study.has("procedure") && study.text("procedure") == "staircase";
  if (table && !wanted)
    throw study.complaint("procedure", "\"staircase\" where there is a table [staircase]",
                          study.has("procedure") ? "\"" + study.text("procedure") + "\"" : "nothing");
  if (!wanted) return nullptr;
  return std::make_shared<const StaircaseDefinition>(table ? read_staircase_table(*table)
                                                           : StaircaseDefinition{});
}

void check_staircase(const TomlTable& study, const StudyDefinition& definition) {
  const TaskDefinition& task = *definition.task;
  if (!task.staircase) return;
  if (task.repetitions > 1)
    throw study.complaint("task.repetitions", "1 beside procedure = \"staircase\", which repeats as it needs",
                          fmt::format("{}", task.repetitions));
  const TaskFacts facts = facts_of(&task);
  if (facts.right_is_yes || facts.adjusts())
    throw study.complaint("procedure",
                          "\"constant\" or \"quest_plus\" beside a [task] of kind = \"" +
                              std::string(word(task.kind)) +
                              "\": a staircase follows right and wrong answers of a forced choice",
                          "\"staircase\"");
  const std::vector<double>& levels = definition.level.values;
  for (const double start : task.staircase->start)
    if (std::find(levels.begin(), levels.end(), start) == levels.end())
      throw study.complaint("staircase.start", "levels of the study", fmt::format("{}", start));
  if (levels.front() <= 0 && definition.level.axis() == Axis::log2)
    throw study.complaint("procedure", "no level \"none\" beside \"staircase\": it has no place on the axis",
                          "\"none\" among the levels");
  if (levels.size() < 2)
    throw study.complaint("procedure", "at least two levels beside \"staircase\"", "one");
}

/// In a match nothing is right: what needs a right answer is refused. Practice is left out for the same
/// reason.
void check_match(const TomlTable& study, StudyDefinition& definition) {
  if (definition.task->kind != TaskKind::match) return;
  const std::string beside = " beside a [task] of kind = \"match\", in which no answer is right or wrong";
  if (!std::holds_alternative<ConstantDefinition>(definition.procedure))
    throw study.complaint("procedure", "\"constant\"" + beside, "\"quest_plus\"");
  if (definition.catches.attention > 0 || definition.catches.reference > 0)
    throw study.complaint("catch", "no catch trials" + beside, "a table [catch]");
  const auto training = study.table("training");
  if (training && (training->has("stimuli") || (training->has("trials") && definition.training.trials > 0)))
    throw study.complaint("training", "no practice with feedback" + beside, "a table [training]");
  definition.training.trials = 0;
  const std::vector<double>& levels = definition.level.values;
  const bool apart = definition.level.axis() == Axis::log2 && levels.front() <= 0;
  const std::size_t rungs = levels.size() - (apart ? 1U : 0U);
  if (rungs < 3)
    throw study.complaint(
        "task.kind",
        "at least 3 levels, other than \"none\", between which a participant of a \"match\" moves",
        fmt::format("{}", rungs));
}

/// What the study asks for beside its task, and the task cannot give.
void check_task(const TomlTable& study, StudyDefinition& definition) {
  const TaskDefinition& task = *definition.task;
  const std::string kind = "kind = \"" + std::string(word(task.kind)) + "\"";
  const TaskFacts facts = facts_of(&task);
  check_quest_plus(study, definition);
  check_staircase(study, definition);
  if (definition.task->blocks && is_placed_by_answers(definition))
    throw study.complaint("task.blocks", "none where the answers place the trials", "\"condition\"");
  check_match(study, definition);
  if (facts.right_is_yes && definition.catches.reference == 0)
    throw study.complaint("catch.reference",
                          "at least one reference trial beside a [task] of " + kind +
                              ": nothing else tells how often people see something where nothing is",
                          "0");
}

/// The study's own words stay.
void set_usual_texts(const TomlTable& study, StudyDefinition& definition) {
  const TaskDefinition& task = *definition.task;
  if (task.kind == TaskKind::object && task.objects == usual_objects) return;
  const TaskTexts texts = usual_texts(task);
  const auto says = [&](const char* table, const char* key) {
    const auto found = study.table(table);
    return found && found->has(key);
  };
  if (!says("session", "question")) definition.session.question = texts.question;
  if (!study.has("instructions")) definition.instructions = {{.text = texts.instructions, .pictures = {}}};
  const Phrase hint = task.kind == TaskKind::rating ? Phrase::rating_hint : Phrase::choice_hint;
  definition.texts.try_emplace(hint, texts.hint);
  if (texts.feedback_right.empty()) return;
  if (!says("training", "feedback_right")) definition.training.feedback_right = texts.feedback_right;
  if (!says("training", "feedback_wrong")) definition.training.feedback_wrong = texts.feedback_wrong;
}

/// Of a study that names staircases alone it is the paper's question, with them.
std::shared_ptr<const TaskDefinition> read_task_of(const TomlTable& study) {
  const auto table = study.table("task");
  const std::shared_ptr<const StaircaseDefinition> staircase = read_staircase(study);
  if (!table && !staircase) return nullptr;
  TaskDefinition task = table ? read_task_table(*table, usual_objects) : TaskDefinition{};
  task.staircase = staircase;
  return std::make_shared<const TaskDefinition>(std::move(task));
}

}  // namespace

void read_task(const TomlTable& study, StudyDefinition& definition) {
  const std::shared_ptr<const TaskDefinition> task = read_task_of(study);
  if (!task) return;
  definition.task = task;
  check_task(study, definition);
  set_usual_texts(study, definition);
}

bool is_placed_by_answers(const StudyDefinition& study) {
  return std::holds_alternative<QuestPlusDefinition>(study.procedure) ||
         (study.task && study.task->staircase);
}

namespace {

/// One clip plays at a time, and it ends by itself.
void check_beside_clip(const TomlTable& study, const StudyDefinition& definition) {
  if (!definition.clip || !definition.task) return;
  const TaskDefinition& task = *definition.task;
  if (task.kind == TaskKind::pair || task.kind == TaskKind::interval || task.kind == TaskKind::match)
    throw study.complaint("task.kind",
                          "\"object\", \"yes_no\" or \"rating\" beside [clip]: one clip plays at a time",
                          "\"" + std::string(word(task.kind)) + "\"");
  if (task.exposure_s > 0)
    throw study.complaint("task.exposure_s", "0 beside [clip], whose frames say how long it is seen",
                          fmt::format("{}", task.exposure_s));
}

/// Arrows, drags and clicks turn the view, and choose what it shows.
void check_beside_look(const TomlTable& study, const StudyDefinition& definition) {
  bool turns = definition.look != nullptr;
  for (const ConditionDefinition& condition : definition.conditions) turns = turns || condition.look;
  if (!turns) return;
  for (const TaskGroup& group : task_groups(definition))
    if (const TaskKind kind = facts_of(group.task.get()).kind; kind != TaskKind::object)
      throw study.complaint("task.kind",
                            "\"object\" beside [look], in which an object is chosen by looking at it",
                            "\"" + std::string(word(kind)) + "\"");
}

}  // namespace

void check_task_alone(const TomlTable& study, const StudyDefinition& definition) {
  const bool own = has_own_tasks(definition);
  const bool in_blocks = own || (definition.task && definition.task->blocks);
  for (const ConditionDefinition& condition : definition.conditions)
    if (!condition.instructions.empty() && !in_blocks)
      throw study.complaint("condition.instructions",
                            "task.blocks = \"condition\" beside it: it is read before a block",
                            "no blocks, in the condition " + condition.name);
  if (!definition.task && !own) return;
  if (definition.task && definition.task->blocks && definition.conditions.size() < 2)
    throw study.complaint("task.blocks", "at least two [[condition]] to make blocks of",
                          fmt::format("{}", definition.conditions.size()));
  check_beside_clip(study, definition);
  check_beside_look(study, definition);
}

std::shared_ptr<const TaskDefinition> read_task_text(const std::string& text,
                                                     const std::filesystem::path& said_to_be) {
  return read_task_of(TomlTable::parse(text, said_to_be));
}

}  // namespace seamline::inline stimuli
