#pragma once
#include "stimuli/definition/methods/parameter_range.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// What a study file may say of one parameter.
struct ParameterRule {
  NumberRange bounds;  ///< of every value
  Steps usual = Steps::ratios;
  bool is_rate = false;  ///< a share from 0 to 1, which may have a beta prior
};

/// The table at `key`: `least`, `most` and `count`, or `values`; `steps` and `prior`. `fallback` where there
/// is no such table, and for those of the first three that it leaves out.
[[nodiscard]] ParameterRange read_range(const TomlTable& settings, const char* key,
                                        const ParameterRange& fallback, const ParameterRule& rule);

}  // namespace seamline::inline stimuli
