#pragma once

namespace seamline::renderer {}
namespace seamline::study {}
namespace seamline::analysis {}

/// The catalogue tries what every folder offers, so their namespaces are open in this one.
namespace seamline::stability {
using namespace renderer;
using namespace study;
using namespace analysis;
}  // namespace seamline::stability
