#include "renderer/sampling_rounds.h"

#include <algorithm>
#include <numeric>

namespace seamline {

std::vector<int> next_samples(const std::vector<TileState>& tiles, const ErrorTarget& target) {
  std::vector<int> wanted(tiles.size());
  std::vector<std::size_t> order;
  double expected = 0;
  const double wanted_square = target.rmse * target.rmse;
  const auto grow = [&](std::size_t i) {
    wanted[i] = 2 * tiles[i].spp;
    expected -= tiles[i].share * 0.5 * tiles[i].noise;
  };
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    wanted[i] = tiles[i].spp;
    expected += tiles[i].share * (tiles[i].noise + tiles[i].rest);
  }
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    if (!tiles[i].can_grow) continue;
    if (tiles[i].noise + tiles[i].rest > 9 * wanted_square)
      grow(i);
    else
      order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return tiles[a].noise * tiles[b].spp > tiles[b].noise * tiles[a].spp;
  });
  const std::size_t at_least = order.size() / 10;
  for (std::size_t i = 0; i < order.size() && (expected > wanted_square || i < at_least); ++i) {
    if (expected <= wanted_square && !(tiles[order[i]].noise > 0)) break;
    grow(order[i]);
  }
  return wanted;
}

}  // namespace seamline
