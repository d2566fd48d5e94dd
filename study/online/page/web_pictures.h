#pragma once
#include <map>
#include <string>
#include <utility>

#include "study/online/messages/shown_names.h"
#include "study/online/page/web_files.h"
#include "study/placement/trial.h"
#include "study/trials/object_map.h"
#include "study/trials/rendered_set.h"

namespace seamline::study::online {

/// Which file of a page shows which trial.
struct WebPictures {
  std::map<std::pair<TrialKind, int>, std::string> file;  ///< by kind and stimulus
  std::map<std::string, std::string> map;                 ///< the objects' map of a picture's file
  /// Of a file that holds what a panorama differs by: the panorama that it is added to, code by code, modulo
  /// 256.
  std::map<std::string, std::string> base;
};

/// Adds every picture or clip that a trial of the set can show, and the maps of where their objects are (of a
/// clip an array of them, one a frame). Stimuli and references are copied byte for byte after their bytes
/// were compared with the manifest's; those of attention trials are made as the window makes them. Panoramas
/// are differences from their scene's reference where these are smaller. Throws InputError naming the picture
/// that is missing or changed.
[[nodiscard]] WebPictures add_pictures(const RenderedSet& set, const ShownNames& names, WebFiles& files);

/// An object map as JSON: size, frames, and `runs`: count and object by turns, row after row.
[[nodiscard]] std::string packed_map(const ObjectMap& map);

}  // namespace seamline::study::online
