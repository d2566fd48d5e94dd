#pragma once
// study/: sessions, observers, log.
//
// Trials are placed (placement/), a visit is a pure state machine of screens and events (visit/), and every
// answer is in the log before the next picture (log/). Simulated people go the same way
// (running/simulation.h).

#include "study/exchange/export_tables.h"
#include "study/log/log.h"
#include "study/log/log_writer.h"
#include "study/observers/observer.h"
#include "study/running/simulation.h"
#include "study/visit/visit.h"
