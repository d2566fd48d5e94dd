#include <fmt/core.h>

#include "study/app/application.h"
#include "study/app/screens/instruction_pictures.h"
#include "study/app/screens/study_texts.h"
#include "study/app/screens/text_size.h"
#include "study/trials/trial_picture.h"
#include "support/files/confined_path.h"
#include "support/text/error.h"
#include "support/text/request_name.h"
#include "window/type/find_font.h"

namespace seamline::study::app {
namespace {

/// The window is a screen's.
void require_no_headset(const StudyDefinition& study) {
  for (const ConditionDefinition& condition : list_conditions(study))
    if (const LookDefinition* seen = look_of(study, condition);
        seen != nullptr && seen->kind == LookKind::head)
      throw input_error({.field = "look.kind",
                         .wanted = "\"fixed\" or \"mouse\" in a window (`seamline export web` makes a "
                                   "page, which knows headsets)",
                         .found = "\"head\""});
}

WindowRequest window_request(const RenderedSet& set, const ParticipantRequest& request) {
  constexpr int least_width_px = 1100, least_height_px = 760, margin_px = 40;
  return {.title = "Seamline",
          .fullscreen = !request.windowed,
          .width_px =
              std::max(least_width_px, static_cast<int>(shown_picture_size(set).width_px) + 2 * margin_px),
          .height_px =
              std::max(least_height_px, static_cast<int>(shown_picture_size(set).height_px) + 5 * margin_px)};
}

bool same_screen(const DisplayFacts& facts, const DisplayInfo& display) {
  return facts.mm_per_px > 0 && facts.viewing_distance_mm > 0 && facts.mode_width_px == display.mode_width &&
         facts.mode_height_px == display.mode_height &&
         facts.framebuffer_width_px == display.framebuffer_width_px;
}

std::string key_of(const DisplayInfo& display) {
  return screen_key(display.monitor, display.mode_width, display.mode_height, display.framebuffer_width_px);
}

}  // namespace

Application::Application(const RenderedSet& set, VisitStore& store, const ParticipantRequest& request)
    : set_(set),
      store_(store),
      request_(request),
      window_(window_request(set, request)),
      ui_(canvas_),
      display_(window_.display()),
      trace_(request.trace),
      frame_times_(request.frame_times),
      pictures_(set, request.allow_scaling),
      stage_{.ui = ui_,
             .set = set,
             .pictures = pictures_,
             .display = display_,
             .scaling_allowed = request.allow_scaling,
             .screen_px = window_.framebuffer_px()} {
  set_type();
  check_screen();
  stage_.instruction_pictures = load_instruction_pictures(set);
}

void Application::set_type() {
  const std::string& file = set_.study.session.font;
  FontRequest font = find_font(
      file.empty()
          ? std::filesystem::path()
          : path_below(set_.folder, file,
                       {.file = (set_.folder / set_.manifest.study_file).string(), .field = "session.font"}));
  font.body_px = body_size_px(display_, set_.study.session.text_scale * stage_.text_scale);
  font.language = set_.study.session.language;
  for (const ShownText& shown : shown_texts(set_.study)) font.texts.push_back(shown.text);
  canvas_.set_font(font);
  type_scale_ = stage_.text_scale;
}

/// Pictures are shown pixel for pixel, or not at all.
void Application::check_screen() {
  require_no_headset(set_.study);
  const Size picture_px = shown_picture_size(set_);
  const Size needed_px = needed_screen(picture_px, ui_.em());
  require_panel(set_.study, stage_.screen_px, request_.allow_scaling);
  const std::optional<Point> corner_px = picture_corner(set_.study);
  if (fits(stage_.screen_px, picture_px, ui_.em())) {
    stage_.pixel_check = check_pixels(window_, canvas_, picture_px, ui_.em(), corner_px);
    if (stage_.pixel_check.different == 0 || (request_.allow_scaling && !corner_px)) return;
    throw input_error(
        {.field = "display",
         .wanted = "a screen that shows the pictures' exact bytes (or " + request_name("allow_scaling") + ")",
         .found =
             fmt::format("{} of {} bytes changed", stage_.pixel_check.different, stage_.pixel_check.bytes)});
  }
  if (request_.allow_scaling && !corner_px) return;
  throw input_error(
      {.field = "display",
       .wanted =
           fmt::format("at least {:.0f} x {:.0f} pixels for pictures of {:.0f} x {:.0f} with the questions "
                       "below them (or {}, which shrinks the pictures and logs it)",
                       needed_px.width_px, needed_px.height_px, picture_px.width_px, picture_px.height_px,
                       request_name("allow_scaling")),
       .found = fmt::format("{:.0f} x {:.0f}", stage_.screen_px.width_px, stage_.screen_px.height_px)});
}

/// What was measured before on this machine and screen: in the person's configuration, or else in the log.
std::optional<DisplayProfile> Application::known_display() {
  if (request_.display_check) return std::nullopt;
  if (const auto profile = read_display_profile(display_profile_file(), key_of(display_))) return profile;
  const DisplayFacts here = display_facts(stage_, {.mm_per_px = 1, .viewing_distance_mm = 1});
  const std::optional<DisplayFacts> logged = store_.latest_display(here.machine, here.monitor);
  if (!logged || !same_screen(*logged, display_)) return std::nullopt;
  return DisplayProfile{.mm_per_px = logged->mm_per_px,
                        .viewing_distance_mm = logged->viewing_distance_mm,
                        .gamma_confirmed = logged->gamma_confirmed};
}

void Application::keep_display(const DisplayFacts& facts) const {
  write_display_profile(display_profile_file(), key_of(display_),
                        {.mm_per_px = facts.mm_per_px,
                         .viewing_distance_mm = facts.viewing_distance_mm,
                         .gamma_confirmed = facts.gamma_confirmed});
}

}  // namespace seamline::study::app
