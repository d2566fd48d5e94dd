#include "study/app/screens/trace.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "study/app/pictures/picture_store.h"
#include "study/app/screens/screen_names.h"
#include "study/app/screens/trial_view.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::study::app {
namespace {

nlohmann::json rectangle(const Rect& rect) {
  return {rect.x_px, rect.y_px, rect.width_px, rect.height_px};
}

}  // namespace

Trace::Trace(const std::filesystem::path& file) {
  if (file.empty()) return;
  descriptor_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor_ < 0)
    throw input_error({.file = file.string(),
                       .field = request_name("trace"),
                       .wanted = "a file that can be written to",
                       .found = std::strerror(errno)});
}

Trace::~Trace() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void Trace::shown(const Visit& visit, const Stage& stage) {
  if (descriptor_ < 0) return;
  nlohmann::json line = {{"screen", screen_name(visit.screen)},
                         {"answered", answered_trials(visit.session.trials)},
                         {"items", nlohmann::json::object()}};
  for (const UiItem& item : stage.ui.items()) line["items"][item.id] = rectangle(item.rect);
  if (const Session* session = session_on_screen(visit)) {
    const auto* choosing = std::get_if<Choosing>(&session->phase);
    const bool too_soon =
        choosing != nullptr && monotonic_ns() < choosing->onset_ns + session->pace.minimum_viewing_ns;
    line["phase"] = too_soon ? "viewing" : phase_name(session->phase);  // nothing is asked yet
    line["trial"] = answered_trials(session->trials);
    const TrialPlace place = trial_place(stage);
    line["picture"] = rectangle(place.picture);
    if (const std::optional<Trial> due = current_trial(session->trials)) {
      if (const LookDefinition* view = look_at(stage, *due)) {
        line["pose"] = {stage.looking.pose.yaw_deg, stage.looking.pose.pitch_deg};
        line["fov_deg"] = view->horizontal_fov_deg;
      }
      line["kind"] = word(due->kind);
      line["stimulus"] = stage.set.manifest.stimuli.at(due->stimulus).id;
      for (const PictureFrame& frame : seen_frames(stage, *due))
        line["objects"].push_back(rectangle(on_screen(place, frame)));
    }
  }
  const std::string text = line.dump() + "\n";
  if (text == last_) return;
  last_ = text;
  if (::write(descriptor_, text.data(), text.size()) < 0) descriptor_ = -1;  // only a test is the poorer
}

}  // namespace seamline::study::app
