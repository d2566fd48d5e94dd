#pragma once
#include "registration/errors/error_classes.h"
#include "support/files/image.h"
#include "support/text/csv.h"

namespace seamline::registration {

/// A row for each class, then one of all pixels: what it is drawn in, counts, shares and the median error.
[[nodiscard]] CsvTable errors_table(const ErrorClassMap& map);

/// The same for people; classes without a pixel are left out.
[[nodiscard]] std::string errors_text(const ErrorClassMap& map);

/// The photograph, darkened to a third of its codes, with the wrong pixels in the colours of their classes.
[[nodiscard]] ByteImage errors_over_photograph(const ErrorClassMap& map, const Image& photograph);

}  // namespace seamline::registration
