// The other one (see left.cpp).
#include <vector>

namespace seamline {

struct Planted {
  std::vector<int> numbers = {1, 2};
};

Planted right() {
  return {};
}

}  // namespace seamline

int main() {
  return seamline::right().numbers.size() == 2 ? 0 : 1;
}
