#pragma once

// `seamline lab`: what each file of this folder adds to it.

namespace CLI {
class App;
}

namespace seamline::laboratory {

/// Adds `seamline lab evidence`, which remakes what documentation/evidence/ holds.
void add_evidence_command(CLI::App& app);

/// `seamline lab scenes`.
void add_scenes_command(CLI::App& app);

}  // namespace seamline::laboratory

namespace seamline::renderer {

/// `seamline lab bench`.
void add_bench_command(CLI::App& app);

/// `seamline lab convergence`.
void add_convergence_command(CLI::App& app);

/// `seamline lab marker`: how far a marker is, by vision and by time of flight (paper 002, Fig. 3).
void add_marker_command(CLI::App& app);

/// Adds `seamline lab person`.
void add_person_command(CLI::App& app);

/// Adds `seamline lab field`.
void add_field_command(CLI::App& app);

}  // namespace seamline::renderer

namespace seamline::stability {

/// Adds `seamline lab stability`, which tries the product on stiff and extreme input. `any_failed` becomes
/// true when a case did not pass; it must outlive the parsing.
void add_stability_command(CLI::App& app, bool& any_failed);

}  // namespace seamline::stability
