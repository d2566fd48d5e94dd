#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stimuli/definition/artifact.h"
#include "stimuli/definition/axis.h"
#include "stimuli/definition/form_definition.h"
#include "stimuli/definition/quantity.h"
#include "study/log/origin.h"
#include "study/placement/trial.h"

namespace seamline::inline stimuli {
struct TaskDefinition;  // parts/task_definition.h
}

namespace seamline::study {

/// One answer to one stimulus, as the log holds it.
struct Answer {
  std::string participant;  ///< a code, never a name
  int trial_index = 0;      ///< 0-based place in the participant's order
  std::string stimulus_id;
  std::string scene;
  Artifact artifact = Artifact::none;
  std::string object;
  int object_index = 0;  ///< where the object stands, and the right choice, from 1
  int depth_width_px = 0;
  std::string condition = {};  ///< its name; empty where the study has one condition
  double level = 0;            ///< of the log's quantity
  int chosen_index = 0;        ///< from 1
  int rating = 0;              ///< 1..4, asked on every trial
  std::int64_t choice_ns = 0;  ///< monotonic, from the image's onset to the choice; 0 for simulated people
  std::int64_t rating_ns = 0;  ///< from the image's onset to the rating; at least choice_ns
  double image_scale = 1;      ///< screen pixels a picture pixel; 1 unless --allow-scaling was given
  int right_index = 0;         ///< the right choice of a task with alternatives of its own; 0: object_index

  /// The right choice.
  [[nodiscard]] int right() const { return right_index != 0 ? right_index : object_index; }
  [[nodiscard]] bool correct() const { return chosen_index == right(); }
  /// Noticeability (paper section 4.2): 0 when the wrong object was chosen, else the rating.
  [[nodiscard]] int noticeability() const { return correct() ? rating : 0; }
};

/// One answer to a catch trial.
struct CatchTrialAnswer {
  std::string participant;
  int trial_index = 0;  ///< among all trials of the participant
  TrialKind kind = TrialKind::attention;
  std::string scene;
  int right_index = 0;  ///< from 1; 0 where nothing is right (a reference; yes or no: 2)
  int chosen_index = 0;
  int rating = 0;
  std::int64_t choice_ns = 0, rating_ns = 0;
  std::string condition = {};  ///< whose task it asks

  [[nodiscard]] bool right() const { return chosen_index == right_index; }
};

struct ParticipantRecord {
  std::string code;
  bool pilot = false;
  bool excluded = false;
  bool simulated = false;
  std::string observer;  ///< kind of simulated observer, empty for a person
  bool completed = false;
  std::uint64_t seed = 0;                 ///< of the simulation; 0 for a person
  int stimulus_trials = 0;                ///< decided so far; catch trials are not among them
  int slot = 0;                           ///< which order of trials
  std::optional<double> image_gain = {};  ///< of the simulated observer `image`
  bool in_progress = false;               ///< a session is open somewhere now
  int sessions = 0;                       ///< begun
  int restarts = 0;                       ///< how often the earlier answers were set aside
  std::int64_t last_seen_unix_s = 0;      ///< last answer or beginning of a session
  std::vector<FormAnswer> form = {};
  Origin origin = Origin::window;  ///< how they came to the study
};

/// Everything the analysis needs from a log.
struct LogContents {
  std::filesystem::path file;
  std::string study_name, study_hash, set_hash;
  Quantity quantity = Quantity::depth_width_px;     ///< what the levels of the stimuli are values of
  Direction noticeability = Direction::decreasing;  ///< as the level grows
  std::filesystem::path set_folder;                 ///< where the set was; it may be gone
  std::string study_text;                       ///< the study file's text at the time of the first session
  std::vector<ParticipantRecord> participants;  ///< in order of arrival
  std::vector<Answer> answers;                  ///< to stimuli, ordered by participant, then trial
  std::vector<CatchTrialAnswer> catches;        ///< to catch trials, in the same order
  int forgotten_participants = 0;               ///< how many were deleted by request
  int declined_visits = 0;                      ///< how many did not consent; nothing else is known of them
  std::shared_ptr<const TaskDefinition> task = {};  ///< of the study; null: it names none
  /// Of the conditions that have their own, by name.
  std::map<std::string, std::shared_ptr<const TaskDefinition>> own_tasks = {};
};

/// What a condition of a log asks; null: the paper's question.
[[nodiscard]] std::shared_ptr<const TaskDefinition> task_of(const LogContents& log,
                                                            const std::string& condition);

/// Reads a log, also while a session is writing to it. Throws InputError when the file is missing, is not
/// SQLite, is damaged, or is of a schema version that is not known. In a log of schema version 2 every level
/// is a depth width, without a condition.
[[nodiscard]] LogContents read_log(const std::filesystem::path& path);

}  // namespace seamline::study
