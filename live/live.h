#pragma once
// live/: recordings of depth and colour, at the rate of a camera.
//
// A Recording is a folder of frames; a LiveRequest says what is put into it and how.

#include "live/recording/recording.h"
#include "live/running/live_request.h"
#include "live/running/run_headless.h"
