#include "study/app/run_participant.h"

#include "stimuli/set/set_files.h"
#include "study/app/application.h"

namespace seamline::study::app {

void run_participant_in_window(const ParticipantRequest& request) {
  app::require_display();
  const StudySet set = load_study_set(request.set_folder);
  check_set_shapes(set.folder, set.manifest);  // their bytes are looked at when they are loaded
  VisitStore store(set, request.log, {.code = request.code, .pilot = request.pilot});
  app::Application application(set, store, request);
  application.run();
}

}  // namespace seamline::study::app
