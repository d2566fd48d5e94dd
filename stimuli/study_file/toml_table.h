#pragma once
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

using Range = NumberRange;

}  // namespace seamline::inline stimuli
