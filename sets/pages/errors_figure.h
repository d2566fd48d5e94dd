#pragma once
#include <optional>
#include <string>

#include "sets/set_errors.h"

namespace seamline::renderer {

/// Error against seconds, log-log, as SVG text to put into a page: one colour an artifact, estimated hollow,
/// true filled, one 8-bit step dotted. None when there is no gnuplot, or nothing to draw.
[[nodiscard]] std::optional<std::string> errors_figure(const SetErrors& errors);

}  // namespace seamline::renderer
