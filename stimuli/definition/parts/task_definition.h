#pragma once
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace seamline::inline stimuli {

struct StaircaseDefinition;  // parts/staircase_definition.h
struct StudyDefinition;      // study_definition.h

/// What a trial asks.
enum class TaskKind {
  object,    ///< one picture: which of its objects was inserted?
  pair,      ///< reference and stimulus side by side: in which of the two was an object inserted?
  interval,  ///< pictures one after another, one of them the stimulus and the others its reference: which
             ///< one?
  yes_no,    ///< one picture, the stimulus or (in catch trials) its reference: was an object inserted?
  rating,    ///< one picture, judged on five labels, with nothing to choose
  match      ///< one picture, whose level the participant moves until the seam is just seen (adjustment)
};
inline constexpr std::array<TaskKind, 6> every_task_kind = {TaskKind::object,   TaskKind::pair,
                                                            TaskKind::interval, TaskKind::yes_no,
                                                            TaskKind::rating,   TaskKind::match};
[[nodiscard]] std::string_view word(TaskKind kind);

/// What covers the place of a picture once its exposure ends.
enum class TaskMask {
  none,
  noise,     ///< squares of random grey
  scrambled  ///< squares of the scene's reference, in another order
};

[[nodiscard]] std::string word(TaskMask mask);

/// Where a slider can stand, from nothing seen to most noticeable. Its fifths are the five labels of a
/// rating, as on the continuous scale of ITU-R BT.500.
inline constexpr int slider_end = 100;
[[nodiscard]] constexpr int rating_at(int position) {
  return position * 5 / slider_end < 4 ? position * 5 / slider_end : 4;
}

/// Objects of a scene: those of a study that does not say how many, and at most.
inline constexpr int usual_objects = 3, most_objects_of_scene = 8;

/// What a condition's own task says in place of the study's words; empty: the study's.
struct AskedTexts {
  std::string question = {}, hint = {}, rating_hint = {}, feedback_right = {}, feedback_wrong = {};
};

/// `[task]` of a study, or of a condition. A study without it asks for the object, once a stimulus, and then
/// for a rating.
struct TaskDefinition {
  TaskKind kind = TaskKind::object;
  int objects = usual_objects;  ///< of each scene, from left to right
  bool same = false;            ///< pair: the reference stands on the left; is the other one the same?
  int pictures = 2;             ///< interval: shown one after another, 2 or 3
  double exposure_s = 0;        ///< how long a picture is seen; 0: until the answer (never of `interval`)
  double gap_s = 0.5;           ///< interval: grey between two pictures
  TaskMask mask = TaskMask::none;
  double mask_s = 0.1;          ///< from the end of each exposure; of the gap that it begins, too
  bool second_question = true;  ///< after the choice: how noticeable was it? Never of yes_no and rating
  /// What the alternatives are called, below the picture; of `rating` and the usual three objects none, of
  /// another number of objects what screen readers and practice call them. Can be edited in a set.
  std::vector<std::string> answers = {};
  std::vector<std::string> labels = {};  ///< rating: five (of a slider also two), from nothing seen on
  bool slider = false;                   ///< rating: a place on a line in place of a label
  /// How often each stimulus is shown to a participant; of `match` each object in each condition.
  int repetitions = 1;
  bool blocks = false;  ///< trials of a condition follow each other, conditions in a balanced Latin square
  std::shared_ptr<const StaircaseDefinition> staircase = {};  ///< places the levels; null: none does
  AskedTexts own = {};                                        ///< of a condition's own task
};

/// What follows from a task, in one place.
struct TaskFacts {
  TaskKind kind = TaskKind::object;
  int objects = usual_objects;  ///< of each scene
  int alternatives = 3;  ///< to choose among; of yes_no and rating 2: something is there (1), or nothing (2)
  /// How often somebody who sees nothing is right. 0 where only reference trials tell: how often people see
  /// something where nothing is.
  double chance = 1.0 / 3;
  int pictures = 1;           ///< one after another in a trial
  bool draws_right = false;   ///< which alternative is right is drawn for each trial
  bool compares = false;      ///< a picture stands on the right of its reference, and is the same or not
  bool right_is_yes = false;  ///< the first alternative is right wherever something was inserted
  bool chooses = true;        ///< there is a choice
  bool rates = true;          ///< there is a rating
  bool slides = false;        ///< the rating is a place on a line, 0 to `slider_end`
  bool masks = false;         ///< a mask follows each picture

  /// One of three objects is chosen, then rated.
  [[nodiscard]] bool is_papers() const {
    return kind == TaskKind::object && alternatives == usual_objects && rates;
  }
  /// The alternatives are steps (`MatchStep`), and nothing is right.
  [[nodiscard]] bool adjusts() const { return kind == TaskKind::match; }
};

/// The alternatives of a task that adjusts.
enum class MatchStep : int { clearer = 1, fainter = 2, just_seen = 3 };

/// Of a study's task; null: the task of a study that names none.
[[nodiscard]] TaskFacts facts_of(const TaskDefinition* task);

/// Of each scene of a study.
[[nodiscard]] int objects_of(const StudyDefinition& study);

/// The labels of the rating task where the study names none: the impairment scale of ITU-R BT.500, turned
/// round so that 0 is nothing seen.
[[nodiscard]] std::vector<std::string> impairment_labels();

/// "one" to "eight".
[[nodiscard]] std::string number_word(int number);

/// What is asked, told and hinted where the study file does not say it.
struct TaskTexts {
  std::string question = {}, hint = {}, instructions = {}, feedback_right = {}, feedback_wrong = {};
  std::vector<std::string> answers = {};
};
[[nodiscard]] TaskTexts usual_texts(const TaskDefinition& task);

/// The meaning of a task as text, for the study's hash; empty for null.
[[nodiscard]] std::string canonical_text(const TaskDefinition* task);

}  // namespace seamline::inline stimuli
