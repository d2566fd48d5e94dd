#include "composites/place/place_window.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "composites/measured_places.h"
#include "composites/objects/placing.h"
#include "composites/photo_world.h"
#include "composites/place/measuring_window.h"
#include "composites/place/place_input.h"
#include "composites/place/place_page.h"
#include "composites/place_preview.h"
#include "support/arithmetic/grid_index.h"
#include "support/running/interrupt.h"
#include "support/running/parallel.h"
#include "support/text/error.h"
#include "support/text/printable.h"
#include "support/text/shell_word.h"
#include "window/canvas.h"
#include "window/look.h"
#include "window/type/find_font.h"
#include "window/window.h"

namespace seamline::place {
namespace {

constexpr int preview_width_px = 480;
constexpr const char* help =
    "Drag: onto a surface    Wheel: turn    Shift+wheel: size    Arrows, Page Up/Down: shift (Shift: "
    "further)    Tab: next    D: another    F: floor    Delete    Ctrl+Z: take back    S: save    Esc: leave";
constexpr double grid_m = 0.5;

/// Marks the floor's grid in a picture of any size. `width_px`, `height_px`: of `lines`.
void mark_floor(const std::vector<std::uint8_t>& lines, int width_px, int height_px, ByteImage& picture) {
  constexpr std::array green = {60, 220, 130};
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < picture.width_px; ++x) {
      const int row = y * height_px / picture.height_px, column = x * width_px / picture.width_px;
      if (lines[grid_index(row, column, width_px)] == 0) continue;
      for (int c = 0; c < 3; ++c) {
        std::uint8_t& code = picture.values[grid_index(y, x, picture.width_px) * 3 + c];
        code = static_cast<std::uint8_t>((code + green[c]) / 2);
      }
    }
}

/// What is known of the file on the disk.
struct Saving {
  bool changed = false, warned = false;
  std::string said = {};
};

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
    font.texts = {help};
    canvas_.set_font(font);
    texture_.smooth(true);
    placing_.objects = std::move(opened.objects);
    for (const std::string& named : request.added) placing_.objects.push_back(renderer::new_object(named));
    saving_.changed = !request.added.empty();
    for (const std::string& sentence : preview_.stand(placing_.objects)) request.said(sentence);
    const std::filesystem::path outside = renderer::name_for(request.objects_file, placing_.objects);
    command_ = request.command + " --objects " + shell_word(request.objects_file);
    if (!outside.empty()) command_ += " --asset-root " + shell_word(outside.string());
    command_ += " --out " +
                shell_word(std::filesystem::path(request.objects_file).replace_extension(".png").string());
    floor_ = preview_.floor();
    if (floor_)
      request.said(fmt::format(
          "the floor: {:.2f} m {} the camera, {:.0f} % of the picture, {:.1f} to {:.1f} m away; its grid is of {} m",
          std::abs(floor_->height_m - world.seen.centre_m.y()),
          floor_->height_m < world.seen.centre_m.y() ? "below" : "above", 100 * floor_->share,
          floor_->nearest_m, floor_->farthest_m, grid_m));
    else
      request.said("no floor is seen: no surface of the picture is level");
    shows_floor_ = floor_.has_value();
  }

  void run() {
    set_objects();
    show();
    const std::int64_t begun_ns = monotonic_ns();
    bool more = preview_.refine(), first = true;
    for (bool stays = true; stays;) {
      show();
      if (std::exchange(first, false))
        request_.said(fmt::format("first picture after {:.3f} s",
                                  static_cast<double>(monotonic_ns() - begun_ns) * 1e-9));
      stop_if_interrupted();
      bool changed = false;
      FrameInput input = window_.next_input(more ? 0.0 : longest_wait_s);
      for (; stays && input.anything; input = window_.next_input(0.0)) stays = take(input, changed);
      if (changed) set_objects();
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
      renderer::save_objects(request_.objects_file, head_, command_, placing_.objects);
      saving_ = {.said = "saved"};
      request_.said(
          fmt::format("saved {}; its picture is made by\n  {}", printable(request_.objects_file), command_));
    }
    if (wanted.wish == Wish::floor) {
      shows_floor_ = floor_ && !shows_floor_;
      mark();
    }
    if (wanted.wish != Wish::leave) return true;
    if (!saving_.changed || saving_.warned) return false;
    saving_ = {.changed = true, .warned = true, .said = "not saved: S saves, Esc leaves without"};
    return true;
  }

  void set_objects() {
    preview_.set_objects(placing_.objects);
    mark();
  }
  /// Where the grid's lines are: objects hide them.
  void mark() {
    if (shows_floor_) grid_ = preview_.grid_on(*floor_, grid_m);
  }

  void show() {
    ByteImage picture = display_image(preview_.picture(), request_.photo.exposure_ev);
    if (shows_floor_) mark_floor(grid_, preview_.finest_width_px(), preview_.finest_height_px(), picture);
    texture_.upload(picture);
    const Size screen_px = window_.framebuffer_px();
    canvas_.begin(screen_px);
    draw_page(canvas_, picture_in(screen_px, aspect_), texture_, screen_px,
              {.line = renderer::placing_text(placing_.objects[placing_.chosen]),
               .help = help,
               .said = saving_.said,
               .warned = saving_.warned});
    window_.clear(look::background);
    canvas_.end();
    window_.show();
  }

  const renderer::PlaceRequest& request_;
  std::string head_, command_;
  double aspect_;
  Window window_;
  Canvas canvas_;
  WindowTexture texture_;
  renderer::PlacePreview preview_;
  renderer::Placing placing_;
  Dragging dragging_;
  Saving saving_;
  std::optional<renderer::FloorInView> floor_;
  bool shows_floor_ = false;
  std::vector<std::uint8_t> grid_;
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
  renderer::Notes notes({.line = {}, .note = request.note});
  renderer::PhotoWorld world;
  world.seen = renderer::see(request.photo, notes);
  if (needs_measuring(request.photo.depth)) {
    std::vector<sensors::KnownPoint> points = measure_in_window(request, world.seen);
    if (points.empty()) return;
    request.command += renderer::point_options(points);
    request.photo.depth.estimate->points = std::move(points);
  }
  renderer::read_photo_world(request.photo, world, notes);
  for (const std::string& light : world.known.text) request.said("light: " + light);
  Placer(request, world, std::move(opened)).run();
}

}  // namespace seamline::place
