#pragma once
// scenes/: built-in scenes.
//
// Backgrounds and objects by name, as meshes; the build writes them as glTF, and studies name them
// builtin:NAME.

#include "scenes/builtin.h"
