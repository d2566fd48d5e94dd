#pragma once
#include <string>

namespace seamline::inline stimuli {

/// A page of documentation with the tables of settings in their places: between a line `<!-- settings NAME
/// -->` and the next line `<!-- end -->`, whatever stands there. Throws InputError for a name that no table
/// has, and a table without its end.
[[nodiscard]] std::string with_settings_tables(const std::string& page);

}  // namespace seamline::inline stimuli
