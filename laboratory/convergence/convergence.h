#pragma once
#include "laboratory/convergence/convergence_subject.h"

namespace seamline::renderer {

/// Error against run time for one stimulus. Writes into the folder, part by part as each is finished:
/// PART.csv and PART.svg (with its gnuplot script), and at the end slopes.csv, data_dictionary.csv and
/// convergence.md, whose text is returned. Throws InputError for wrong input and Interrupted when the person
/// stopped it; the parts that were finished stay.
[[nodiscard]] std::string run_convergence(const StudyDefinition& study, const ConvergenceRequest& request);

}  // namespace seamline::renderer
