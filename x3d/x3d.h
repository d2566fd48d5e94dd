#pragma once
// x3d/: a scene as a page in X3DOM.
//
// export_x3d writes a page in which the real world hides and shadows the object.

#include "x3d/x3d_export.h"
