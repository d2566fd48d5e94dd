#pragma once
#include "window/geometry.h"

/// How the window looks: neutral greys, so that nothing tints the eye before a picture.
namespace seamline::inline window::look {

inline constexpr Colour background = grey(128);  ///< around pictures and behind every page
inline constexpr Colour ink_on_background = grey(10);
inline constexpr Colour quiet_on_background = grey(20);
inline constexpr Colour card = grey(238);
inline constexpr Colour card_edge = grey(104);
inline constexpr Colour ink = grey(28);
inline constexpr Colour quiet_ink = grey(88);
inline constexpr Colour control = grey(252);
inline constexpr Colour control_edge = grey(140);
inline constexpr Colour control_hover = grey(224);
inline constexpr Colour chosen = grey(40);  ///< a chosen option, and the button that leads on
inline constexpr Colour chosen_hover = grey(64);
inline constexpr Colour ink_on_chosen = grey(250);
inline constexpr Colour focus = {0, 0, 0, 255};  ///< ring around what the keyboard acts on
inline constexpr Colour focus_halo = {255, 255, 255, 255};
inline constexpr Colour problem = {140, 28, 20, 255};
inline constexpr Colour bracket = {255, 255, 255, 255};
inline constexpr Colour bracket_edge = {0, 0, 0, 255};

}  // namespace seamline::inline window::look
