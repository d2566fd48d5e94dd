#pragma once
// sets/: a study's pictures in a folder.
//
// render_set makes a set, or goes on with one; by one process, or by many (cluster/). check.h says whether
// scenes keep the study's rules.

#include "sets/check.h"
#include "sets/render_set.h"
