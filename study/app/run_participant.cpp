#include "study/app/run_participant.h"

#include "stimuli/set/manifest_pictures.h"
#include "stimuli/study_file/people/study_file_language.h"
#include "study/app/application.h"
#include "study/trials/study_languages.h"
#include "support/text/request_name.h"

namespace seamline::study::app {

void run_participant_in_window(const ParticipantRequest& request) {
  require_display();
  RenderedSet set = load_rendered_set(request.set_folder);
  const std::vector<FormField> own_form = set.study.form;
  if (const auto texts = read_study_texts(
          set.study, request.language.empty() ? set.study.session.language : request.language,
          request_name("language"))) {
    check_whole(set.study, *texts);
    set.study = in_language(set.study, *texts);
  }
  check_manifest_shapes(set.folder, set.manifest);  // their bytes are looked at when they are loaded
  VisitStore store(set, request.log,
                   {.code = request.code,
                    .pilot = request.pilot,
                    .language = set.study.languages ? set.study.session.language : "",
                    .own_form = own_form});
  app::Application application(set, store, request);
  application.run();
}

}  // namespace seamline::study::app
