#pragma once
#include <string>
#include <vector>

namespace seamline::inline stimuli {

/// A page of the instructions: text, pictures, or both. A page of one picture alone is for scripts that the
/// window cannot shape.
struct InstructionPage {
  std::string text = {};                   ///< may be empty where there is a picture
  std::vector<std::string> pictures = {};  ///< PNG or JPEG files beside the study file, in order
  bool operator==(const InstructionPage&) const = default;
};

/// What the task is, and how to answer, in two pages without pictures.
[[nodiscard]] std::vector<InstructionPage> default_instructions();

/// Practice trials with feedback before the first trial. Their answers are kept apart and never analysed.
struct TrainingDefinition {
  int trials = 3;                         ///< the coarsest stimuli, one artifact after the other
  std::vector<std::string> stimuli = {};  ///< ids instead; then `trials` is their number
  std::string feedback_right = "Correct: it was the one {object}.";
  std::string feedback_wrong = "No, it was the one {object}.";
};

/// Trials whose answers are about the participant and not about depth maps. Absent unless the study file asks
/// for them, so that a study without [catch] keeps its hash, its number of trials, and, for simulated people,
/// its answers to the bit.
struct CatchDefinition {
  int attention = 0;  ///< trials with an insertion that nobody who looks can miss
  int reference = 0;  ///< trials where nothing was inserted: there is no right answer
  bool operator==(const CatchDefinition&) const = default;
};

}  // namespace seamline::inline stimuli
