#include <array>

#include "study/app/pictures/picture_store.h"
#include "study/app/screens/screen_task.h"
#include "study/app/screens/stage.h"
#include "study/app/screens/trial_view.h"
#include "window/look.h"

namespace seamline::study::app {
namespace {

/// A view that can turn turns to the object that is spoken of.
void look_towards(Stage& stage, const Trial& trial, int object) {
  const LookDefinition* view = look_at(stage, trial);
  if (view == nullptr || view->kind == LookKind::fixed) return;
  const ObjectMap& objects = stage.pictures.objects(trial);
  const PictureFrame& frame = objects.frames.at(object - 1);
  if (frame.width_px > 0) stage.looking.pose = pose_towards(objects, frame);
}

}  // namespace

/// The practice picture once more, with corners around the object that was inserted.
Outcome draw(const FeedbackScreen& screen, const Visit& visit, Stage& stage) {
  if (const std::optional<Trial> trial = trial_on_screen(visit); trial && screen.right_index >= 1)
    look_towards(stage, *trial, screen.right_index);
  stage.trial_drawn = screen.trial;
  const TrialPlace place = trial_place(stage);
  const bool alternatives = asks_for_alternatives(stage.set, screen.trial);
  if (const std::optional<Trial> trial = trial_on_screen(visit)) {
    const WindowTexture* picture = stage.pictures.find(*trial);
    if (alternatives)
      draw_task_feedback(stage, place, *trial);
    else if (picture != nullptr)
      show_picture(stage, *trial, *picture, place);
    if (screen.right_index >= 1 && !alternatives) {
      const ObjectMap& objects = stage.pictures.objects(*trial);
      const std::size_t index = screen.right_index - 1;
      draw_bracket(stage, place, seen_frames(stage, *trial).at(index));
      draw_bracket(stage, place, objects.right_eye_frames.at(index));
    }
  }
  const AskedTexts texts = asked_by(stage, screen.trial);
  const std::string text = screen.right_index >= 1
                               ? fill_in(screen.right() ? texts.feedback_right : texts.feedback_wrong,
                                         {{"object", name_of_right(stage, screen.trial, screen.right_index)}})
                               : "";
  draw_question(stage, place, Font::body, text, 0.9);
  const bool used =
      stage.ui.button_in({"continue", stage.phrase(Phrase::continue_button), Ui::ButtonKind::leading},
                         {place.questions.centre().x_px, place.questions.y_px + 3.6 * stage.ui.em()});
  if (used) return Continued{};
  return std::nullopt;
}

}  // namespace seamline::study::app
