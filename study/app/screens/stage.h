#pragma once
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/app/pictures/display_profile.h"
#include "study/app/pictures/pixel_check.h"
#include "study/trials/looking.h"
#include "study/trials/rendered_set.h"
#include "study/visit/visit.h"
#include "window/panorama_view.h"
#include "window/ui.h"
#include "window/window.h"

namespace seamline::study::app {

class PictureStore;

/// Which of the display check's steps is on the screen.
enum class DisplayStep { card, distance, gamma };

/// What a person has entered and not yet sent: the only state that screens have.
struct Drafts {
  std::map<std::string, std::string> form;  ///< by field
  DisplayStep display_step = DisplayStep::card;
  double card_width_px = 0;
  std::string distance_cm;
  bool distance_wrong = false;
  Point mouse_at_onset;  ///< corners follow the mouse once it has moved, not where it happened to rest
  int slider = -1;       ///< where a slider stands, 0 to `slider_end`; -1: it has no place yet
  bool slider_held = false;
  int trial_focus = -1;  ///< what the keyboard is on in a trial: ratings 0..3, then objects; -1: nothing
};

/// A view of a panorama while its trial is on the screen, and how far a hand has turned it.
struct LookDraft {
  std::optional<Trial> trial = {};  ///< whose; another one begins at its start
  Pose pose = {};
  std::optional<LookDefinition> zoomed = {};  ///< the look with the field that keys led to
  std::optional<Point> grabbed = {};          ///< where the mouse was, while its button is held
  bool dragged = false;                       ///< it has moved since it was pressed
  PoseRecorder poses = {};
};

/// A view to be drawn below what the canvas holds.
struct PanoramaOnScreen {
  const WindowTexture* panorama = nullptr;
  Rect rect;
  PanoramaPose pose;
};

/// What a screen draws on and reads from.
struct Stage {
  Ui& ui;
  const RenderedSet& set;
  PictureStore& pictures;
  const DisplayInfo& display;
  PixelCheck pixel_check = {};
  bool scaling_allowed = false;
  FrameInput input = {};
  Size screen_px = {};
  Drafts drafts = {};
  LookDraft looking = {};
  std::optional<PanoramaOnScreen> panorama = {};  ///< of the frame that is being made
  std::optional<Trial> trial_drawn = {};  ///< the last one: where conditions ask differently, what it asks
  std::optional<int> picture_seen = {};   ///< in it, of those that a task's trial shows in turn, from 0
  std::optional<int> mask_seen = {};      ///< the same of the picture whose mask is seen
  double text_scale = 1;                  ///< what the person chose, on top of the study's
  std::vector<std::vector<WindowTexture>> instruction_pictures = {};  ///< by page
  WindowTexture stripes = {};                                         ///< of the gamma pattern
  bool leave = false;                                                 ///< the person asked to leave for now
  bool close = false;                                                 ///< the last page was closed
  std::optional<int> comfort = {};  ///< the answer at a break, from 1, that is not yet noted

  [[nodiscard]] std::string phrase(Phrase which,
                                   const std::vector<std::pair<std::string, std::string>>& values = {}) const;
  [[nodiscard]] Canvas& canvas() const { return ui.canvas(); }
};

// One function a screen, one file each: draws the screen and returns what the person did.

using Outcome = std::optional<VisitEvent>;

[[nodiscard]] Outcome draw(const ConsentScreen&, const Visit&, Stage&);
[[nodiscard]] Outcome draw(const FormScreen&, const Visit&, Stage&);
[[nodiscard]] Outcome draw(const DisplayScreen&, const Visit&, Stage&);
[[nodiscard]] Outcome draw(const InstructionScreen&, const Visit&, Stage&);
[[nodiscard]] Outcome draw(const TrainingScreen&, const Visit&, Stage&);
[[nodiscard]] Outcome draw(const FeedbackScreen&, const Visit&, Stage&);
[[nodiscard]] Outcome draw(const ReadyScreen&, const Visit&, Stage&);
[[nodiscard]] Outcome draw(const TrialScreen&, const Visit&, Stage&);
[[nodiscard]] Outcome draw(const BreakScreen&, const Visit&, Stage&);
[[nodiscard]] Outcome draw(const BriefingScreen&, const Visit&, Stage&);
[[nodiscard]] Outcome draw(const PauseScreen&, const Visit&, Stage&);
[[nodiscard]] Outcome draw(const ThanksScreen&, const Visit&, Stage&);
[[nodiscard]] Outcome draw(const DeclinedScreen&, const Visit&, Stage&);
[[nodiscard]] Outcome draw(const StoppedScreen&, const Visit&, Stage&);

/// Of the pictures as they are shown, or of the largest view of panoramas, which are never shown whole.
[[nodiscard]] Size shown_picture_size(const RenderedSet& set);
/// What the display check knows, with the pixels per degree that follow.
[[nodiscard]] DisplayFacts display_facts(const Stage& stage, const DisplayProfile& profile);

}  // namespace seamline::study::app
