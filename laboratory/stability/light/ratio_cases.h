#pragma once
#include "laboratory/stability/common/small_render.h"
#include "laboratory/stability/common/stability_case.h"

namespace seamline::stability {

/// A 4 x 4 picture, bright but for two pixels whose light without the object is `denominator`: in one of
/// them the object takes it away, in the other it brings 1e-3. The picture must be the photograph.
[[nodiscard]] Finding try_denominator(float denominator, const ComposeRule& rule = compose_as_product);

/// A pixel that becomes `brighter` times as bright: the ratio must stop at 4.
[[nodiscard]] Finding try_brightened(float brighter, const ComposeRule& rule = compose_as_product);

/// Where nothing changes, the picture must be the photograph to the last bit, from 1e-38 to 1e30.
[[nodiscard]] Finding try_unchanged(const ComposeRule& rule = compose_as_product);

/// All light times 2^-80 to 2^80: the ratios must be the same to the last bit.
[[nodiscard]] Finding try_exposures(const ComposeRule& rule = compose_as_product);

}  // namespace seamline::stability
