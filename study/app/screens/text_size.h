#pragma once
#include "study/app/screens/stage.h"

namespace seamline::study::app {

/// A control on pages where it does not disturb: how large all texts are.
void choose_text_size(Stage& stage);

/// Size of the type for a text scale (the study's times the person's): larger on screens with smaller pixels.
[[nodiscard]] double body_size_px(const DisplayInfo& display, double text_scale);

}  // namespace seamline::study::app
