#pragma once
#include <string>
#include <vector>

#include "study/trials/rendered_set.h"

namespace seamline::study::app {

/// A text of the study file that the window shows, and where it stands.
struct ShownText {
  std::string field;
  std::string text;
};

/// Every text that a participant of the study may see.
[[nodiscard]] std::vector<ShownText> shown_texts(const StudyDefinition& study);

}  // namespace seamline::study::app
