#pragma once
#include <string>
#include <vector>

namespace seamline::analysis {

/// The works that paragraphs of a methods text cite, by their authors' names, and the paper at last.
[[nodiscard]] std::vector<std::string> references_in(const std::vector<std::string>& paragraphs);

}  // namespace seamline::analysis
