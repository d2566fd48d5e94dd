#pragma once
// sensors/: depth cameras and their errors.
//
// A DepthFrame is what a camera measured, in metres, holes +infinity. A Rig is two cameras with the pose
// between them. Noise models turn what a pixel truly sees into a measurement; repairs fill and smooth a
// frame. Other people's depth files are read by sensors/files/.

#include "sensors/files/depth_file.h"
#include "sensors/frame/depth_frame.h"
#include "sensors/noise/measurement.h"
#include "sensors/repair/repair.h"
#include "sensors/rig/presets.h"
#include "sensors/rig/rig.h"
