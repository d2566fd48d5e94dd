#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "composites/objects/photo_objects.h"

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

/// Puts objects that have no place yet onto real surfaces that the picture shows (`place_in_view`), the first
/// one in its middle, others beside it; beside a steep one they keep half their width away. `half_widths_m`:
/// of each object. Returns a sentence for each that was put; where the picture shows no surface there, it
/// stays without a place.
[[nodiscard]] std::vector<std::string> stand_in_view(std::vector<PlacedModel>& objects,
                                                     const std::vector<double>& half_widths_m,
                                                     const Camera& camera, const Geometry& depth,
                                                     const Eigen::Vector3d& centre_m);

/// A file of objects as it is opened to be changed: its objects, and the light before them, as it is written.
struct OpenedObjects {
  std::vector<PlacedModel> objects;
  std::string head;
};
/// Reads what is to be changed. Throws InputError as `read_objects_file` does, and where light stands after
/// the first object: it would be lost.
[[nodiscard]] OpenedObjects open_objects(const std::filesystem::path& file,
                                         const std::filesystem::path& asset_root);

/// An object that was named on the command line, half a metre tall and without a place. Throws InputError
/// where its file is not there.
[[nodiscard]] PlacedModel new_object(const std::string& named);

/// Names the objects' files as a file of objects names them: relative to its folder what lies in or below it,
/// all else by its whole path. Returns the folder in which those others lie, for --asset-root; empty: none.
[[nodiscard]] std::filesystem::path name_for(const std::filesystem::path& objects_file,
                                             std::vector<PlacedModel>& objects);

/// Writes the file again, whole or not at all. `command`: makes the picture of it, and stands in its first
/// line as a remark, in place of the one before.
void save_objects(const std::filesystem::path& file, const std::string& head, const std::string& command,
                  const std::vector<PlacedModel>& objects);

}  // namespace seamline::renderer
