#pragma once

namespace seamline::analysis {

/// With more people, what is repeated over all of them takes a shorter way, so that a million answers end in
/// a fraction of a minute (documentation/explanation/joint_model.md). The bootstrap draws this many blocks of
/// people in place of people. The spread of thresholds is that of this many people, evenly spaced over the
/// log. Simulated people have shifts from a table.
inline constexpr int many_people = 1000;

}  // namespace seamline::analysis
