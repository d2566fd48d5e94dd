#pragma once
#include <string>

namespace seamline::renderer {

/// A page that opens offline, without scripts: its title, already safe in HTML, as the heading, then `body`.
[[nodiscard]] std::string html_page(const std::string& title, const std::string& body);

}  // namespace seamline::renderer
