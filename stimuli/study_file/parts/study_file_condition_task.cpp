#include "stimuli/study_file/parts/study_file_condition_task.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "stimuli/definition/looks/condition_tasks.h"
#include "stimuli/definition/parts/staircase_definition.h"
#include "stimuli/study_file/parts/study_file_task.h"

namespace seamline::inline stimuli {
namespace {

constexpr const char* beside = " beside a [condition.task]";

bool is_papers_words(const TaskDefinition& task) {
  return task.kind == TaskKind::object && task.objects == usual_objects;
}

/// All words, because the study's may be those of another task.
AskedTexts own_words_of(const TaskDefinition& task) {
  const std::string rating_hint = phrase_text({}, Phrase::rating_hint);
  if (is_papers_words(task))
    return {.question = SessionDefinition{}.question,
            .hint = phrase_text({}, Phrase::choice_hint),
            .rating_hint = rating_hint,
            .feedback_right = TrainingDefinition{}.feedback_right,
            .feedback_wrong = TrainingDefinition{}.feedback_wrong};
  const TaskTexts usual = usual_texts(task);
  const bool object = task.kind == TaskKind::object;
  return {.question = usual.question,
          .hint = usual.hint,
          .rating_hint = rating_hint,
          .feedback_right = object ? TrainingDefinition{}.feedback_right : usual.feedback_right,
          .feedback_wrong = object ? TrainingDefinition{}.feedback_wrong : usual.feedback_wrong};
}

/// The table as it stands, and the objects of the study's scenes.
TaskDefinition read_own_table(const TomlTable& table, int objects) {
  std::string question = table.text("question", "");
  TaskDefinition task = read_task_table(table, objects);
  task.own = own_words_of(task);
  if (!question.empty()) task.own.question = std::move(question);
  return task;
}

std::vector<InstructionPage> pages_of(const TaskDefinition* task) {
  if (task == nullptr || is_papers_words(*task)) return default_instructions();
  return {{.text = usual_texts(*task).instructions, .pictures = {}}};
}

}  // namespace

std::shared_ptr<const TaskDefinition> read_task_of_condition(const TomlTable& condition,
                                                             const StudyDefinition& study) {
  const auto table = condition.table("task");
  if (!table) return nullptr;
  if (table->has("blocks"))
    throw table->complaint("blocks", "no key blocks: conditions with tasks of their own are always in blocks",
                           "blocks");
  const int objects = objects_of(study);
  const TaskDefinition task = read_own_table(*table, objects);
  if (task.objects != objects)
    throw table->complaint("objects", fmt::format("{}, as in the study's scenes", objects),
                           fmt::format("{}", task.objects));
  if (task.kind == TaskKind::object && objects == 1)
    throw table->complaint("kind", "a task that one object is enough for", "\"object\"");
  if (task.kind == TaskKind::match)
    throw table->complaint("kind", "a task with right answers (a \"match\" has a study of its own)",
                           "\"match\"");
  if (facts_of(&task).right_is_yes && study.catches.reference == 0)
    throw condition.complaint("task.kind",
                              "at least one reference trial (catch.reference) beside a [condition.task] of "
                              "kind = \"" +
                                  std::string(word(task.kind)) + "\"",
                              "none");
  return std::make_shared<const TaskDefinition>(task);
}

void set_up_own_tasks(const TomlTable& study, StudyDefinition& definition) {
  if (!has_own_tasks(definition)) return;
  const auto refuse = [&](const char* field, const std::string& wanted, const std::string& found) {
    throw study.complaint(field, wanted + beside, found);
  };
  if (definition.conditions.size() < 2)
    throw study.complaint("condition.task", "[task], where the study has one condition", "[condition.task]");
  if (!std::holds_alternative<ConstantDefinition>(definition.procedure))
    refuse("procedure", "\"constant\"", "\"quest_plus\"");
  if (definition.task && definition.task->staircase) refuse("procedure", "\"constant\"", "\"staircase\"");
  if (facts_of(definition.task.get()).adjusts())
    refuse("task.kind", "a task with right answers", "\"match\"");
  if (definition.clip) refuse("clip", "stills", "a table [clip]");
  if (study.has("instructions")) return;
  std::vector<InstructionPage> pages;
  for (const TaskGroup& group : task_groups(definition))
    for (InstructionPage& page : pages_of(group.task.get())) {
      const auto is_same = [&](const InstructionPage& one) { return one.text == page.text; };
      if (std::none_of(pages.begin(), pages.end(), is_same)) pages.push_back(std::move(page));
    }
  definition.instructions = std::move(pages);
}

ConditionTasks read_condition_tasks_text(const std::string& text, const std::filesystem::path& said_to_be) {
  const TomlTable study = TomlTable::parse(text, said_to_be);
  const std::shared_ptr<const TaskDefinition> task = read_task_text(text, said_to_be);
  const int objects = task ? task->objects : usual_objects;
  ConditionTasks tasks;
  for (const TomlTable& condition : study.tables("condition"))
    if (const auto table = condition.table("task"))
      tasks[condition.text("name")] = std::make_shared<const TaskDefinition>(read_own_table(*table, objects));
  return tasks;
}

}  // namespace seamline::inline stimuli
