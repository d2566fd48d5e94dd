#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "study/app/screens/stage.h"
#include "window/look.h"

namespace seamline::study::app {
namespace {

// ISO/IEC 7810 ID-1.
constexpr double card_width_mm = 85.60, card_height_mm = 53.98, card_corner_mm = 3.18;
constexpr double least_card_px = 150;
constexpr double nearest_cm = 20, farthest_cm = 500;

/// What the monitor says of itself is a start; it is often wrong, hence the card.
double first_card_width_px(const DisplayInfo& display, double most_px) {
  const double mm_per_px = display.physical_width_mm > 0 && display.mode_width > 0
                               ? static_cast<double>(display.physical_width_mm) / display.mode_width
                               : 25.4 / 96;
  return std::clamp(std::round(card_width_mm / mm_per_px), least_card_px, most_px);
}

std::optional<double> distance_mm(const std::string& text_cm) {
  double cm = 0;
  const auto [stop, error] = std::from_chars(text_cm.data(), text_cm.data() + text_cm.size(), cm);
  if (error != std::errc() || stop != text_cm.data() + text_cm.size()) return std::nullopt;
  if (!(cm >= nearest_cm && cm <= farthest_cm)) return std::nullopt;
  return cm * 10;
}

bool continue_button(Stage& stage) {
  const std::array<Ui::ButtonText, 1> next = {
      {{"continue", stage.phrase(Phrase::continue_button), Ui::ButtonKind::leading}}};
  return stage.ui.buttons(next).has_value();
}

void draw_card_step(Stage& stage) {
  Ui& ui = stage.ui;
  Drafts& drafts = stage.drafts;
  const double most_px = std::min(34 * ui.em(), stage.screen_px.width_px - 6 * ui.em());
  if (drafts.card_width_px <= 0) drafts.card_width_px = first_card_width_px(stage.display, most_px);
  ui.paragraph(stage.phrase(Phrase::display_card));
  const double mm_per_px = card_width_mm / drafts.card_width_px;
  // Room for the largest card, so that the page stays where it is while the frame grows.
  const Rect room = ui.room(most_px, std::min(most_px * card_height_mm / card_width_mm,
                                              std::max(stage.screen_px.height_px - 20 * ui.em(), 120.0)));
  const double height_px = std::round(card_height_mm / mm_per_px);
  const Rect card{std::round(room.centre().x_px - drafts.card_width_px / 2),
                  std::round(room.centre().y_px - height_px / 2), drafts.card_width_px, height_px};
  stage.canvas().fill(card, grey(206), card_corner_mm / mm_per_px);
  stage.canvas().outline(card, look::ink, 2, card_corner_mm / mm_per_px);
  ui.gap(0.8);
  ui.prefer("card");
  ui.slider("card", drafts.card_width_px, least_card_px, most_px, 1);
  drafts.card_width_px = std::round(drafts.card_width_px);
  ui.gap(0.5);
  // Read from left to right in every language: between the marks of an isolate.
  ui.note(fmt::format("\u2066{:.0f} px = 85.60 mm\u2069", drafts.card_width_px));
  if (continue_button(stage)) drafts.display_step = DisplayStep::distance;
}

void draw_distance_step(Stage& stage) {
  Ui& ui = stage.ui;
  Drafts& drafts = stage.drafts;
  ui.label(stage.phrase(Phrase::display_distance));
  ui.prefer("distance");
  if (ui.number("distance", drafts.distance_cm, 6)) drafts.distance_wrong = false;
  ui.gap(0.5);
  if (drafts.distance_wrong)
    ui.problem(stage.phrase(Phrase::form_out_of_range, {{"least", fmt::format("{:g}", nearest_cm)},
                                                        {"most", fmt::format("{:g}", farthest_cm)}}));
  if (continue_button(stage)) {
    drafts.distance_wrong = !distance_mm(drafts.distance_cm);
    if (!drafts.distance_wrong) drafts.display_step = DisplayStep::gamma;
  }
}

/// One-pixel stripes of black and white send half of white's light; so does code 188 where the curve is
/// sRGB's.
ByteImage striped_picture(int width_px, int height_px) {
  constexpr std::uint8_t half_light = 188;
  ByteImage picture{width_px, height_px, 1, {}};
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      const bool striped = x * 4 / width_px % 2 == 0;
      picture.values.push_back(striped ? (y % 2 == 0 ? 255 : 0) : half_light);
    }
  return picture;
}

std::optional<bool> draw_gamma_step(Stage& stage) {
  Ui& ui = stage.ui;
  if (stage.stripes.name() == 0) stage.stripes.upload(striped_picture(560, 180));
  ui.paragraph(stage.phrase(Phrase::display_gamma));
  ui.picture(stage.stripes);
  const std::array<Ui::ButtonText, 2> answers = {
      {{"differ", stage.phrase(Phrase::display_differ)},
       {"same", stage.phrase(Phrase::display_confirm), Ui::ButtonKind::leading}}};
  const std::optional<int> used = ui.buttons(answers, false);
  if (!used) return std::nullopt;
  return *used == 1;
}

}  // namespace

Outcome draw(const DisplayScreen&, const Visit&, Stage& stage) {
  Ui& ui = stage.ui;
  Drafts& drafts = stage.drafts;
  const DisplayStep before = drafts.display_step;
  std::optional<bool> looks_same;
  ui.begin_card(36);
  ui.heading(stage.phrase(Phrase::display_title));
  switch (before) {
    case DisplayStep::card:
      draw_card_step(stage);
      break;
    case DisplayStep::distance:
      draw_distance_step(stage);
      break;
    case DisplayStep::gamma:
      looks_same = draw_gamma_step(stage);
      break;
  }
  ui.end_card();
  if (drafts.display_step != before) ui.reset();
  if (!looks_same) return std::nullopt;
  return DisplayConfirmed{
      display_facts(stage, {.mm_per_px = card_width_mm / drafts.card_width_px,
                            .viewing_distance_mm = distance_mm(drafts.distance_cm).value(),
                            .gamma_confirmed = *looks_same})};
}

}  // namespace seamline::study::app
