#include "composites/place/measuring_window.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "composites/place/measuring_input.h"
#include "composites/place/place_page.h"
#include "composites/place_preview.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"
#include "window/look.h"
#include "window/type/find_font.h"
#include "window/window.h"
#include "window/window_texture.h"

namespace seamline::place {
namespace {

constexpr double arm_px = 9;  ///< of a cross
constexpr const char* measuring_help =
    "Click a place, type its distance from the camera in metres, Enter; two or more, near and far    "
    "Ctrl+Z: take back    Enter: go on    Esc: leave";

class Measurer {
 public:
  Measurer(const renderer::PlaceRequest& request, const renderer::SeenPhoto& seen)
      : request_(request),
        seen_(seen),
        aspect_(double{1} * seen.camera.width_px / seen.camera.height_px),
        window_({.title = "Seamline",
                 .fullscreen = false,
                 .width_px = most_window_px,
                 .height_px = static_cast<int>(most_window_px / aspect_ + bar_px),
                 .resizable = true}) {
    FontRequest font = find_font({});
    font.body_px = type_px;
    font.texts = {measuring_help};
    canvas_.set_font(font);
    texture_.smooth(true);
    const int width_px = std::min(most_window_px, seen.camera.width_px);
    texture_.upload(display_image(
        renderer::photograph_sized(seen.photograph.radiance, width_px,
                                   std::max(1, static_cast<int>(std::lround(width_px / aspect_)))),
        request.photo.exposure_ev));
  }

  std::vector<sensors::KnownPoint> run() {
    show();
    request_.said("depth has no scale yet: click places and type their distances");
    while (true) {
      stop_if_interrupted();
      for (FrameInput input = window_.next_input(longest_wait_s); input.anything;
           input = window_.next_input(0.0)) {
        const Rect picture = picture_in(window_.framebuffer_px(), aspect_);
        const MeasuringWish wish = measure(input, picture, measuring_);
        if (wish == MeasuringWish::leave) return {};
        if (wish == MeasuringWish::known_changed) fit();
        if (wish == MeasuringWish::go_on && fits_) return points();
      }
      show();
    }
  }

 private:
  [[nodiscard]] std::vector<sensors::KnownPoint> points() const {
    return renderer::known_points(measuring_.known, seen_, request_.photo.depth);
  }

  /// What the line of all known points is, by the reader that `composite` uses.
  void fit() {
    fits_ = false;
    said_.clear();
    if (measuring_.known.size() < least_known) return;
    renderer::PhotoDepthRequest depth = request_.photo.depth;
    depth.estimate->points = points();
    try {
      const renderer::PhotoDepth read =
          renderer::read_photo_depth(depth, seen_.photograph, seen_.lens, seen_.camera, seen_.fov_deg);
      for (const std::string& note : read.notes)
        if (note.find("AbsRel") != std::string::npos) said_ = note;
      fits_ = true;
    } catch (const InputError& error) {
      said_ = error.what();
    }
    request_.said(fmt::format("{} places: {}", measuring_.known.size(), said_));
  }

  [[nodiscard]] std::string line() const {
    if (measuring_.open) return fmt::format("distance in metres: {}_", measuring_.typed);
    if (!said_.empty()) return said_;
    return fmt::format("{} of {} places are known", measuring_.known.size(), least_known);
  }

  void cross(const Rect& picture, const renderer::MeasuredPlace& place, const std::string& label) {
    const Point at{picture.x_px + place.across * picture.width_px,
                   picture.y_px + place.down * picture.height_px};
    for (const auto& [colour, thickness_px] : {std::pair{look::bracket_edge, 4.0}, {look::bracket, 1.5}}) {
      canvas_.line({at.x_px - arm_px, at.y_px}, {at.x_px + arm_px, at.y_px}, colour, thickness_px);
      canvas_.line({at.x_px, at.y_px - arm_px}, {at.x_px, at.y_px + arm_px}, colour, thickness_px);
    }
    if (label.empty()) return;
    const Size size = canvas_.measure(Font::body, label);
    const Rect plate{at.x_px + arm_px, at.y_px + arm_px, size.width_px + margin_px, size.height_px};
    canvas_.fill(plate, look::card);
    canvas_.text(Font::body, {plate.x_px + margin_px / 2, plate.y_px}, label, look::ink);
  }

  void show() {
    const Size screen_px = window_.framebuffer_px();
    const Rect picture = picture_in(screen_px, aspect_);
    canvas_.begin(screen_px);
    draw_page(canvas_, picture, texture_, screen_px,
              {.line = line(),
               .help = measuring_help,
               .said = measuring_.complaint,
               .warned = !measuring_.complaint.empty()});
    for (const renderer::MeasuredPlace& place : measuring_.known)
      cross(picture, place, fmt::format("{} m", place.distance_m));
    if (measuring_.open) cross(picture, *measuring_.open, "");
    window_.clear(look::background);
    canvas_.end();
    window_.show();
  }

  const renderer::PlaceRequest& request_;
  const renderer::SeenPhoto& seen_;
  double aspect_;
  Window window_;
  Canvas canvas_;
  WindowTexture texture_;
  Measuring measuring_;
  bool fits_ = false;
  std::string said_;
};

}  // namespace

bool needs_measuring(const renderer::PhotoDepthRequest& depth) {
  return depth.estimate && !depth.estimate->stated && depth.estimate->points.empty() &&
         depth.estimate->reference.empty();
}

std::vector<sensors::KnownPoint> measure_in_window(const renderer::PlaceRequest& request,
                                                   const renderer::SeenPhoto& seen) {
  return Measurer(request, seen).run();
}

}  // namespace seamline::place
