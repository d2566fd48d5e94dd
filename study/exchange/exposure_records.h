#pragma once
#include "study/log/log.h"
#include "support/text/csv.h"

namespace seamline::study {

/// Adds to the table of the log's answers how many refreshes the trial's pictures stood on the screen, where
/// the study limits that (`exposure_s`): columns `exposure_frames` (wanted), `exposure_off` (the largest
/// difference of a picture) and `exposure_marked` (1: some picture differs). Empty where an answer ended the
/// exposure, and of simulated people. Throws InputError when the log cannot be read, or an event `exposure`
/// is none. The same of masks, from events `mask`.
void add_exposure_columns(const LogContents& log, CsvTable& answers);

}  // namespace seamline::study
