#pragma once
// laboratory/: how well the program itself works.
//
// Error against run time, speed beside bare Embree, stiff and extreme input; and what only figures of the
// papers need.

#include "laboratory/bench/bench.h"
#include "laboratory/convergence/convergence.h"
#include "laboratory/stability/catalogue.h"
