#pragma once
// registration/: depth into the photograph's camera.
//
// Cameras and poses from files or from points; measured depth brought into the pixels of the colour camera,
// by points or by a mesh; the result laid against the truth.

#include "registration/calibration/calibrate.h"
#include "registration/errors/error_classes.h"
#include "registration/files/camera_file.h"
#include "registration/mesh/register_by_mesh.h"
#include "registration/points/register_by_points.h"
