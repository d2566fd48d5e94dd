#include "live/frame/codes.h"

namespace seamline::live {

CodeTables::CodeTables() : code_(steps + 1) {
  for (std::size_t code = 0; code < linear_.size(); ++code)
    linear_[code] = linear_from_srgb(static_cast<float>(code) / 255.0F);
  for (int step = 0; step <= steps; ++step)
    code_[step] = code_from_display(srgb_from_linear(static_cast<float>(step) / static_cast<float>(steps)));
}

const CodeTables& code_tables() {
  static const CodeTables tables;
  return tables;
}

}  // namespace seamline::live
