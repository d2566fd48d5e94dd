#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "study/app/pictures/frame_times.h"
#include "study/app/pictures/picture_store.h"
#include "study/app/screens/stage.h"
#include "study/app/screens/trace.h"
#include "study/running/participant_request.h"
#include "study/running/visit_store.h"
#include "study/visit/exposures.h"
#include "window/canvas.h"
#include "window/panorama_view.h"
#include "window/window.h"

namespace seamline::study::app {

/// The loop between a visit and the person: shows the visit's screen, and gives the visit what happened. What
/// follows from it is the visit's business (study/visit/visit.h), what is kept the store's
/// (study/running/visit_store.h).
class Application {
 public:
  /// Opens the window and checks it. Throws InputError when there is none, or when it cannot show the
  /// pictures pixel for pixel and the request does not allow scaling.
  Application(const RenderedSet& set, VisitStore& store, const ParticipantRequest& request);

  /// Until the last page is closed, or the person leaves. Throws InputError when the session had to stop.
  void run();

 private:
  // application_screen.cpp: what the window must be able to do
  void check_screen();
  void set_type();
  [[nodiscard]] std::optional<DisplayProfile> known_display();
  void keep_display(const DisplayFacts& facts) const;

  // application.cpp: one frame after the other
  void run_frame();
  void wait_for_input();
  [[nodiscard]] bool frame_is_due(std::int64_t now_ns) const;
  void note(const char* kind, std::int64_t now_ns, std::string detail = {});
  void note_window_events();
  void note_answer(const VisitEvent& event);
  void note_poses(std::int64_t now_ns);
  void step(const VisitEvent& event);
  [[nodiscard]] bool handle_pause();
  void prepare_pictures(std::int64_t now_ns);
  void show_frame(std::int64_t begun_ns);
  void note_exposure(const Session* session, std::int64_t shown_ns, std::int64_t period_ns);
  void plan_next_frame(std::int64_t begun_ns, std::int64_t shown_ns);

  const RenderedSet& set_;
  VisitStore& store_;
  const ParticipantRequest& request_;
  Window window_;
  Canvas canvas_;
  Ui ui_;
  DisplayInfo display_;
  Trace trace_;
  FrameTimes frame_times_;
  PictureStore pictures_;
  PanoramaView panorama_view_;
  Stage stage_;
  Visit visit_;

  double type_scale_ = 0;                   ///< of the fonts that are loaded
  std::optional<std::int64_t> due_ns_ = 0;  ///< when a frame is due without any input; none: never
  bool input_arrived_ = false;
  int layouts_ = 0;                           ///< of the frame that is being made
  std::int64_t swap_ = 0;                     ///< number of the next swap
  std::optional<std::int64_t> turn_ns_ = {};  ///< the due picture's turn came then
  ExposureCounter exposures_;                 ///< of the trial on the screen
  ExposureCounter masks_;
};

}  // namespace seamline::study::app
