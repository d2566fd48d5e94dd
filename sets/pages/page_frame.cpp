#include "sets/pages/page_frame.h"

namespace seamline::renderer {
namespace {

constexpr const char* page_style = R"css(
body { margin: 0 auto; padding: 2rem 1.5rem 4rem; max-width: 72rem; background: #fff; color: #1f2326;
  font: 16px/1.5 system-ui, "Helvetica Neue", Arial, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.8rem; margin: 0 0 .3rem; } h2 { font-size: 1.25rem; margin: 2.4rem 0 .6rem; }
p, figcaption { max-width: 48rem; } .soft, figcaption { color: #5a6268; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .92rem; }
th, td { padding: .3rem 1.1rem .3rem 0; text-align: right; vertical-align: top; }
thead th { vertical-align: bottom; }
th:first-child, td:first-child { text-align: left; } td { white-space: nowrap; }
thead th { border-bottom: 2px solid #1f2326; font-weight: 600; } tbody tr { border-bottom: 1px solid #d5d9dd; }
tfoot td { border-top: 2px solid #1f2326; font-weight: 600; }
td.above { color: #b03a00; font-weight: 600; }
figure { margin: 1rem 0 1.6rem; } figure svg { width: 100%; height: auto; max-width: 60rem; }
.scroll { overflow-x: auto; } figure img { max-width: 100%; image-rendering: pixelated; }
)css";

}  // namespace

std::string html_page(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
         "content=\"width=device-width\"><title>" +
         title + "</title><style>" + page_style + "</style></head><body>\n<h1>" + title + "</h1>\n" + body +
         "</body></html>\n";
}

}  // namespace seamline::renderer
