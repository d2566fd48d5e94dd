#pragma once
#include "stimuli/definition/depth_chain.h"
#include "stimuli/definition/methods/pipeline.h"
#include "stimuli/definition/quantity.h"

namespace seamline::inline stimuli {

/// Give the setting that is the level this value, by the rows of stimuli/settings; nothing where it is none
/// of theirs.
void set_level(Pipeline& pipeline, Quantity quantity, double level);
void set_level(DepthChain& chain, Quantity quantity, double level);

}  // namespace seamline::inline stimuli
