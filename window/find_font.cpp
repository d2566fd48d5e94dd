#include "window/find_font.h"

#include <array>

#include "support/text/error.h"

namespace seamline::inline window {
namespace fs = std::filesystem;
namespace {

struct Family {
  const char* text;
  const char* heading;
};

/// Debian's fonts-dejavu-core first; then what other systems are likely to have.
constexpr std::array<Family, 4> families = {{
    {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
     "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"},
    {"/usr/share/fonts/TTF/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans-Bold.ttf"},
    {"/usr/share/fonts/truetype/freefont/FreeSans.ttf",
     "/usr/share/fonts/truetype/freefont/FreeSansBold.ttf"},
    {"/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
     "/usr/share/fonts/truetype/liberation/LiberationSans-Bold.ttf"},
}};

}  // namespace

FontRequest find_font(const fs::path& wanted) {
  if (!wanted.empty()) {
    if (!fs::is_regular_file(wanted))
      throw input_error({.file = wanted.string(),
                         .field = "session.font",
                         .wanted = "a TrueType font",
                         .found = "no such file"});
    return {.file = wanted, .heading_file = wanted, .characters = {}};
  }
  for (const Family& family : families)
    if (fs::is_regular_file(family.text))
      return {.file = family.text,
              .heading_file = fs::is_regular_file(family.heading) ? family.heading : family.text,
              .characters = {}};
  throw input_error({.field = "font",
                     .wanted = "DejaVu Sans (Debian: fonts-dejavu-core) or session.font in the study file",
                     .found = "neither"});
}

}  // namespace seamline::inline window
