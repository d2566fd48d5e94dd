#include "window/type/find_font.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <span>

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

/// Where Noto's fonts are: Debian, Arch, Fedora.
constexpr std::array<const char*, 3> noto_folders = {"/usr/share/fonts/truetype/noto",
                                                     "/usr/share/fonts/noto", "/usr/share/fonts/google-noto"};

constexpr Family no_family = {nullptr, nullptr};
constexpr Family lohit = {"/usr/share/fonts/truetype/lohit-devanagari/Lohit-Devanagari.ttf", nullptr};
constexpr Family loma = {"/usr/share/fonts/truetype/tlwg/Loma.ttf",
                         "/usr/share/fonts/truetype/tlwg/Loma-Bold.ttf"};
constexpr Family chinese = {"/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc",
                            "/usr/share/fonts/opentype/noto/NotoSansCJK-Bold.ttc"};
constexpr const char* noto = "fonts-noto-core";
constexpr const char* noto_cjk = "fonts-noto-cjk";

struct ScriptRow {
  Script script;
  const char* name;
  const char* package;              ///< Debian's
  Family other = no_family;         ///< besides Noto's
  const char* noto_file = nullptr;  ///< null: NotoSans and the name
};

constexpr std::array<ScriptRow, 28> script_rows = {{
    {script("Arab"), "Arabic", noto},
    {script("Hebr"), "Hebrew", noto},
    {script("Deva"), "Devanagari", "fonts-lohit-deva", lohit},
    {script("Thai"), "Thai", "fonts-tlwg-loma-ttf", loma},
    {script("Beng"), "Bengali", noto},
    {script("Guru"), "Gurmukhi", noto},
    {script("Gujr"), "Gujarati", noto},
    {script("Orya"), "Oriya", noto},
    {script("Taml"), "Tamil", noto},
    {script("Telu"), "Telugu", noto},
    {script("Knda"), "Kannada", noto},
    {script("Mlym"), "Malayalam", noto},
    {script("Sinh"), "Sinhala", noto},
    {script("Laoo"), "Lao", noto},
    {script("Khmr"), "Khmer", noto},
    {script("Mymr"), "Myanmar", noto},
    {script("Tibt"), "Tibetan", noto, no_family, "NotoSerifTibetan"},
    {script("Ethi"), "Ethiopic", noto},
    {script("Geor"), "Georgian", noto},
    {script("Armn"), "Armenian", noto},
    {script("Syrc"), "Syriac", noto, no_family, "NotoSansSyriac"},
    {script("Thaa"), "Thaana", noto},
    {script("Nkoo"), "N'Ko", noto, no_family, "NotoSansNKo"},
    {script("Hani"), "Chinese", noto_cjk, chinese},
    {script("Hira"), "Japanese", noto_cjk, chinese},
    {script("Kana"), "Japanese", noto_cjk, chinese},
    {script("Hang"), "Korean", noto_cjk, chinese},
    {script("Bopo"), "Bopomofo", noto_cjk, chinese},
}};

const ScriptRow* row_of(Script script) {
  const auto at = std::find_if(script_rows.begin(), script_rows.end(),
                               [&](const ScriptRow& row) { return row.script == script; });
  return at == script_rows.end() ? nullptr : &*at;
}

void add_if_there(const fs::path& text, const fs::path& heading, std::vector<FontFiles>& fonts) {
  if (!fs::is_regular_file(text)) return;
  const bool is_bold = fs::is_regular_file(heading);
  fonts.push_back({text, is_bold ? heading : text, !is_bold});
}

}  // namespace

FontRequest find_font(const fs::path& wanted) {
  if (!wanted.empty()) {
    if (!fs::is_regular_file(wanted))
      throw input_error({.file = wanted.string(),
                         .field = "session.font",
                         .wanted = "a TrueType font",
                         .found = "no such file"});
    return {.files = {wanted, wanted, false}};
  }
  std::vector<FontFiles> fonts;
  for (const Family& family : families) add_if_there(family.text, family.heading, fonts);
  if (!fonts.empty()) return {.files = fonts.front()};
  throw input_error({.field = "font",
                     .wanted = "DejaVu Sans (Debian: fonts-dejavu-core) or session.font in the study file",
                     .found = "neither"});
}

std::vector<FontFiles> fonts_of_script(Script script) {
  std::vector<FontFiles> fonts;
  const ScriptRow* row = row_of(script);
  if (row == nullptr) return fonts;
  const std::string name = row->noto_file != nullptr ? row->noto_file : fmt::format("NotoSans{}", row->name);
  for (const char* folder : noto_folders)
    add_if_there(fs::path(folder) / (name + "-Regular.ttf"), fs::path(folder) / (name + "-Bold.ttf"), fonts);
  if (row->other.text != nullptr)
    add_if_there(row->other.text, row->other.heading == nullptr ? "" : row->other.heading, fonts);
  return fonts;
}

ScriptFont font_to_install(Script script) {
  const ScriptRow* row = row_of(script);
  return row == nullptr ? ScriptFont{"these", noto} : ScriptFont{row->name, row->package};
}

}  // namespace seamline::inline window
