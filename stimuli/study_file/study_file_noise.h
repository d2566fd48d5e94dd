#pragma once
#include <optional>

#include "stimuli/definition/depth_chain.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// `noise` of a source: "none", or a table over the source's usual noise; another `model` begins anew.
/// Throws InputError for parameters without a model, and those that it does not have.
[[nodiscard]] std::optional<SourceNoise> read_noise(const TomlTable& source,
                                                    const std::optional<SourceNoise>& usual);

}  // namespace seamline::inline stimuli
