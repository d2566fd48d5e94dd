#include "live/frame/methods.h"

namespace seamline::live {

std::string_view word(Mapping mapping) {
  switch (mapping) {
    case Mapping::points:
      return "points";
    case Mapping::mesh:
      return "mesh";
  }
  return {};
}

std::string_view word(Shadows shadows) {
  switch (shadows) {
    case Shadows::none:
      return "none";
    case Shadows::traced:
      return "traced";
    case Shadows::map:
      return "map";
    case Shadows::pcf:
      return "pcf";
    case Shadows::pcss:
      return "pcss";
  }
  return {};
}

bool uses_maps(Shadows shadows) {
  switch (shadows) {
    case Shadows::none:
    case Shadows::traced:
      return false;
    case Shadows::map:
    case Shadows::pcf:
    case Shadows::pcss:
      return true;
  }
  return false;
}

bool needs_tree(const Methods& methods) {
  return methods.occlusion == Occlusion::mesh || methods.shadows == Shadows::traced;
}

}  // namespace seamline::live
