#pragma once
// composites/: objects in photographs.
//
// A CompositeRequest names a photograph, its depth, its light and the objects; make_composite writes the
// picture.

#include "composites/composite_request.h"
#include "composites/objects/photo_objects.h"
