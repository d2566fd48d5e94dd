#include "place/place_window.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>

#include "place/place_input.h"
#include "renderer/composite/photo_world.h"
#include "renderer/composite/place_preview.h"
#include "renderer/composite/placing.h"
#include "support/running/interrupt.h"
#include "support/running/parallel.h"
#include "support/text/error.h"
#include "support/text/printable.h"
#include "window/canvas.h"
#include "window/find_font.h"
#include "window/look.h"
#include "window/window.h"

namespace seamline::place {
namespace {

constexpr int preview_width_px = 480, most_window_px = 1280;
constexpr double longest_wait_s = 0.25;  ///< after which Ctrl-C in the terminal is seen
constexpr double type_px = 18, bar_px = 64, margin_px = 8;
constexpr const char* help =
    "Drag: onto a surface    Wheel: turn    Shift+wheel: size    Arrows, Page Up/Down: shift (Shift: "
    "further)    Tab: next    D: another    Delete    Ctrl+Z: take back    S: save    Esc: leave";

/// Where the objects begin that were named beside those of the file: on the surface in the picture's middle.
void put_in_middle(const renderer::PlacePreview& preview, std::vector<renderer::PlacedModel>& objects) {
  const auto seen = preview.look(0.5, 0.6);
  double aside_m = 0;
  for (renderer::PlacedModel& object : objects) {
    if (seen.real_m) object.position_m = *seen.real_m;
    object.position_m.x() += aside_m;
    aside_m += 0.4;
  }
}

/// A picture of this shape, as large as fits above the bar.
Rect picture_in(const Size& screen_px, double aspect) {
  const double room_px = std::max(1.0, screen_px.height_px - bar_px);
  const double width_px = std::min(screen_px.width_px, room_px * aspect);
  return {(screen_px.width_px - width_px) / 2, (room_px - width_px / aspect) / 2, width_px,
          width_px / aspect};
}

/// What is known of the file on the disk.
struct Saving {
  bool changed = false, warned = false;
  std::string said = {};
};

void draw(Canvas& canvas, const Rect& picture, const Texture& texture, const Size& screen_px,
          const std::string& chosen, const Saving& saving) {
  canvas.picture(texture, picture);
  const double y_px = screen_px.height_px - bar_px + margin_px;
  canvas.text(Font::body, {margin_px, y_px}, chosen, look::ink_on_background);
  canvas.text(Font::small, {margin_px, y_px + 1.5 * type_px}, help, look::quiet_on_background);
  const Size said = canvas.measure(Font::body, saving.said);
  canvas.text(Font::body, {screen_px.width_px - said.width_px - margin_px, y_px}, saving.said,
              saving.warned ? look::problem : look::ink_on_background);
}

class Placer {
 public:
  Placer(const renderer::PlaceRequest& request, const renderer::PhotoWorld& world,
         renderer::OpenedObjects opened)
      : request_(request),
        head_(std::move(opened.head)),
        aspect_(double{1} * world.seen.camera.width_px / world.seen.camera.height_px),
        window_({.title = "Seamline",
                 .fullscreen = false,
                 .width_px = most_window_px,
                 .height_px = static_cast<int>(most_window_px / aspect_ + bar_px),
                 .resizable = true}),
        preview_(world, preview_width_px, request.photo.threads) {
    FontRequest font = find_font({});
    font.body_px = type_px;
    font.characters = help;
    canvas_.set_font(font);
    texture_.smooth(true);
    placing_.objects = std::move(opened.objects);
    std::vector<renderer::PlacedModel> added;
    for (const std::string& named : request.added)
      added.push_back(renderer::new_object(named, request.objects_file));
    put_in_middle(preview_, added);
    saving_.changed = !added.empty();
    placing_.objects.insert(placing_.objects.end(), added.begin(), added.end());
  }

  void run() {
    preview_.set_objects(placing_.objects);
    show();
    const std::int64_t begun_ns = monotonic_ns();
    bool more = preview_.refine(), first = true;
    for (bool stays = true; stays;) {
      show();
      if (std::exchange(first, false)) {
        fmt::print("first picture after {:.3f} s\n", static_cast<double>(monotonic_ns() - begun_ns) * 1e-9);
        std::fflush(stdout);
      }
      stop_if_interrupted();
      bool changed = false;
      FrameInput input = window_.next_input(more ? 0.0 : longest_wait_s);
      for (; stays && input.anything; input = window_.next_input(0.0)) stays = take(input, changed);
      if (changed) preview_.set_objects(placing_.objects);
      more = stays && preview_.refine();
    }
  }

 private:
  /// Returns whether the window stays.
  bool take(const FrameInput& input, bool& changed) {
    const Asked wanted =
        asked(input, picture_in(window_.framebuffer_px(), aspect_), preview_, placing_, dragging_);
    if (wanted.action && renderer::act(placing_, *wanted.action)) {
      changed = true;
      saving_ = {.changed = true};
    }
    if (wanted.wish == Wish::save) {
      renderer::save_objects(request_.objects_file, head_, placing_.objects);
      saving_ = {.said = "saved"};
      fmt::print("saved {}\n", printable(request_.objects_file));
      std::fflush(stdout);
    }
    if (wanted.wish != Wish::leave) return true;
    if (!saving_.changed || saving_.warned) return false;
    saving_ = {.changed = true, .warned = true, .said = "not saved: S saves, Esc leaves without"};
    return true;
  }

  void show() {
    texture_.upload(display_image(preview_.picture(), request_.photo.exposure_ev));
    const Size screen_px = window_.framebuffer_px();
    canvas_.begin(screen_px);
    draw(canvas_, picture_in(screen_px, aspect_), texture_, screen_px,
         renderer::placing_text(placing_.objects[placing_.chosen]), saving_);
    window_.clear(look::background);
    canvas_.end();
    window_.show();
  }

  const renderer::PlaceRequest& request_;
  std::string head_;
  double aspect_;
  Window window_;
  Canvas canvas_;
  Texture texture_;
  renderer::PlacePreview preview_;
  renderer::Placing placing_;
  Dragging dragging_;
  Saving saving_;
};

}  // namespace

void place_in_window(const renderer::PlaceRequest& asked_for) {
  require_display();
  renderer::PlaceRequest request = asked_for;
  if (request.photo.threads == 0) request.photo.threads = default_thread_count();
  request.photo.depth.threads = request.photo.threads;
  renderer::OpenedObjects opened;
  if (std::filesystem::exists(request.objects_file))
    opened = renderer::open_objects(request.objects_file, request.asset_root);
  if (opened.objects.empty() && request.added.empty())
    throw input_error({.file = request.objects_file,
                       .wanted = "a file of objects, or --add OBJECT to begin one",
                       .found = "neither"});
  renderer::Notes notes;
  renderer::PhotoWorld world;
  world.seen = renderer::see(request.photo, notes);
  renderer::read_photo_world(request.photo, world, notes);
  for (const std::string& light : world.known.text) fmt::print("light: {}\n", light);
  Placer(request, world, std::move(opened)).run();
}

}  // namespace seamline::place
