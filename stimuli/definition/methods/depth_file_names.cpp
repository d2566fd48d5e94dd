#include "stimuli/definition/methods/depth_file_names.h"

#include <string_view>

namespace seamline::inline stimuli {
namespace {

constexpr std::string_view scene_in_name = "{scene}", object_in_name = "{object}";

void put_in(std::string& text, std::string_view word, const std::string& by) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + by.size()))
    text.replace(at, word.size(), by);
}

}  // namespace

bool is_named_by_stimulus(const std::string& name) {
  return name.find(scene_in_name) != std::string::npos || name.find(object_in_name) != std::string::npos;
}

std::string depth_file_name(std::string name, const std::string& scene, const std::string& object) {
  put_in(name, scene_in_name, scene);
  put_in(name, object_in_name, object);
  return name;
}

}  // namespace seamline::inline stimuli
