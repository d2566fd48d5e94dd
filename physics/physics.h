#pragma once
// physics/: bodies that fall and come to rest.
//
// A body, its ground, and where it rests (settle.h).

#include "physics/settle.h"
