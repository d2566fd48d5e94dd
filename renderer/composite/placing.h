#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "renderer/composite/photo_objects.h"

namespace seamline::renderer {

/// Objects while a person puts them somewhere; what is not here has no influence on the file that is written.
struct Placing {
  std::vector<PlacedModel> objects;
  std::size_t chosen = 0;                        ///< index of one of them
  std::vector<std::vector<PlacedModel>> before;  ///< for taking back, oldest first
};

// What a person does. Lengths in metres, the composite's axes: right, up, back.

struct Chosen {
  std::size_t object = 0;
};
struct NextChosen {};
/// The chosen one stands on a place of a real surface; beside a steep one it keeps half its width away.
struct StoodOn {
  Eigen::Vector3d place_m = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::UnitY();
  double half_width_m = 0;
  bool goes_on = false;  ///< the same movement as the action before: taken back with it
};
struct Shifted {
  Eigen::Vector3d by_m = Eigen::Vector3d::Zero();
};
struct Turned {
  double yaw_deg = 0;
};
struct Resized {
  double factor = 1;
};
struct Duplicated {};
struct Removed {};  ///< the last one stays
struct TakenBack {};
using PlaceAction =
    std::variant<Chosen, NextChosen, StoodOn, Shifted, Turned, Resized, Duplicated, Removed, TakenBack>;

/// What is so after an action. Returns whether anything that the file holds changed.
bool act(Placing& placing, const PlaceAction& action);

/// "statue: 0.400 -1.300 -3.000 m, turned 25 degrees, 1.20 m tall".
[[nodiscard]] std::string placing_text(const PlacedModel& model);

/// A file of objects as it is opened to be changed: its objects, and the light before them, as it is written.
struct OpenedObjects {
  std::vector<PlacedModel> objects;
  std::string head;
};
/// Reads what is to be changed. Throws InputError as `read_objects_file` does, and where light stands after
/// the first object: it would be lost.
[[nodiscard]] OpenedObjects open_objects(const std::filesystem::path& file,
                                         const std::filesystem::path& asset_root);

/// An object that was named on the command line, as a file of objects names it: relative to that file.
/// Throws InputError where it is not there, or not below the file's folder.
[[nodiscard]] PlacedModel new_object(const std::string& named, const std::filesystem::path& objects_file);

/// Writes the file again, whole or not at all.
void save_objects(const std::filesystem::path& file, const std::string& head,
                  const std::vector<PlacedModel>& objects);

}  // namespace seamline::renderer
