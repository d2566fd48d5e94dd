#pragma once

namespace seamline::study::online {

/// Of `study.json`, `files.json` and every message of a page (documentation/how-to/online_page.md).
inline constexpr const char* web_format = "seamline-online-1";

}  // namespace seamline::study::online
