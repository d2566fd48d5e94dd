#pragma once
#include <vector>

#include "stimuli/definition/depth_chain.h"
#include "stimuli/definition/quantity.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// The sources that a table `depth` names: one, by the key `source` and the keys beside it, or a list of
/// tables, each with a `kind`. What it leaves out is the usual source's; another `source` or `preset` begins
/// anew. Throws InputError for keys that the kind of source has no use for.
[[nodiscard]] std::vector<DepthSource> read_sources(const TomlTable& depth,
                                                    const std::vector<DepthSource>& usual, Quantity level);

}  // namespace seamline::inline stimuli
