#pragma once
// support/: text, files, numbers, stopping: what is no part of the subject.
//
// Bad input is an InputError with one sentence (text/error.h). Random numbers come from Random
// (arithmetic/random.h) and are the same on every machine. Long loops ask whether to stop
// (running/interrupt.h). A file is written whole or not at all (files/atomic_file.h).

#include "support/arithmetic/random.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/files/image.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"
