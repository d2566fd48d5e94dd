// One of two structs of one name, for tests/odr: it must be found, or the check finds nothing.
#include <string>

namespace seamline {

struct Planted {
  std::string name = "left";
};

Planted left() {
  return {};
}

}  // namespace seamline
