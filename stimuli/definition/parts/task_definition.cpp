#include "stimuli/definition/parts/task_definition.h"

#include <fmt/core.h>

#include <array>

namespace seamline::inline stimuli {

namespace {

TaskFacts facts_by_kind(const TaskDefinition* task) {
  const TaskKind kind = task->kind;
  switch (kind) {
    case TaskKind::object:
      return {.alternatives = task->objects, .chance = 1.0 / task->objects, .rates = task->second_question};
    case TaskKind::pair:
      if (task->same)
        return {.kind = kind,
                .alternatives = 2,
                .chance = 0,
                .compares = true,
                .right_is_yes = true,
                .rates = false};
      return {.kind = kind,
              .alternatives = 2,
              .chance = 0.5,
              .draws_right = true,
              .rates = task->second_question};
    case TaskKind::interval:
      return {.kind = kind,
              .alternatives = task->pictures,
              .chance = 1.0 / task->pictures,
              .pictures = task->pictures,
              .draws_right = true,
              .rates = task->second_question};
    case TaskKind::yes_no:
      return {.kind = kind, .alternatives = 2, .chance = 0, .right_is_yes = true, .rates = false};
    case TaskKind::rating:
      return {.kind = kind,
              .alternatives = 2,
              .chance = 0,
              .right_is_yes = true,
              .chooses = false,
              .slides = task->slider};
    case TaskKind::match:
      return {.kind = kind, .alternatives = 3, .chance = 0, .rates = false};
  }
  return {};
}

}  // namespace

TaskFacts facts_of(const TaskDefinition* task) {
  if (task == nullptr) return {};
  TaskFacts facts = facts_by_kind(task);
  facts.objects = task->objects;
  facts.masks = task->mask != TaskMask::none;
  return facts;
}

std::string number_word(int number) {
  constexpr std::array<const char*, most_objects_of_scene> words = {"one",  "two", "three", "four",
                                                                    "five", "six", "seven", "eight"};
  return words.at(number - 1);
}

std::vector<std::string> impairment_labels() {
  return {"Imperceptible", "Perceptible, but not annoying", "Slightly annoying", "Annoying", "Very annoying"};
}

namespace {

std::vector<std::string> object_names(int objects) {
  if (objects == 2) return {"on the left", "on the right"};
  constexpr std::array<const char*, most_objects_of_scene> places = {"first", "second", "third",   "fourth",
                                                                     "fifth", "sixth",  "seventh", "eighth"};
  std::vector<std::string> names;
  for (int i = 0; i < objects; ++i) names.push_back(std::string(places.at(i)) + " from the left");
  return names;
}

/// Of another number than the usual three.
TaskTexts object_texts(int objects, const std::string& second, const std::string& end) {
  const std::string keys = objects == 2 ? "1 for left, 2 for right"
                                        : fmt::format("its number, counted from the left (1 to {})", objects);
  return {
      .question = fmt::format("Which of the {} objects was inserted into the picture?", number_word(objects)),
      .hint = fmt::format("Click an object, or press 1 {} {}", objects == 2 ? "or" : "to", objects),
      .instructions = fmt::format("Each picture shows a place with {} objects, from left to right.\n\nOne "
                                  "of them was not there when the picture was taken. It was inserted by a "
                                  "computer, and something about its light, its shadow or its edge may be "
                                  "wrong.\n\nChoose the object that you think was inserted: click it, or "
                                  "press {}. Often it will be hard to tell. Then guess.",
                                  number_word(objects), keys) +
                      second + end,
      .answers = object_names(objects)};
}

}  // namespace

namespace {

TaskTexts same_texts(const std::string& rest) {
  return {.question = "Are the two pictures the same?",
          .hint = "Click an answer, or press 1 or 2",
          .instructions =
              "Each time you see two pictures of the same place, side by side. Nothing was "
              "inserted into the left one. Press 1 if the right one differs from it, and 2 if "
              "both are the same. " +
              rest,
          .feedback_right = "Correct: they differ.",
          .feedback_wrong = "No, they differ.",
          .answers = {"Different", "Same"}};
}

}  // namespace

TaskTexts usual_texts(const TaskDefinition& task) {
  const std::string second =
      task.second_question
          ? "\n\nAfter that you are asked how noticeable the insertion was: press 1 to 4. If "
            "you saw nothing, choose the lowest one."
          : "";
  const std::string end = "\n\nPress Esc for a pause. A few practice pictures come first.";
  const std::string inserted =
      "An object may have been inserted into a picture by a computer, and something about its light, its "
      "shadow or its edge may be wrong.\n\n";
  switch (task.kind) {
    case TaskKind::object:
      return task.objects == usual_objects ? TaskTexts{} : object_texts(task.objects, second, end);
    case TaskKind::pair:
      if (task.same) return same_texts(inserted + end);
      return {.question = "Into which of the two pictures was an object inserted?",
              .hint = "Click a picture or an answer, or press 1 or 2",
              .instructions = "Each time you see two pictures of the same place, side by side. " + inserted +
                              "Choose the picture with the inserted object: click it, or press 1 for left, 2 "
                              "for right. Often it will be hard to tell. Then guess." +
                              second + end,
              .feedback_right = "Correct. It was: {object}.",
              .feedback_wrong = "No. It was: {object}.",
              .answers = {"Left", "Right"}};
    case TaskKind::interval:
      return {.question = "Into which of the pictures was an object inserted?",
              .hint = task.pictures == 2 ? "Click an answer, or press 1 or 2"
                                         : "Click an answer, or press 1, 2 or 3",
              .instructions =
                  fmt::format("Each time you see {} pictures of the same place, one after another. ",
                              task.pictures == 2 ? "two" : "three") +
                  inserted +
                  "Press the number of the picture with the inserted object: 1 for the first, 2 for the "
                  "second" +
                  (task.pictures == 2 ? "" : ", 3 for the third") +
                  ". Often it will be hard to tell. Then guess." + second + end,
              .feedback_right = "Correct. It was: {object}.",
              .feedback_wrong = "No. It was: {object}.",
              .answers = task.pictures == 2 ? std::vector<std::string>{"First", "Second"}
                                            : std::vector<std::string>{"First", "Second", "Third"}};
    case TaskKind::yes_no:
      return {.question = "Was an object inserted into this picture?",
              .hint = "Click an answer, or press 1 or 2",
              .instructions = inserted +
                              "Press 1 if you think that an object was inserted, and 2 if nothing was. In "
                              "some pictures nothing was." +
                              end,
              .feedback_right = "Correct: something was inserted.",
              .feedback_wrong = "No, something was inserted.",
              .answers = {"Yes", "No"}};
    case TaskKind::rating:
      return {.question = "How do you judge this picture?",
              .hint = task.slider ? "Click the line or press the arrow keys, then Enter"
                                  : "Click an answer, or press 1, 2, 3, 4 or 5",
              .instructions = inserted +
                              (task.slider ? "Judge each picture: click a place on the line below it, or go "
                                             "there with the arrow keys, then press Enter. In some "
                                           : "Judge each picture: click one of the five answers, or press 1 "
                                             "to 5. In some ") +
                              "pictures nothing was inserted." + end,
              .feedback_right = "Something was inserted into this picture.",
              .feedback_wrong = "Something was inserted into this picture."};
    case TaskKind::match:
      return {
          .question = "Where is the seam just seen?",
          .hint = "Arrow keys, the wheel, or 1 and 2 make it clearer or fainter. Enter or 3: it is just seen",
          .instructions =
              "An object was inserted into each picture by a computer. Something about its light, its "
              "shadow or its edge is wrong, and you decide how much.\n\nThe left arrow key makes the "
              "fault clearer, the right arrow key makes it fainter. Go to and fro until you see the fault "
              "only just, then press Enter.\n\nSome pictures begin with a clear fault, others with one that "
              "cannot be seen. If it is seen everywhere, stop where it is faintest; if it is seen nowhere, "
              "where it is clearest.\n\nPress Esc for a pause.",
          .answers = {"Clearer", "Fainter", "Just seen"}};
  }
  return {};
}

}  // namespace seamline::inline stimuli
