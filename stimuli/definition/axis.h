#pragma once

namespace seamline::inline stimuli {

/// The axis on which a psychometric function is a sigmoid: the level itself, or its log2.
enum class Axis { linear, log2 };

/// Whether the probability of a response rises or falls with the level.
enum class Direction { increasing, decreasing };

}  // namespace seamline::inline stimuli
