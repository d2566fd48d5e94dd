#include "study/log/origin.h"

namespace seamline::study {

std::string_view word(Origin origin) {
  switch (origin) {
    case Origin::window:
      return "window";
    case Origin::serve:
      return "serve";
    case Origin::static_host:
      return "static";
    case Origin::jatos:
      return "jatos";
  }
  return {};
}

std::optional<Origin> origin_from_word(std::string_view text) {
  for (const Origin origin : every_origin)
    if (word(origin) == text) return origin;
  return std::nullopt;
}

}  // namespace seamline::study
