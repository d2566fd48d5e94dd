#pragma once
#include <string>
#include <string_view>

#include "laboratory/stability/common/stability_case.h"

namespace seamline::stability {

/// Every case, in the order of its groups.
[[nodiscard]] const StabilityCases& stability_catalogue();

/// The cases whose name or group is `only`; all when it is empty. Throws InputError when there is none.
[[nodiscard]] StabilityCases chosen_cases(const std::string& only);

}  // namespace seamline::stability
