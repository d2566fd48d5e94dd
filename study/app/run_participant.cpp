#include "study/app/run_participant.h"

#include "stimuli/set/manifest_pictures.h"
#include "study/app/application.h"

namespace seamline::study::app {

void run_participant_in_window(const ParticipantRequest& request) {
  require_display();
  const RenderedSet set = load_rendered_set(request.set_folder);
  check_manifest_shapes(set.folder, set.manifest);  // their bytes are looked at when they are loaded
  VisitStore store(set, request.log, {.code = request.code, .pilot = request.pilot});
  app::Application application(set, store, request);
  application.run();
}

}  // namespace seamline::study::app
