#pragma once
#include <vector>

#include "laboratory/convergence/convergence_compositing.h"
#include "laboratory/convergence/convergence_light.h"
#include "laboratory/convergence/convergence_links.h"
#include "laboratory/convergence/convergence_mesh.h"
#include "laboratory/convergence/convergence_realtime.h"
#include "laboratory/convergence/convergence_samples.h"
#include "laboratory/convergence/convergence_slope.h"
#include "laboratory/convergence/convergence_width.h"
#include "support/text/csv.h"

namespace seamline::renderer {

/// A part's numbers as they are written down.
struct PartTables {
  CsvTable table;
  std::vector<SlopeRow> slopes;
  std::vector<std::string> remarks;  ///< sentences that the table and its figure need
};

[[nodiscard]] PartTables tables_of(const SampleResult& result);
[[nodiscard]] PartTables tables_of(const MeshResult& result);
[[nodiscard]] PartTables tables_of(const std::vector<WidthRow>& rows);
[[nodiscard]] PartTables tables_of(const CompositingResult& result);
[[nodiscard]] PartTables tables_of(const std::vector<LinkRow>& rows);
[[nodiscard]] PartTables tables_of(const std::vector<RealtimeRow>& rows);
[[nodiscard]] PartTables tables_of(const LightResult& result);

[[nodiscard]] CsvTable slope_table(const std::vector<SlopeRow>& rows);

}  // namespace seamline::renderer
