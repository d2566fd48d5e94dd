#include "support/text/suggest.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace seamline {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_word(std::string_view typed, std::span<const std::string> known) {
  constexpr std::size_t telling_letters = 5;  // fewer are in many words
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(2, typed.size() / 2);
  for (const std::string& word : known) {
    const std::size_t distance = edit_distance(typed, word);
    if (distance < best_distance || (distance == best_distance && best.empty())) {
      best = word;
      best_distance = distance;
    }
  }
  if (best.empty() && typed.size() >= telling_letters)
    for (const std::string& word : known)
      if (word.find(typed) != std::string::npos) return word;
  return best;
}

}  // namespace seamline
